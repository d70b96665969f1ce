#include "murosimf/motion/articulated_dynamics.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/motion/contact_trials.h"

namespace murosimf::motion {
namespace {

constexpr double fastest_joint = 1e4;   // [rad/s | m/s] beyond this the numbers have gone bad
constexpr double farthest_joint = 1e4;  // [rad | m] sines lose their precision far beyond

}  // namespace

ArticulatedDynamics::ArticulatedDynamics(Setup& setup, const MovingTreeOptions& options)
    : tree_(setup, options, "articulated_dynamics"),
      drives_(setup),
      joint_torque_(setup.write(properties::joint_torque)),
      bodies_(tree_.links.size()) {}

void ArticulatedDynamics::initialize() {
  drives_.initialize(tree_.columns.q, tree_.columns.qd);
  tree_.start();
  std::fill(joint_torque_.begin(), joint_torque_.end(), 0.0);
  check_inertias();
}

void ArticulatedDynamics::check_inertias() const {
  const auto& links = tree_.columns.model.tree().links;
  std::vector<RigidInertia<double>> composite;
  for (const auto& link : tree_.links) composite.push_back(link.inertia);
  for (std::size_t l = links.size() - 1; l > 0; --l) {
    const int i = links[l].object;
    const double carried = dot(tree_.links[l].axis, composite[l] * tree_.links[l].axis);
    if (!(carried + drives_.drive(i, tree_.columns.q[i], 0, 0).inertia > 1e-12)) {
      throw SetupError(
          fmt::format("model '{}': joint '{}' moves no inertia; give a body behind it mass and inertia, or "
                      "the joint an armature or a servo with rotor_inertia",
                      tree_.columns.model.name(), tree_.columns.model.objects()[i].name));
    }
    composite[links[l].parent] += composite[l];
  }
}

void ArticulatedDynamics::step(const Instant& instant) noexcept {
  const double dt = seconds(instant.period);
  tree_.take_changes();
  if (!drives_.take_targets()) return tree_.halt("a joint position or target is no sensible number");
  drive_joints(dt);
  settle_contacts(tree_.contacts, tree_.columns.r, tree_.external_force, tree_.external_damping, [&] {
    solve(dt);
    tree_.predict_contacts(dt, [&](int link) { return bodies_[link].acceleration; });
  });
  const Motiond base = bodies_[0].acceleration;
  if (!advance_joints(dt) || !tree_.advance_base(base, dt)) return tree_.halt("its motion is no sensible number");
  tree_.finish_step();
}

void ArticulatedDynamics::drive_joints(double dt) noexcept {
  const PoseColumns& columns = tree_.columns;
  const auto& links = columns.model.tree().links;
  for (std::size_t l = 1; l < links.size(); ++l) {
    const int i = links[l].object;
    const JointDrive drive = drives_.drive(i, columns.q[i], columns.qd[i], dt);
    bodies_[l].torque = drive.torque;
    bodies_[l].added_inertia = drive.inertia;
  }
}

void ArticulatedDynamics::solve(double dt) noexcept {
  const Tree& tree = tree_.columns.model.tree();
  multibody::clear_loads<double>(bodies_);
  tree_.for_loads(dt, [&](int link, const Forced& load, const Sym6d& damping) {
    multibody::add_load(bodies_[link], load, damping);
  });
  multibody::sweep_to_base<double>(tree, tree_.links, bodies_);
  const Motiond base = tree_.base_acceleration(bodies_[0].inertia, -1.0 * bodies_[0].force);
  multibody::accelerate<double>(tree, tree_.links, bodies_, base);
}

bool ArticulatedDynamics::advance_joints(double dt) noexcept {
  PoseColumns& columns = tree_.columns;
  const auto& links = columns.model.tree().links;
  double rates = 0, positions = 0;
  for (std::size_t l = 1; l < links.size(); ++l) {
    const int i = links[l].object;
    const JointDrive servo = drives_.servo(i, columns.q[i], columns.qd[i], dt);
    joint_torque_[i] = servo.torque - servo.inertia * bodies_[l].joint_acceleration;
    columns.qd[i] += dt * bodies_[l].joint_acceleration;
    columns.q[i] += dt * columns.qd[i];
    rates += std::abs(columns.qd[i]);
    positions += std::abs(columns.q[i]);
  }
  return rates < fastest_joint && positions < farthest_joint;  // NaN is not less
}

}  // namespace murosimf::motion
