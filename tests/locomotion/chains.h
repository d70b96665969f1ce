/// chains.h - legs in the forms that teams build, invented for tests of inverse kinematics. Left legs; lengths in meters.
#pragma once

#include <string>
#include <vector>

#include "murosimf/locomotion/leg.h"
#include "murosimf/model/properties.h"

namespace murosimf::test {

/// A hinge of an invented leg: its offset from the previous one, its axis, its range [rad].
struct TestHinge {
  Vec3d offset, axis;
  double lowest, highest;
};

/// A model with one such leg, and with its mirror image if `both`.
inline Model legged(const std::string& name, const std::vector<TestHinge>& hinges, const Vec3d& sole, bool both) {
  const auto side = [&](double outward) {
    const std::string prefix = outward > 0 ? "l_" : "r_";
    Chain chain;
    for (std::size_t i = 0; i < hinges.size(); ++i) {
      const auto& [offset, axis, lowest, highest] = hinges[i];
      chain.translation({offset.x, outward * offset.y, offset.z})
          .revolute(prefix + std::to_string(i), {outward * axis.x, axis.y, outward * axis.z})
          .with(properties::joint_range, {lowest, highest, 0})
          .with(properties::mass, 0.3);
    }
    chain.translation({sole.x, outward * sole.y, sole.z}).endpoint(prefix + "sole").with(properties::sole, {0.1, 0.04});
    return chain;
  };
  Chain body = Chain{}.base("trunk").with(properties::mass, 3.0);
  return {name, both ? body.fork(side(1), side(-1)) : body.fork(std::vector<Chain>{side(1)})};
}

/// Hip pitch, roll, yaw with axes that pass each other by 12 to 48 mm, as in large humanoids.
inline std::vector<TestHinge> pitch_roll_yaw() {
  return {{{0, 0.096, -0.077}, {0, 1, 0}, -2, 2},      {{0, 0, -0.026}, {1, 0, 0}, -0.4, 1.57},
          {{0.012, 0, -0.0485}, {0, 0, 1}, -1, 1},     {{-0.014, 0, -0.117}, {0, 1, 0}, 0, 2.23},
          {{0, 0.0002, -0.245}, {0, 1, 0}, -1.2, 0.6}, {{0, 0, 0}, {1, 0, 0}, -0.5, 0.5}};
}

/// Hip yaw, roll, pitch with offsets and turned-round axes, and an ankle with axes that do not meet.
inline std::vector<TestHinge> offset_yaw_roll_pitch() {
  return {{{0, 0.055, 0}, {0, 0, -1}, -1.5, 1.5},      {{-0.026, 0, -0.046}, {-1, 0, 0}, -1.5, 1.5},
          {{0.02, 0.03, -0.02}, {0, -1, 0}, -2, 2},    {{0.004, 0, -0.169}, {0, -1, 0}, -2.9, 0},
          {{0.01, 0.01, -0.17}, {0, 1, 0}, -1.7, 1.2}, {{0.026, 0, -0.012}, {1, 0, 0}, -1, 1}};
}

/// Hip yaw and pitch in one hinge at 45 degrees, then roll and pitch.
inline std::vector<TestHinge> slanted_hip() {
  const double s = 0.70710678118654752;
  return {{{-0.01, 0.055, -0.115}, {0, s, -s}, -1.57, 0.5},
          {{0, 0, 0}, {1, 0, 0}, -0.6, 0.8},
          {{0, 0, 0}, {0, -1, 0}, -0.5, 1.8},
          {{0.005, 0, -0.12}, {0, -1, 0}, -2.3, 0.02},
          {{0, 0, -0.1}, {0, -1, 0}, -0.8, 1.3},
          {{0, 0, -0.005}, {1, 0, 0}, -0.5, 0.8}};
}

/// No yaw: five hinges.
inline std::vector<TestHinge> five_hinges() {
  return {{{0, 0.05, 0}, {1, 0, 0}, -0.8, 0.8},
          {{0, 0.01, -0.02}, {0, 1, 0}, -1.8, 1.8},
          {{0, 0, -0.1}, {0, 1, 0}, -0.1, 2.2},
          {{0, 0, -0.1}, {0, 1, 0}, -1.5, 1.5},
          {{0, 0, -0.02}, {1, 0, 0}, -0.8, 0.8}};
}

}  // namespace murosimf::test
