/// state_file.h - states of a robot as the oracle's Python scripts write them (random_models.py).
///
/// Line 1: names of the joints; line 2: names of the bodies; then one line of numbers per state, world axes:
///     base: position [m], quaternion w x y z, velocity [m/s], angular velocity [rad/s]
///     by joint: position [rad | m], rate [rad/s | m/s], torque [N m | N] (or target [rad | m])
///     by body: moment [N m] about its origin, force [N]
///     acceleration: base [rad/s^2, m/s^2], by joint [rad/s^2 | m/s^2]
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/math/quaternion.h"
#include "murosimf/math/spatial.h"
#include "murosimf/model/error.h"

namespace murosimf::oracle {

struct RobotState {
  Vec3d position;             ///< [m]
  Quaterniond quaternion;     ///< base axes to world axes
  Vec3d velocity;             ///< [m/s] of the base's origin
  Vec3d rate;                 ///< [rad/s] of the base
  std::vector<double> q, qd;  ///< by joint
  std::vector<double> torque;
  std::vector<Wrenchd> wrenches;  ///< by body
  Twistd base_acceleration;
  std::vector<double> joint_acceleration;
};

struct StateFile {
  std::vector<std::string> joints, bodies;
  std::vector<RobotState> states;
};

namespace detail {

inline std::vector<std::string> words(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> result;
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

/// Takes numbers off a line, one after the other.
class Numbers {
 public:
  explicit Numbers(const std::string& line) : words_(words(line)) {}

  double number() {
    if (next_ >= words_.size()) throw SetupError("a line of the state file is too short");
    return std::stod(words_[next_++]);
  }
  Vec3d vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }
  std::vector<double> list(std::size_t count) {
    std::vector<double> result;
    while (result.size() < count) result.push_back(number());
    return result;
  }
  void expect_end() const {
    if (next_ != words_.size()) throw SetupError("a line of the state file is too long");
  }

 private:
  std::vector<std::string> words_;
  std::size_t next_ = 0;
};

inline RobotState read_state(const std::string& line, std::size_t joints, std::size_t bodies) {
  Numbers numbers(line);
  RobotState state;
  state.position = numbers.vector();
  const auto Q = numbers.list(4);
  state.quaternion = {Q[0], Q[1], Q[2], Q[3]};
  state.velocity = numbers.vector();
  state.rate = numbers.vector();
  state.q = numbers.list(joints);
  state.qd = numbers.list(joints);
  state.torque = numbers.list(joints);
  for (std::size_t i = 0; i < bodies; ++i) {
    const Vec3d moment = numbers.vector();
    state.wrenches.push_back({moment, numbers.vector()});
  }
  state.base_acceleration.w = numbers.vector();
  state.base_acceleration.v = numbers.vector();
  state.joint_acceleration = numbers.list(joints);
  numbers.expect_end();
  return state;
}

}  // namespace detail

inline StateFile read_states(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string joints, bodies;
  if (!std::getline(stream, joints) || !std::getline(stream, bodies)) {
    throw SetupError(fmt::format("{}: no state file", file.string()));
  }
  StateFile result{detail::words(joints), detail::words(bodies), {}};
  for (std::string line; std::getline(stream, line);) {
    result.states.push_back(detail::read_state(line, result.joints.size(), result.bodies.size()));
  }
  return result;
}

/// "[1, 2.5]" with all digits.
inline std::string json_list(const std::vector<double>& numbers) {
  std::vector<std::string> words;
  for (const double x : numbers) words.push_back(fmt::format("{:.17g}", x));
  return fmt::format("[{}]", fmt::join(words, ", "));
}

}  // namespace murosimf::oracle
