#include "murosimf/dynamics/full_dynamics.h"

#include <algorithm>
#include <utility>

#include "murosimf/dynamics/full_lanes.h"
#include "murosimf/math/assert.h"
#include "murosimf/multibody/inverse_dynamics.h"

namespace murosimf::dynamics {

FullDynamics::FullDynamics(Setup& setup, const FullDynamicsOptions& options)
    : tree_(setup, options.tree, "full_dynamics"),
      reference_(setup, options.reference),
      watch_(setup),
      joint_torque_(setup.write(properties::joint_torque)),
      old_rate_(static_cast<std::size_t>(setup.model().size())),
      joint_acceleration_(tree_.links.size()),
      joint_motion_(tree_.links.size()),
      link_force_(tree_.links.size()),
      has_servo_(old_rate_.size()) {
  MUROSIMF_ASSERT(!tree_.links.empty());
  reference_.know_torques(watch_.need());
  for (const int i : setup.model().having(properties::servo)) has_servo_[i] = true;
  for (const Link& link : setup.model().tree().links) {
    rotor_.push_back(rotor_inertia(setup.model(), link.object));
    passive_.push_back(passive_joint(setup.model(), link.object));
  }
}

void FullDynamics::initialize() {
  reference_.check(tree_.integrator());
  reference_.initialize(tree_.columns);
  tree_.start();
  start_observing();
  tree_.contacts.answer_by(this);
}

void FullDynamics::take_over(const Momentum& momentum) {
  reference_.check(tree_.integrator());
  reference_.take_over(tree_.columns);
  tree_.take_over(momentum);
  start_observing();
  tree_.contacts.answer_by(this);
}

bool FullDynamics::goes_with(const Algorithm& other) const {
  const auto* same = dynamic_cast<const FullDynamics*>(&other);
  return same && tree_.goes_with(same->tree_);
}

std::unique_ptr<LaneGroup> FullDynamics::join(std::span<Algorithm* const> members) const {
  MUROSIMF_ASSERT(!members.empty() && members.size() <= Pack8::lanes);
  return std::make_unique<FullLanes>(members_of<FullDynamics>(members));
}

void FullDynamics::start_observing() noexcept {
  watch_.initialize();
  std::fill(joint_torque_.begin(), joint_torque_.end(), 0.0);
}

void FullDynamics::step(const Instant& instant) noexcept {
  if (tree_.integrator() == Integrator::rk4 && !tree_.contacts.solved()) return step_rk4(instant);
  if (!tree_.contacts.solved()) {
    begin_step(seconds(instant.period));
    tree_.contacts.settle([&] {
      solve_base(dt_);
      predict_contacts(dt_);
      return true;
    });
  }
  end_step(instant);
}

/// Ends a step whose accelerations are known.
void FullDynamics::end_step(const Instant& instant) noexcept {
  if (!joints_sane_) return tree_.halt(joints_insane);
  MUROSIMF_ASSERT(dt_ > 0);
  find_torques(instant);  // reads the poses at the beginning of the step: before the base moves
  tree_.contacts.commit();
  if (!tree_.advance_base(base_, dt_)) return tree_.halt(too_fast);
  tree_.finish_step();
}

void FullDynamics::step_rk4(const Instant& instant) noexcept {
  MUROSIMF_ASSERT(instant.period > Duration{});
  tree_.take_changes();
  if (!reference_.is_sane(tree_.columns)) return tree_.halt(joints_insane);
  reference_.fade_offsets(seconds(instant.period));
  bool first = true;
  const auto accelerations = [&] {
    const auto& links = tree_.columns.model.tree().links;
    for (std::size_t l = 1; l < links.size(); ++l) {
      joint_acceleration_[l] = reference_.acceleration(tree_.columns, links[l].object);
    }
    prepare_base();
    solve_base(0);
    if (std::exchange(first, false)) {
      // contacts are explicit: the forces of the first stage hold during the whole step
      predict_contacts(seconds(instant.period));
      find_torques(instant);
      tree_.contacts.commit();
    }
    return base_;
  };
  std::copy(tree_.columns.qd.begin(), tree_.columns.qd.end(), old_rate_.begin());
  const auto joint_acceleration = [&](int joint) { return reference_.acceleration(tree_.columns, joint); };
  if (!tree_.advance_rk4(seconds(instant.period), accelerations, joint_acceleration)) {
    return tree_.halt(too_fast);
  }
  reference_.stop_at_limits(tree_.columns);
  tree_.finish_step();
}

void FullDynamics::predict_contacts(double dt) noexcept {
  tree_.predict_contacts(dt, [&](int link) { return base_ + joint_motion_[link]; });
}

void FullDynamics::begin_step(double dt) noexcept {
  MUROSIMF_ASSERT(dt > 0);
  dt_ = dt;
  tree_.take_changes();
  joints_sane_ = advance_joints(dt);
  prepare_base();
}

bool FullDynamics::free_pass(double dt) noexcept {
  begin_step(dt);
  solve_base(dt);
  tree_.factor_base();
  return joints_sane_ && is_sane(base_, dt);
}

Vec3d FullDynamics::free_velocity(int object, const Vec3d& point, const Vec3d& velocity) const noexcept {
  const int link = tree_.columns.model.tree().link_of[object];
  return tree_.next_velocity(object, point, velocity, base_ + joint_motion_[link], dt_);
}

/// Joints follow their reference whatever forces act: only the base responds.
void FullDynamics::respond(int, const Vec3d& point, const Mat3d& directions,
                           collision::ResponseRows& y) const noexcept {
  tree_.respond_at_base(tree_.forces_about_base(point, directions), y);
}

void FullDynamics::apply(std::span<const double> z) noexcept {
  MUROSIMF_ASSERT(z.size() >= 6 && dt_ > 0);
  base_ += tree_.base_change(z, dt_);
}

bool FullDynamics::advance_joints(double dt) noexcept {
  MUROSIMF_ASSERT(dt > 0 && old_rate_.size() == tree_.columns.qd.size());
  PoseColumns& columns = tree_.columns;
  std::copy(columns.qd.begin(), columns.qd.end(), old_rate_.begin());
  if (!reference_.advance(columns, dt)) return false;
  const auto& links = columns.model.tree().links;
  for (std::size_t l = 1; l < links.size(); ++l) {
    const int i = links[l].object;
    // what the reference has done, not what it intended: limits and ends of ranges change rates
    joint_acceleration_[l] = (columns.qd[i] - old_rate_[i]) / dt;
  }
  return true;
}

void FullDynamics::prepare_base() noexcept {
  bias_ = multibody::base_bias<double>(tree_.columns.model.tree(), tree_.links, joint_acceleration_, joint_motion_);
}

void FullDynamics::solve_base(double dt) noexcept {
  Sym6d inertia = to_sym6(tree_.composite_inertia());
  Wrenchd force = -1.0 * bias_;
  tree_.for_loads(dt, [&](int link, const Wrenchd& load, const Sym6d& damping) {
    inertia += damping;
    force += load - damping * joint_motion_[link];
  });
  base_ = tree_.base_acceleration(inertia, force);
}

void FullDynamics::find_torques(const Instant& instant) noexcept {
  const auto& links = tree_.columns.model.tree().links;
  MUROSIMF_ASSERT(link_force_.size() == tree_.columns.model.tree().links.size());
  for (std::size_t l = 0; l < links.size(); ++l) {
    link_force_[l] = tree_.links[l].inertia * (base_ + joint_motion_[l]) + tree_.links[l].bias_force;
  }
  tree_.for_loads(seconds(instant.period), [&](int link, const Wrenchd& load, const Sym6d& damping) {
    link_force_[link] += damping * (base_ + joint_motion_[link]) - load;
  });
  // children before parents: link_force_ then holds the whole load of the joint
  for (std::size_t l = links.size() - 1; l > 0; --l) {
    const int i = links[l].object;
    joint_torque_[i] = dot(tree_.links[l].axis, link_force_[l]) + rotor_[l] * joint_acceleration_[l] -
                       passive_[l].torque(tree_.columns.q[i], tree_.columns.qd[i]);
    link_force_[links[l].parent] += link_force_[l];
  }
  watch_torques(instant);
}

void FullDynamics::watch_torques(const Instant& instant) noexcept {
  load_leaders();
  watch_.look(instant, joint_torque_, old_rate_);
}

/// Adds the torque of a coupled joint without servo to that of its leader.
void FullDynamics::load_leaders() noexcept {
  for (const auto& pair : reference_.coupled().pairs()) {
    if (has_servo_[pair.follower]) continue;
    MUROSIMF_ASSERT(pair.leader != pair.follower);
    joint_torque_[pair.leader] += pair.ratio * joint_torque_[pair.follower];
    joint_torque_[pair.follower] = 0;
  }
}

}  // namespace murosimf::dynamics
