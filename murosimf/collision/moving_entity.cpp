#include "murosimf/collision/moving_entity.h"

#include <algorithm>

#include "murosimf/collision/contact_laws/impulse_response.h"
#include "murosimf/collision/contact_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/feet.h"
#include "murosimf/model/properties.h"

namespace murosimf::collision {

namespace {

// [m] A tree is then valid for several steps, and so are the pairs of shapes that it found near each other.
constexpr double margin = 0.008;

std::vector<int> find_feet(const Model& model, const Compound& compound) {
  std::vector<int> feet;
  for (const Foot& foot : feet_of(model)) {
    for (std::size_t i = 0; i < compound.shapes().size(); ++i) {
      if (belongs_to(model, foot, compound.shapes()[i].object)) feet.push_back(static_cast<int>(i));
    }
  }
  return feet;
}

std::span<const double> step_ratio_of(Setup& setup) {
  const int step_multiple = setup.entity().options().step_multiple;
  return step_multiple > 1 ? setup.input(properties::step_ratio, step_multiple) : std::span<const double>{};
}

Compound make_compound(const Entity& entity) {
  const CollisionOptions& options = entity.options().collision;
  return compound_of(
      entity, {.volume = options.volume, .inner = options.self_collision, .excluded = options.never, .margin = margin});
}

}  // namespace

MovingEntity::MovingEntity(Setup setup)
    : entity(&setup.entity()),
      number(setup.world().index_of(entity)),
      compound(make_compound(setup.entity())),
      feet(find_feet(setup.model(), compound)),
      r(setup.read(properties::position)),
      v(setup.read(properties::linear_velocity)),
      w(setup.read(properties::angular_velocity)),
      R(setup.read(properties::orientation)),
      dynamic(setup.read(properties::dynamic)),
      step_ratio(step_ratio_of(setup)),
      interaction_force(setup.write(properties::interaction_force)),
      external_force(setup.write(properties::external_force)),
      external_damping(setup.write(properties::external_damping)),
      ledger(setup.write(properties::absorbed_impulse)),
      separation(setup.write(properties::separation)),
      contacts(setup.write(collision::contacts)[0]),
      interface(setup.write(contact_interface)[0]) {
  MUROSIMF_ASSERT(r.size() == R.size() && v.size() == r.size() && w.size() == r.size());
  take_sizes();
  pushed_.reserve(static_cast<std::size_t>(setup.model().size()));
  setup.claim();  // levels make their free pass for the island solver
}

void MovingEntity::take_sizes() {
  poses_.assign(compound.shapes().size(), {});
  radii_.clear();
  thicknesses_.clear();
  for (const CollidingShape& shape : compound.shapes()) {
    radii_.push_back(bounding_radius(shape.placed.shape));
    thicknesses_.push_back(collision::thickness(shape.placed.shape));
  }
}

void MovingEntity::take_shapes() {
  compound = make_compound(*entity);
  feet = find_feet(model(), compound);
  is_near_statics = {};
  fits_ = 0;
  refitted_ = false;
  take_sizes();
}

bool MovingEntity::limbs_can_touch() const {
  // six coordinates are those of a rigid body
  return !compound.inner_pairs().off() && can_be_pushed() && interface.response &&
         interface.response->coordinates() > 6;
}

void MovingEntity::refit() noexcept {
  if (refitted_) return;
  refitted_ = true;
  if (fits_ > 0 && compound.still_fits(r, R)) return;
  compound.refit(r, R);
  ++fits_;
}

geometry::BoundingSphere MovingEntity::sphere(int shape) const noexcept {
  MUROSIMF_ASSERT(shape >= 0 && static_cast<std::size_t>(shape) < radii_.size());
  const CollidingShape& s = compound.shapes()[shape];
  return {r[s.object] + R[s.object] * s.placed.position, radii_[shape]};
}

const Transformd& MovingEntity::pose(int shape) noexcept {
  MUROSIMF_ASSERT(shape >= 0 && static_cast<std::size_t>(shape) < poses_.size());
  auto& [step, pose] = poses_[shape];
  if (step != step_) pose = compound.pose(shape, r, R);  // computed at the first request of a step
  step = step_;
  return pose;
}

void MovingEntity::start_step() noexcept {
  refitted_ = false;
  ++step_;
  for (const int object : pushed_) {
    interaction_force[object] = Wrenchd{};
    if (interface.law) continue;
    // no ground contact resets these in every step
    external_force[object] = Wrenchd{};
    external_damping[object] = Sym6d{};
  }
  pushed_.clear();
}

void MovingEntity::push(int object, const Vec3d& point, const Vec3d& force, double dt) noexcept {
  MUROSIMF_ASSERT(dt > 0);
  if (!can_be_pushed()) {
    ledger[0] += Wrenchd{cross(point, dt * force), dt * force};
    return;
  }
  add(object, {cross(point - r[object], force), force});
}

void MovingEntity::turn(int object, const Vec3d& moment, double dt) noexcept {
  if (can_be_pushed()) return add(object, {moment, {}});
  ledger[0].n += dt * moment;
}

void MovingEntity::add(int object, const Wrenchd& at_origin) noexcept {
  MUROSIMF_ASSERT(object >= 0 && static_cast<std::size_t>(object) < interaction_force.size());
  interaction_force[object] += at_origin;
  external_force[object] += at_origin;
  if (interface.law) contacts.rest_force[object] += at_origin;
  if (std::find(pushed_.begin(), pushed_.end(), object) == pushed_.end()) pushed_.push_back(object);
}

void MovingEntity::damp(int object, const Vec3d& point, const SymMat3d& damping) noexcept {
  MUROSIMF_ASSERT(object >= 0 && static_cast<std::size_t>(object) < external_damping.size());
  const Sym6d at_origin = at_point(damping, point - r[object]);
  external_damping[object] += at_origin;
  if (interface.law) contacts.rest_damping.push_back({object, at_origin});
}

}  // namespace murosimf::collision
