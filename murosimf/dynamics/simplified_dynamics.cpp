#include "murosimf/dynamics/simplified_dynamics.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/free_state.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/dynamics/rigid_lanes.h"
#include "murosimf/dynamics/sanity.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/fixed_base.h"
#include "murosimf/multibody/kinematics.h"

namespace murosimf::dynamics {

SimplifiedDynamics::SimplifiedDynamics(Setup& setup, const SimplifiedDynamicsOptions& options)
    : entity_(setup.entity()),
      options_(options),
      fixed_(has_fixed_base(setup.model())),
      period_(seconds(setup.period())),
      gravity_(setup.world().gravity),
      columns_(setup),
      reference_(setup, options.reference),
      external_force_(setup.write(properties::external_force)),
      external_damping_(setup.write(properties::external_damping)),
      separation_(setup.input(properties::separation, {})[0]),
      contacts_(setup),
      center_(setup.write(properties::common_center_of_mass)[0]),
      velocity_(setup.write(properties::common_center_of_mass_velocity)[0]),
      inertia_(setup.write(properties::common_inertia)[0]),
      mass_(setup.write(properties::total_mass)[0]),
      dynamic_(setup.write(properties::dynamic)[0]) {
  if (!(setup.model().tree().mass > 0)) {
    throw SetupError(fmt::format("model '{}' has no mass; simplified_dynamics needs it", setup.model().name()));
  }
}

void SimplifiedDynamics::initialize() {
  reference_.initialize(columns_);
  place_at_start(columns_, entity_);
  columns_.update_velocities();
  store_common_body(
      multibody::common_body<double>(columns_.model.tree(), columns_.r, columns_.R, columns_.v, columns_.w));
  velocity_ = {};
  dynamic_ = 1;
  columns_.remember_base();
  std::fill(external_force_.begin(), external_force_.end(), Wrenchd{});
  std::fill(external_damping_.begin(), external_damping_.end(), Sym6d{});
  check();
  contacts_.answer_by(this);
}

void SimplifiedDynamics::check() const {
  reference_.check(options_.integrator);
  contacts_.check(options_.integrator, period_);
  if (fixed_ || is_positive_definite(inertia_)) return;
  throw SetupError(
      fmt::format("model '{}' has no inertia about some axis; give its masses an inertia", columns_.model.name()));
}

Momentum SimplifiedDynamics::hand_over() noexcept {
  contacts_.answer_by(nullptr);
  return {mass_ * velocity_, inertia_ * columns_.w[0]};
}

void SimplifiedDynamics::take_over(const Momentum& momentum) {
  const auto common_body = [&] {
    return multibody::common_body<double>(columns_.model.tree(), columns_.r, columns_.R, columns_.v, columns_.w);
  };
  store_common_body(common_body());
  check();
  reference_.take_over(columns_);
  if (fixed_) {
    follow_fixed_base();
  } else {
    // the angular momentum of limbs counts as that of the whole body
    columns_.w[0] = inverse(inertia_) * momentum.angular;
    columns_.update_velocities();
    velocity_ = (1 / mass_) * momentum.linear;
    multibody::shift_all(columns_.v, velocity_ - common_body().velocity);
  }
  dynamic_ = 1;
  columns_.remember_base();
  contacts_.answer_by(this);
}

bool SimplifiedDynamics::goes_with(const Algorithm& other) const {
  const auto* same = dynamic_cast<const SimplifiedDynamics*>(&other);
  const auto keeps_center = [](const SimplifiedDynamicsOptions& options) {
    return options.integrator == Integrator::semi_implicit_euler && !options.base_rigid;
  };
  return same && !fixed_ && &columns_.model == &same->columns_.model && keeps_center(options_) &&
         keeps_center(same->options_);
}

std::unique_ptr<LaneGroup> SimplifiedDynamics::join(std::span<Algorithm* const> members) const {
  MUROSIMF_ASSERT(!members.empty() && members.size() <= Pack8::lanes);
  return std::make_unique<RigidLanes>(members_of<SimplifiedDynamics>(members));
}

void SimplifiedDynamics::step(const Instant& instant) noexcept {
  if (fixed_) return step_fixed(seconds(instant.period));
  if (options_.integrator == Integrator::rk4 && !contacts_.solved()) return step_rk4(seconds(instant.period));
  const Course course = find_course(instant);
  if (!course.sane) return;
  const Mat3d R_before = columns_.R[0];
  turn(course.body);
  if (options_.base_rigid) {
    columns_.w[0] = course.body.rate;
    follow_base(course.body, R_before);
  } else {
    follow_center(course.body, course.angular_momentum);
  }
  columns_.remember_base();
}

void SimplifiedDynamics::step_fixed(double dt) noexcept {
  MUROSIMF_ASSERT(dt > 0);
  if (!contacts_.solved()) {
    begin_step(dt);
    contacts_.settle([&] {
      solve(dt_);
      predict_contacts();
      return true;
    });
  }
  if (!reference_.advance(columns_, dt_)) return halt(joints_insane);
  contacts_.commit();
  follow_fixed_base();
  contacts_.renew();
  columns_.remember_base();
}

SimplifiedDynamics::Course SimplifiedDynamics::find_course(const Instant& instant) noexcept {
  if (!contacts_.solved()) {
    pushed_in_island_ = false;
    begin_step(seconds(instant.period));
    contacts_.settle([&] {
      solve(dt_);
      predict_contacts();
      return true;
    });
  }
  MUROSIMF_ASSERT(dt_ > 0);
  multibody::FreeBody<double> body{center_ + separation_, velocity_, columns_.Q[0], columns_.w[0]};
  Vec3d angular_momentum = inertia_ * columns_.w[0] + dt_ * outer_moment();
  multibody::advance(body, acceleration_, dt_);
  if (!is_sane(body)) {
    halt(too_fast);
    return {};
  }
  if (!reference_.advance(columns_, dt_)) {
    halt(joints_insane);
    return {};
  }
  contacts_.commit();
  if (!options_.base_rigid && !pushed_in_island_ && in_flight()) {
    // as in moving_tree.h: the rate in the middle of the step keeps the energy of a tumbling body
    const Vec3d middle_rate = columns_.w[0] + (0.5 * dt_) * acceleration_.w;
    body.turn = normalized(exponential(dt_ * middle_rate) * columns_.Q[0]);
  } else {
    // contacts were solved for this rate: only the joints' motion changes it
    const SymMat3d turned = rotated(to_matrix(body.turn) * transpose(columns_.R[0]), inertia_);
    angular_momentum = turned * body.rate;
  }
  contacts_.renew();
  return {body, angular_momentum, true};
}

void SimplifiedDynamics::turn(const multibody::FreeBody<double>& body) noexcept {
  columns_.Q[0] = body.turn;
  columns_.R[0] = to_matrix(body.turn);
}

void SimplifiedDynamics::step_rk4(double dt) noexcept {
  MUROSIMF_ASSERT(dt > 0);
  begin_step(dt);
  if (!reference_.is_sane(columns_)) return halt(joints_insane);
  reference_.fade_offsets(dt);
  // the row has the angular momentum in the place of the angular velocity
  write_state({center_, velocity_, columns_.Q[0], inertia_ * columns_.w[0]}, columns_, row_);
  const auto place = [&](const multibody::FreeBody<double>& body) {
    turn(body);
    follow_center(body, body.rate);
  };
  bool first = true;
  const std::vector<double> start = row_;  // the state to return to if a number is not sane
  runge_kutta_.step(row_, dt, [&](const std::vector<double>& y, std::vector<double>& dy) {
    auto body = read_state(y, columns_);
    place(body);
    body.rate = columns_.w[0];
    solve(0);
    if (std::exchange(first, false)) {
      predict_contacts();
      contacts_.commit();
    }
    write_rate(
        body, {outer_moment(), acceleration_.v}, columns_,
        [&](int joint) { return reference_.acceleration(columns_, joint); }, dy);
  });
  const bool sane = is_sane_state(row_);
  auto end = read_state(sane ? row_ : start, columns_);
  end.position += separation_;
  reference_.stop_at_limits(columns_);
  place(end);
  columns_.remember_base();
  // after the poses are back at the last sane state
  if (!sane) return halt(too_fast);
}

void SimplifiedDynamics::begin_step(double dt) noexcept {
  MUROSIMF_ASSERT(dt > 0);
  dt_ = dt;
  center_ += columns_.take_displacement();
  // differences are exactly 0 unless a user has written the base's columns
  velocity_ += columns_.take_velocity_change();
}

void SimplifiedDynamics::solve(double dt) noexcept {
  MUROSIMF_ASSERT(dt >= 0);
  if (fixed_) {
    acceleration_ = {};
    return;
  }
  const Vec3d& w = columns_.w[0];
  Wrenchd force{-cross(w, inertia_ * w), mass_ * gravity_};
  Sym6d matrix{inertia_, {Vec3d{}, Vec3d{}, Vec3d{}}, diagonal(mass_)};
  for (const int object : columns_.model.bodies()) {
    // most bodies are untouched: comparing with zero is cheaper than moving a load
    if (!is_zero(external_force_[object])) force += moved(external_force_[object], center_ - columns_.r[object]);
    if (!is_zero(external_damping_[object]))
      matrix += dt * moved(external_damping_[object], center_ - columns_.r[object]);
  }
  matrix_ = matrix;
  acceleration_ = murosimf::solve(matrix, force);
}

Vec3d SimplifiedDynamics::next_velocity(const Vec3d& point, const Vec3d& velocity) const noexcept {
  return velocity + dt_ * (acceleration_.v + cross(acceleration_.w, point - center_));
}

void SimplifiedDynamics::predict_contacts() noexcept {
  contacts_.predict([&](const collision::ContactPoint& c) { return next_velocity(c.point, c.velocity); });
}

bool SimplifiedDynamics::free_pass(double dt) noexcept {
  pushed_in_island_ = false;
  begin_step(dt);
  solve(dt);
  if (!fixed_) factor_.emplace(matrix_);  // for the responses to impulses of the island
  // checked before others rely on the answers of this entity
  return reference_.is_sane(columns_) && is_sane(acceleration_, dt);
}

Vec3d SimplifiedDynamics::free_velocity(int, const Vec3d& point, const Vec3d& velocity) const noexcept {
  return next_velocity(point, velocity);
}

void SimplifiedDynamics::respond(int, const Vec3d& point, const Mat3d& directions,
                                 collision::ResponseRows& y) const noexcept {
  if (fixed_) return;
  MUROSIMF_ASSERT(factor_);
  collision::add_rigid_response(*factor_, collision::unit_forces(point - center_, directions), y);
}

void SimplifiedDynamics::apply(std::span<const double> z) noexcept {
  if (fixed_) return;
  MUROSIMF_ASSERT(factor_ && z.size() >= 6 && dt_ > 0);
  pushed_in_island_ = std::any_of(z.begin(), z.end(), [](double number) { return number != 0; });
  acceleration_ += (1 / dt_) * factor_->backward({z[0], z[1], z[2], z[3], z[4], z[5]});
}

Vec3d SimplifiedDynamics::outer_moment() const noexcept {
  const Vec3d& w = columns_.w[0];
  return inertia_ * acceleration_.w + cross(w, inertia_ * w);
}

bool SimplifiedDynamics::in_flight() const noexcept {
  return contacts_.none() &&
         std::all_of(external_damping_.begin(), external_damping_.end(), [](const Sym6d& d) { return is_zero(d); });
}

void SimplifiedDynamics::follow_center(const multibody::FreeBody<double>& body,
                                       const Vec3d& angular_momentum) noexcept {
  // everything relative to a base at rest at the origin; the base's position then follows from that of the center of mass
  columns_.r[0] = columns_.v[0] = columns_.w[0] = {};
  columns_.update_poses();
  columns_.update_velocities();
  auto common = multibody::common_body<double>(columns_.model.tree(), columns_.r, columns_.R, columns_.v, columns_.w);
  const Vec3d w = inverse(common.inertia) * angular_momentum;
  const auto& objects = columns_.model.objects();
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (objects[i].structural) continue;  // its rows hold no numbers
    const Vec3d arm = columns_.r[i] - common.center;
    columns_.r[i] = body.position + arm;
    columns_.v[i] += body.velocity - common.velocity + cross(w, arm);
    columns_.w[i] += w;
  }
  common.center = body.position;
  common.velocity = body.velocity;
  store_common_body(common);
}

