/// dump_dynamics - what the kernels of multibody/ say about given states of a robot, as JSON, for the scripts
/// random_trees_against_*.py.
///
/// Usage: dump_dynamics <robot.xml> <states> (state_file.h). Per state, world axes, joints in the order of the file:
///     acceleration  of the articulated bodies under gravity, torques and forces: base [alpha, a], joints
///     forces        that the file's acceleration takes besides gravity and the file's forces: base [moment, force]
///                   about its origin, joints
///     mass_matrix   row by row in that order
///     kinetic, potential energy [J], the latter zero at the world's origin
/// Rotors (armature) are in all of them.
#include <cstdio>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/properties.h"
#include "murosimf/multibody/articulated_body.h"
#include "murosimf/multibody/inverse_dynamics.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/robot/robot_reader.h"
#include "tests/oracle/state_file.h"

namespace {

using namespace murosimf;

constexpr Vec3d gravity{0, 0, -9.81};  // [m/s^2]

std::vector<double> flat(const Vec3d& a, const Vec3d& b) { return {a.x, a.y, a.z, b.x, b.y, b.z}; }

/// One robot in one state.
class Robot {
 public:
  Robot(const Model& model, const oracle::StateFile& file, const oracle::RobotState& state)
      : model_(model), tree_(model.tree()), state_(state), links_(tree_.links.size()), external_(links_.size()) {
    for (const std::string& name : file.joints) {
      joints_.push_back(model.object_index(name));
      rows_.push_back(static_cast<std::size_t>(tree_.link_of[joints_.back()]));
    }
    place();
    for (std::size_t i = 0; i < file.bodies.size(); ++i) push(model.object_index(file.bodies[i]), state.wrenches[i]);
  }

  [[nodiscard]] std::string to_json() const {
    return fmt::format(
        "{{\"acceleration\": {},\n \"forces\": {},\n \"mass_matrix\": {},\n"
        " \"kinetic\": {:.17g}, \"potential\": {:.17g}}}",
        oracle::json_list(acceleration()), oracle::json_list(forces()), oracle::json_list(mass_matrix()), kinetic(),
        multibody::potential_energy<double>(links_, state_.position, gravity));
  }

 private:
  void place() {
    const auto size = static_cast<std::size_t>(model_.size());
    std::vector<double> q(size), qd(size);
    r_.resize(size);
    std::vector<Mat3d> R(size);
    r_[0] = state_.position;
    R[0] = to_matrix(state_.quaternion);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      q[joints_[i]] = state_.q[i];
      qd[joints_[i]] = state_.qd[i];
    }
    multibody::poses<double>(tree_, q, r_, R);
    multibody::link_motions<double>(tree_, r_, R, state_.rate, qd, links_);
  }
  void push(int object, const Wrenchd& wrench) {
    external_[tree_.link_of[object]] += moved(wrench, r_[0] - r_[object]);
  }
  [[nodiscard]] double rotor(std::size_t i) const {
    const double* armature = model_.find(properties::joint_armature, joints_[i]);
    return armature ? *armature : 0;
  }

  [[nodiscard]] std::vector<double> acceleration() const {
    std::vector<multibody::ArticulatedLink<double>> bodies(links_.size());
    multibody::clear_loads<double>(bodies);
    for (std::size_t l = 0; l < links_.size(); ++l) multibody::add_load(bodies[l], external_[l], Sym6d{});
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      bodies[rows_[i]].torque = state_.torque[i];
      bodies[rows_[i]].added_inertia = rotor(i);
    }
    multibody::sweep_to_base<double>(tree_, links_, bodies);
    multibody::accelerate<double>(tree_, links_, bodies, solve(bodies[0].inertia, -1.0 * bodies[0].force));
    auto result = flat(bodies[0].acceleration.w, bodies[0].acceleration.v + gravity);
    for (const std::size_t row : rows_) result.push_back(bodies[row].joint_acceleration);
    return result;
  }

  [[nodiscard]] std::vector<double> forces() const {
    std::vector<double> qdd(tree_.links.size()), torque(tree_.links.size());
    std::vector<Wrenchd> force(tree_.links.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) qdd[rows_[i]] = state_.joint_acceleration[i];
    const Twistd base{state_.base_acceleration.w, state_.base_acceleration.v - gravity};
    multibody::inverse_dynamics<double>(tree_, links_, base, qdd, external_, force, torque);
    auto result = flat(force[0].n, force[0].f);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      result.push_back(torque[rows_[i]] + rotor(i) * state_.joint_acceleration[i]);
    }
    return result;
  }

  /// Row of the kernel's matrix that stands in row i of ours.
  [[nodiscard]] std::size_t kernel_row(std::size_t i) const { return i < 6 ? i : 5 + rows_[i - 6]; }
  [[nodiscard]] std::vector<double> mass_matrix() const {
    const std::size_t size = 5 + links_.size();
    std::vector<double> M(size * size), result;
    std::vector<RigidInertia<double>> composite(links_.size());
    multibody::mass_matrix(tree_, links_, composite, M);
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < size; ++j) {
        result.push_back(M[kernel_row(i) * size + kernel_row(j)] + (i == j && i >= 6 ? rotor(i - 6) : 0));
      }
    }
    return result;
  }

  [[nodiscard]] double kinetic() const {
    double energy = multibody::kinetic_energy<double>(links_, state_.velocity);
    for (std::size_t i = 0; i < joints_.size(); ++i) energy += 0.5 * rotor(i) * state_.qd[i] * state_.qd[i];
    return energy;
  }

  const Model& model_;
  const Tree& tree_;
  const oracle::RobotState& state_;
  std::vector<int> joints_;        // objects
  std::vector<std::size_t> rows_;  // links of the joints
  std::vector<Vec3d> r_;           // [m] of all objects
  std::vector<multibody::LinkMotion<double>> links_;
  std::vector<Wrenchd> external_;  // [N m, N] about the base's origin, by link
};

void dump(const char* model_file, const char* state_file) {
  const auto model = robot::read_robot(model_file, {.guess = false}).model;
  const auto file = oracle::read_states(state_file);
  if (file.joints.size() != model->joints().size()) {
    throw SetupError(
        fmt::format("{} joints in the states, {} in the model", file.joints.size(), model->joints().size()));
  }
  std::vector<std::string> all;
  for (const auto& state : file.states) all.push_back(Robot(*model, file, state).to_json());
  fmt::print("[{}]\n", fmt::join(all, ",\n"));
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    fmt::print(stderr, "usage: dump_dynamics <robot.xml> <states>\n");
    return 2;
  }
  try {
    dump(arguments[1], arguments[2]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
