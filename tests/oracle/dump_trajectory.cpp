/// dump_trajectory - how a robot moves at level articulated_dynamics, as JSON, for trajectories_against_mujoco.py.
///
/// Usage: dump_trajectory <robot.xml> <states> <rate> (state_file.h; rate in Hz). From every state the robot flies for
/// half a second, its joints on the way to their targets (the file's torques are these targets; its forces and
/// accelerations are not used). Every 10 ms a row: position [m] and quaternion (w x y z) of the base, joint positions.
#include <cstdio>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/collision/ground_contact.h"
#include "murosimf/dynamics/articulated_dynamics.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/properties.h"
#include "murosimf/robot/robot_reader.h"
#include "murosimf/runtime/simulation.h"
#include "tests/oracle/state_file.h"

namespace {

using namespace murosimf;

constexpr int rows = 50;

void set_targets(Entity& robot, const oracle::StateFile& file, const oracle::RobotState& state) {
  for (std::size_t i = 0; i < file.joints.size(); ++i) {
    robot.object(file.joints[i]).set(properties::joint_target, state.torque[i]);
  }
}

void set_state(Entity& robot, const oracle::StateFile& file, const oracle::RobotState& state) {
  robot.base().set(properties::position, state.position);
  robot.base().set(properties::base_quaternion, state.quaternion);
  robot.base().set(properties::linear_velocity, state.velocity);
  robot.base().set(properties::angular_velocity, state.rate);
  for (std::size_t i = 0; i < file.joints.size(); ++i) {
    robot.object(file.joints[i]).set(properties::joint_position, state.q[i]);
    robot.object(file.joints[i]).set(properties::joint_velocity, state.qd[i]);
  }
}

std::string row(Entity& robot, const oracle::StateFile& file) {
  const Vec3d r = robot.base().get(properties::position);
  const Quaterniond Q = robot.base().get(properties::base_quaternion);
  std::vector<double> numbers{r.x, r.y, r.z, Q.w, Q.x, Q.y, Q.z};
  for (const std::string& name : file.joints) numbers.push_back(robot.object(name).get(properties::joint_position));
  return oracle::json_list(numbers);
}

std::string fly(const ModelPtr& model, const oracle::StateFile& file, const oracle::RobotState& state, double rate) {
  Simulation simulation;
  Entity& robot = simulation.world().add("robot", model);
  simulation.attach<collision::GroundContact>("ground_contact", robot, rate, nullptr,
                                              catalog::make_contact_law("implicit_stick"), MaterialTable{});
  simulation.attach<dynamics::ArticulatedDynamics>("articulated_dynamics", robot, rate);
  set_targets(robot, file, state);
  simulation.initialize();
  set_state(robot, file, state);
  std::vector<std::string> all;
  for (int i = 0; i < rows; ++i) {
    simulation.run(std::chrono::milliseconds(10));
    all.push_back(row(robot, file));
  }
  if (robot.frozen()) throw SetupError("the robot stopped: " + *robot.frozen_reason());
  return fmt::format("[{}]", fmt::join(all, ",\n"));
}

void dump(const char* model_file, const char* state_file, double rate) {
  const auto model = robot::read_robot(model_file, {.guess = false}).model;
  const auto file = oracle::read_states(state_file);
  std::vector<std::string> all;
  for (const auto& state : file.states) all.push_back(fly(model, file, state, rate));
  fmt::print("[{}]\n", fmt::join(all, ",\n"));
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) {
    fmt::print(stderr, "usage: dump_trajectory <robot.xml> <states> <rate>\n");
    return 2;
  }
  try {
    dump(arguments[1], arguments[2], std::stod(arguments[3]));
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
