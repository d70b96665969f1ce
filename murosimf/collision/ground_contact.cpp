#include "murosimf/collision/ground_contact.h"

#include <algorithm>

#include "murosimf/collision/contact_parameters.h"
#include "murosimf/model/properties.h"

namespace murosimf::collision {
namespace {

/// `v` in the plane across the unit vector `normal`, with length 1; zero if it has no direction there.
Vec3d direction_in_plane(const Vec3d& v, const Vec3d& normal) {
  const Vec3d inside = tangential(v, normal);
  const double size = norm(inside);
  return size > 1e-9 * norm(v) ? (1.0 / size) * inside : Vec3d{};
}

}  // namespace

std::vector<GroundPlane> ground_planes(const Entity* environment) {
  std::vector<GroundPlane> planes;
  if (!environment) return planes;
  const Model& model = environment->model();
  for (const int object : model.bodies()) {
    const Shapes* shapes = model.find(properties::shapes, object);
    if (!shapes) continue;
    const FixedObject place = model.placement(object);
    for (const PlacedShape& placed : *shapes) {
      if (!std::holds_alternative<Plane>(placed.shape)) continue;
      const Mat3d R = place.turn * placed.orientation;
      const double height = dot(R.z, place.offset + place.turn * placed.position);
      planes.push_back({R.z, height, direction_in_plane(R * placed.surface.grain, R.z), placed.surface});
    }
  }
  return planes;
}

GroundContact::GroundContact(Setup& setup, const Entity* environment, std::shared_ptr<const ContactLaw> law,
                             const MaterialTable& materials)
    : model_(setup.model()),
      law_(std::move(law)),
      shapes_(ground_shapes(setup.model())),
      planes_(ground_planes(environment)),
      statics_(setup.entity(), environment),
      gravity_(norm(setup.world().gravity)),
      period_(seconds(setup.period())),
      r_(setup.read(properties::position)),
      R_(setup.read(properties::orientation)),
      v_(setup.read(properties::linear_velocity)),
      w_(setup.read(properties::angular_velocity)),
      applied_force_(setup.input(properties::applied_force, {})),
      external_force_(setup.write(properties::external_force)),
      external_damping_(setup.write(properties::external_damping)),
      set_(setup.write(contacts)[0]) {
  // constants of plane p and shape s stand at p * shapes + s, then those of the static shapes in the same way
  for (const GroundPlane& plane : planes_) {
    for (const GroundShape& shape : shapes_)
      add_parameters(shape.placed.surface, plane.surface, plane.grain, materials);
  }
  for (const CollidingShape& other : statics_.environment().shapes()) {
    for (const CollidingShape& shape : statics_.own().shapes()) {
      add_parameters(shape.placed.surface, other.placed.surface, {}, materials);
    }
  }
}

void GroundContact::add_parameters(const Surface& own, const Surface& other, const Vec3d& grain,
                                   const MaterialTable& materials) {
  const PairSurface pair = materials.find(own, other);
  parameters_.push_back(contact_parameters(model_, pair, gravity_, period_));
  parameters_.back().grain = pair.grain_effect * grain;
}

void GroundContact::initialize() {
  set_ = ContactSet{};
  set_.law = law_.get();
  set_.dt = period_;
  set_.parameters = parameters_;
  set_.rest_force.resize(static_cast<std::size_t>(model_.size()));
  const std::size_t most = 8 * shapes_.size() * planes_.size();
  set_.points.reserve(most);
  set_.previous.reserve(most);
  set_.next_velocity.reserve(most);
  set_.loaded.reserve(most);
  std::fill(external_force_.begin(), external_force_.end(), Forced{});
  std::fill(external_damping_.begin(), external_damping_.end(), Sym6d{});
}

void GroundContact::step(const Instant&) noexcept {
  for (const int object : set_.loaded) external_damping_[object] = Sym6d{};
  for (const auto& [object, damping] : set_.rest_damping) external_damping_[object] = Sym6d{};
  set_.rest_damping.clear();
  for (const int object : model_.bodies()) {
    external_force_[object] = set_.rest_force[object] = applied_force_[object];
  }
  find_contacts();
  remember();
  set_.law->prepare(set_);
  set_.loaded.clear();
  for (const ContactPoint& c : set_.points) {
    if (std::find(set_.loaded.begin(), set_.loaded.end(), c.object) == set_.loaded.end())
      set_.loaded.push_back(c.object);
  }
  write_loads(set_, r_, external_force_, external_damping_);
}

void GroundContact::find_contacts() {
  set_.previous.swap(set_.points);
  set_.points.clear();
  set_.tests = {};
  std::uint32_t surface = 0;
  std::uint64_t feature = 0;
  for (const GroundPlane& plane : planes_) {
    for (const GroundShape& shape : shapes_) {
      const std::size_t first = set_.points.size();
      ++set_.tests.volumes;
      find_ground_contacts(shape, r_[shape.object], R_[shape.object], plane, set_.points);
      for (std::size_t i = first; i < set_.points.size(); ++i) {
        set_.points[i].surface = surface;
        set_.points[i].feature += feature;
      }
      if (set_.points.size() > first) ++set_.tests.objects;
      ++surface;
    }
    if (!shapes_.empty()) feature += shapes_.back().first_feature + features_of(shapes_.back().placed.shape);
  }
  statics_.find(r_, R_, feature, surface, set_.points, set_.tests);
  for (ContactPoint& c : set_.points) {
    c.velocity = v_[c.object] + cross(w_[c.object], c.point - r_[c.object]);
    c.angular_velocity = w_[c.object];
  }
}

void GroundContact::remember() {
  auto old = set_.previous.begin();
  for (ContactPoint& c : set_.points) {
    while (old != set_.previous.end() && old->feature < c.feature) ++old;
    if (old == set_.previous.end() || old->feature != c.feature) continue;
    recall(*old, c);
  }
}

}  // namespace murosimf::collision
