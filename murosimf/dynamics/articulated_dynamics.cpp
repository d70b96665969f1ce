#include "murosimf/dynamics/articulated_dynamics.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/math/assert.h"

namespace murosimf::dynamics {

ArticulatedDynamics::ArticulatedDynamics(Setup& setup, const MovingTreeOptions& options, const std::string& servo_law)
    : tree_(setup, options, "articulated_dynamics"),
      servo_law_(servo_law),
      drives_(setup, servo_law),
      couplings_(setup),
      joint_torque_(setup.write(properties::joint_torque)),
      motor_torque_(setup.write_if_wanted(properties::motor_torque)),
      joint_load_(setup.write(properties::joint_load)),
      felt_acceleration_(setup.write(properties::felt_acceleration)),
      saturation_(setup),
      viscous_(tree_.links.size()),
      friction_(tree_.links.size()),
      bodies_(tree_.links.size()),
      change_(tree_.links.size()),
      root_(tree_.links.size()) {
  if (options.integrator == Integrator::rk4 && !drives_.remembering().empty()) {
    throw SetupError("integrator 'rk4' does not go with servos that have backlash or get warm");
  }
  if (options.integrator == Integrator::rk4 && !couplings_.empty()) {
    throw SetupError(
        "integrator 'rk4' does not go with coupled joints and loops: what holds them is stiffer than its steps allow");
  }
}

void ArticulatedDynamics::initialize() {
  drives_.initialize(tree_.columns.q, tree_.columns.qd);
  couplings_.assemble(tree_.columns);
  tree_.start();
  start_loads();
  check_inertias();
  tree_.contacts.answer_by(this);
}

void ArticulatedDynamics::take_over(const Momentum& momentum) {
  drives_.take_over(tree_.columns.qd);
  tree_.take_over(momentum);
  start_loads();
  check_inertias();
  tree_.contacts.answer_by(this);
}

/// Initial loads: of a robot at rest whose joints carry nothing, so friction expects every joint to stick.
void ArticulatedDynamics::start_loads() {
  couplings_.start();
  saturation_.initialize();
  std::fill(joint_torque_.begin(), joint_torque_.end(), 0.0);
  std::fill(motor_torque_.begin(), motor_torque_.end(), 0.0);
  std::fill(joint_load_.begin(), joint_load_.end(), 0.0);
  std::fill(felt_acceleration_.begin(), felt_acceleration_.end(), Twistd{{}, -tree_.gravity});
}

void ArticulatedDynamics::check_inertias() {
  const auto& links = tree_.columns.model.tree().links;
  std::vector<double> moved(links.size());
  multibody::moved_inertias(tree_.columns.model.tree(), tree_.links, moved);
  for (std::size_t l = 1; l < links.size(); ++l) moved[l] += drives_.firm_inertia(links[l].object);
  couplings_.count_at_leaders(tree_.columns.q, moved);
  for (std::size_t l = links.size() - 1; l > 0; --l) {
    if (moved[l] > least_inertia) continue;
    throw SetupError(
        fmt::format("model '{}': joint '{}' moves no inertia; give a body behind it mass and inertia, or "
                    "the joint an armature or a servo with rotor_inertia",
                    tree_.columns.model.name(), tree_.columns.model.objects()[links[l].object].name));
  }
  if (!tree_.is_free()) return;
  drive_joints_explicitly();
  solve_explicitly();
  if (!is_firmly_positive(bodies_[0].inertia)) {
    throw SetupError(
        fmt::format("model '{}': its base '{}' can move without moving any inertia; give it mass and inertia",
                    tree_.columns.model.name(), tree_.columns.model.objects()[0].name));
  }
}

void ArticulatedDynamics::step(const Instant& instant) noexcept {
  if (tree_.integrator() == Integrator::rk4 && !tree_.contacts.solved()) return step_rk4(seconds(instant.period));
  if (advance(seconds(instant.period))) tree_.finish_step();
}

/// Executes a step except MovingTree::finish_step, which the caller executes if this returns true.
bool ArticulatedDynamics::advance(double dt) noexcept {
  if (!tree_.contacts.solved()) {
    begin_step(dt);
    auto loads = multibody::Loads::of_last_pass;
    tree_.contacts.settle([&] {
      const bool settled = solve(std::exchange(loads, multibody::Loads::of_repeated_pass));
      predict_contacts(dt_);
      return settled;
    });
  }
  if (end_step()) return true;
  tree_.halt(targets_sane_ ? too_fast : joints_insane);
  return false;
}

/// The end of a step, given its accelerations. Returns false, without moving anything, if a number is not sane.
bool ArticulatedDynamics::end_step() noexcept {
  if (!targets_sane_ || !accelerations_are_sane()) return false;
  MUROSIMF_ASSERT(dt_ > 0);
  report_torques();
  keep_loads();
  saturation_.look(tree_.columns.model.tree(), friction_, dt_);
  tree_.contacts.commit();
  if (!tree_.advance_base(bodies_[0].acceleration, dt_)) return false;
  // the base before the joints: its momentum correction reads the rates at the beginning of the step
  advance_joints(dt_);
  finish_drives();
  return true;
}

void ArticulatedDynamics::step_rk4(double dt) noexcept {
  tree_.take_changes();
  MUROSIMF_ASSERT(dt > 0);
  if (!drives_.take_targets(dt)) return tree_.halt(joints_insane);
  recall_loads();
  bool first = true;
  const auto accelerations = [&] {
    drive_joints_explicitly();
    solve_explicitly();
    // contacts are explicit: the forces of the first stage hold during the whole step
    if (std::exchange(first, false)) {
      predict_contacts(dt);
      tree_.contacts.commit();
    }
    return bodies_[0].acceleration;
  };
  const auto joint_acceleration = [&](int joint) {
    return bodies_[tree_.columns.model.tree().link_of[joint]].joint_acceleration;
  };
  if (!tree_.advance_rk4(dt, accelerations, joint_acceleration)) return tree_.halt(too_fast);
  drives_.wrap(tree_.columns.q);
  report_torques();
  keep_loads();
  saturation_.look(tree_.columns.model.tree(), friction_, dt);
  tree_.finish_step();
}

void ArticulatedDynamics::begin_step(double dt) noexcept {
  MUROSIMF_ASSERT(dt > 0);
  dt_ = dt;
  tree_.take_changes();
  couplings_.take_up(tree_.columns);
  targets_sane_ = drives_.take_targets(dt);
  drive_joints(dt);
  couplings_.look(tree_);
  couplings_.drive(friction_);
  recall_loads();
}

bool ArticulatedDynamics::free_pass(double dt) noexcept {
  begin_step(dt);
  (void)solve(multibody::Loads::of_last_step);
  factor();
  couplings_.prepare_responses();
  return targets_sane_ && accelerations_are_sane();
}

Vec3d ArticulatedDynamics::free_velocity(int object, const Vec3d& point, const Vec3d& velocity) const noexcept {
  const Twistd& acceleration = bodies_[tree_.columns.model.tree().link_of[object]].acceleration;
  return tree_.next_velocity(object, point, velocity, acceleration, dt_);
}

void ArticulatedDynamics::respond(int object, const Vec3d& point, const Mat3d& directions,
                                  collision::ResponseRows& y) const noexcept {
  MUROSIMF_ASSERT(object >= 0 && object < tree_.columns.model.size());
  const std::size_t first = y.index.size();
  const Tree& tree = tree_.columns.model.tree();
  auto forces = tree_.forces_about_base(point, directions);
  // the first half of the factorization M = F F^T (Featherstone 2008, sec. 6.5): from the link up to the base
  for (int l = tree.link_of[object]; l > 0; l = tree.links[l].parent) {
    const auto& body = bodies_[l];
    const Twistd& axis = tree_.links[l].axis;
    const auto along = dot(axis.w, forces.n) + dot(axis.v, forces.f);
    y.add(5 + l, collision::first_three(root_[l] * along));
    const auto share = along * body.inverse_D;
    forces.n -= share * body.U.n;
    forces.f -= share * body.U.f;
  }
  tree_.respond_at_base(forces, y);
  if (!couplings_.empty()) couplings_.hold(y, first);
}

void ArticulatedDynamics::apply(std::span<const double> z) noexcept {
  if (couplings_.empty()) return add_impulses(z);
  add_impulses(couplings_.held(z));
  couplings_.count_as_drive(friction_);
}

void ArticulatedDynamics::add_impulses(std::span<const double> z) noexcept {
  MUROSIMF_ASSERT(dt_ > 0 && z.size() >= 5 + bodies_.size());
  const auto& links = tree_.columns.model.tree().links;
  change_[0] = tree_.base_change(z, dt_);
  bodies_[0].acceleration += change_[0];
  for (std::size_t l = 1; l < links.size(); ++l) {
    auto& body = bodies_[l];
    const Twistd& parent = change_[links[l].parent];
    const double joint = z[5 + l] * root_[l] / dt_ - dot(parent, body.U) * body.inverse_D;
    change_[l] = parent + joint * tree_.links[l].axis;
    body.joint_acceleration += joint;
    body.acceleration += change_[l];
    friction_[l].load += z[5 + l] / (root_[l] * dt_) - dot(parent, body.U);
  }
}

void ArticulatedDynamics::drive_joints(double dt) noexcept {
  const PoseColumns& columns = tree_.columns;
  const auto& links = columns.model.tree().links;
  for (std::size_t l = 1; l < links.size(); ++l) {
    const int i = links[l].object;
    viscous_[l] = drives_.drive(i, columns.q[i], columns.qd[i], dt, friction_[l]);
  }
}

/// The loads that friction expects are in columns, so that equal states make equal steps.
void ArticulatedDynamics::recall_loads() noexcept {
  const auto& links = tree_.columns.model.tree().links;
  for (std::size_t l = 0; l < links.size(); ++l) {
    bodies_[l].acceleration = felt_acceleration_[links[l].object];
    friction_[l].load = joint_load_[links[l].object];
  }
}

void ArticulatedDynamics::keep_loads() noexcept {
  const auto& links = tree_.columns.model.tree().links;
  for (std::size_t l = 0; l < links.size(); ++l) {
    felt_acceleration_[links[l].object] = bodies_[l].acceleration;
    joint_load_[links[l].object] = friction_[l].load;
  }
}

void ArticulatedDynamics::gather_loads(double dt) noexcept {
  multibody::clear_loads<double>(bodies_);
  tree_.for_loads(dt, [&](int link, const Wrenchd& load, const Sym6d& damping) {
    multibody::add_load(bodies_[link], load, damping);
  });
  couplings_.add_loads(bodies_);
}

/// Executes a trial step. Returns false if the decision about some joint (sticks or slides, its motor's line) is wrong.
bool ArticulatedDynamics::solve(multibody::Loads loads) noexcept {
  const Tree& tree = tree_.columns.model.tree();
  gather_loads(dt_);
  multibody::sweep_with_friction<double>(tree, tree_.links, bodies_, friction_, loads, dt_);
  const double wrong =
      multibody::accelerate_with_friction<double>(tree, tree_.links, bodies_, friction_, base_acceleration());
  if (couplings_.empty()) return wrong == 0;
  couple();
  return multibody::wrong_decisions<double>(friction_) == 0 && multibody::follow_their_lines(friction_, dt_);
}

void ArticulatedDynamics::factor() noexcept {
  tree_.factor_base();
  for (std::size_t l = 1; l < bodies_.size(); ++l) root_[l] = std::sqrt(bodies_[l].inverse_D);
}

/// Corrects the accelerations so that coupled joints and loops hold; they count as forces that drive the joints.
void ArticulatedDynamics::couple() noexcept {
  if (!are_numbers(bodies_)) return;  // the step will be refused
  factor();
  add_impulses(couplings_.solve(tree_, bodies_, root_, dt_));
  couplings_.count_as_drive(friction_);
}

/// Sets the explicit torques of this instant.
void ArticulatedDynamics::drive_joints_explicitly() noexcept {
  drive_joints(0);
  couplings_.drive(friction_);
  for (std::size_t l = 1; l < bodies_.size(); ++l) {
    auto& joint = friction_[l];
    JointDrives::brake_explicitly(joint);
    bodies_[l].torque = joint.torque + joint.line.torque + multibody::friction_torque(joint);
    bodies_[l].added_inertia = joint.inertia;
  }
}

void ArticulatedDynamics::solve_explicitly() noexcept {
  const Tree& tree = tree_.columns.model.tree();
  gather_loads(0);
  multibody::sweep_to_base<double>(tree, tree_.links, bodies_);
  multibody::accelerate<double>(tree, tree_.links, bodies_, base_acceleration());
  for (std::size_t l = 1; l < bodies_.size(); ++l) {
    const auto& parent = bodies_[tree.links[l].parent];
    friction_[l].load = -dot(tree_.links[l].axis, bodies_[l].force) - dot(parent.acceleration, bodies_[l].U);
  }
}

void ArticulatedDynamics::advance_joints(double dt) noexcept {
  PoseColumns& columns = tree_.columns;
  const auto& links = columns.model.tree().links;
  for (std::size_t l = 1; l < links.size(); ++l) {
    const int i = links[l].object;
    const double rate = columns.qd[i] + dt * bodies_[l].joint_acceleration;
    columns.qd[i] = friction_[l].direction == 0 ? 0 : rate;  // a sticking joint has exactly no rate, not a rounded one
    columns.q[i] += dt * columns.qd[i];
  }
  drives_.wrap(columns.q);
}

void ArticulatedDynamics::report_torques() noexcept {
  const auto& links = tree_.columns.model.tree().links;
  for (std::size_t l = 1; l < links.size(); ++l) {
    const auto& joint = friction_[l];
    const auto& [viscous, inertia] = viscous_[l];
    // torque of motor and gear: the gear's share of the friction is what the joint's own friction leaves of the budget
    double torque = motor_torque(l) + (viscous - inertia * bodies_[l].joint_acceleration);
    if (joint.gear && joint.budget > 0) {
      torque += (1 - joint.coulomb / joint.budget) * multibody::friction_torque(joint);
    }
    joint_torque_[links[l].object] = torque;
    if (!motor_torque_.empty()) motor_torque_[links[l].object] = motor_torque(l);
  }
}

/// Updates the memory of the servos: backlash, temperature.
void ArticulatedDynamics::finish_drives() noexcept {
  const PoseColumns& columns = tree_.columns;
  for (const int i : drives_.remembering()) {
    const auto l = static_cast<std::size_t>(columns.model.tree().link_of[i]);
    MUROSIMF_ASSERT(l > 0 && l < bodies_.size());
    drives_.finish(i, {motor_torque(l), joint_torque_[i], columns.q[i], columns.qd[i]}, dt_);
  }
}

bool ArticulatedDynamics::accelerations_are_sane() const noexcept {
  const PoseColumns& columns = tree_.columns;
  const auto& links = columns.model.tree().links;
  double rates = 0, positions = 0;
  for (std::size_t l = 1; l < links.size(); ++l) {
    const int i = links[l].object;
    rates += std::abs(columns.qd[i] + dt_ * bodies_[l].joint_acceleration);
    positions += std::abs(columns.q[i]);
  }
  return rates < fastest_joint && positions < farthest_joint && is_sane(bodies_[0].acceleration, dt_);
}

}  // namespace murosimf::dynamics