void SimplifiedDynamics::follow_base(const multibody::FreeBody<double>& body, const Mat3d& R_before) noexcept {
  const Vec3d arm = columns_.R[0] * transposed_times(R_before, columns_.r[0] - center_);
  columns_.r[0] = body.position + arm;
  columns_.v[0] = body.velocity + cross(body.rate, arm);
  columns_.update_poses();
  columns_.update_velocities();
  auto common = multibody::common_body<double>(columns_.model.tree(), columns_.r, columns_.R, columns_.v, columns_.w);
  // the rigid body's velocity at the new center: joint rates do not count
  common.velocity = columns_.v[0] + cross(body.rate, common.center - columns_.r[0]);
  store_common_body(common);
}

void SimplifiedDynamics::follow_fixed_base() noexcept {
  columns_.v[0] = columns_.w[0] = {};
  columns_.update_poses();
  columns_.update_velocities();
  store_common_body(
      multibody::common_body<double>(columns_.model.tree(), columns_.r, columns_.R, columns_.v, columns_.w));
}

void SimplifiedDynamics::store_common_body(const multibody::CommonBody<double>& common) noexcept {
  MUROSIMF_ASSERT(common.mass > 0);
  mass_ = common.mass;
  center_ = common.center;
  velocity_ = common.velocity;
  inertia_ = common.inertia;
}

void SimplifiedDynamics::halt(const char* reason) noexcept {
  columns_.stop();
  velocity_ = {};
  dynamic_ = 0;
  entity_.freeze(reason);
}

}  // namespace murosimf::dynamics
