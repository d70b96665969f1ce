/// fixtures.h - what several tests share: dice, random trees, a two-legged robot, comparisons.
///
/// Nothing here is random between runs: dice are counter-based streams with fixed names.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "murosimf/math/quaternion.h"
#include "murosimf/math/random.h"
#include "murosimf/model/model.h"
#include "murosimf/model/properties.h"

namespace murosimf::fixtures {

/// Random numbers that are the same in every run and on every machine.
class Dice {
 public:
  explicit Dice(std::string_view name, std::uint64_t seed = 1) : stream_(seed, name) {}

  double uniform(double low, double high) { return stream_.uniform(n_++, low, high); }
  /// 0 .. count-1.
  int pick(int count) { return static_cast<int>(uniform(0, count)); }
  bool chance(double probability) { return uniform(0, 1) < probability; }
  Vec3d vector(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }
  Vec3d unit() {
    while (true) {
      const Vec3d v = vector(1);
      const double length = norm(v);
      if (length > 0.1 && length < 1) return (1 / length) * v;
    }
  }
  Quaterniond quaternion() { return exponential(uniform(0, pi) * unit()); }
  Mat3d turn() { return to_matrix(quaternion()); }
  /// Inertia of a real body: a cloud of points.
  SymMat3d inertia(double size) {
    SymMat3d sum;
    for (int i = 0; i < 5; ++i) sum += 0.2 * inertia_of_point(vector(size));
    return sum;
  }

 private:
  RandomStream stream_;
  std::uint64_t n_ = 0;
};

namespace detail {

inline Vec3d joint_axis(Dice& dice) {
  switch (dice.pick(5)) {
    case 0: return {1, 0, 0};
    case 1: return {0, 1, 0};
    case 2: return {0, 0, 1};
    case 3: return {0, -1, 0};
    default: return dice.uniform(0.5, 2.0) * dice.unit();
  }
}

inline void add_mass(Chain& chain, Dice& dice) {
  chain.with(properties::mass, dice.uniform(0.1, 2.0));
  if (dice.chance(0.7)) chain.with(properties::center_of_mass, dice.vector(0.1));
  if (dice.chance(0.7)) chain.with(properties::inertia, dice.inertia(0.1));
}

inline void add_object(Chain& chain, Dice& dice, int& joints) {
  switch (dice.pick(6)) {
    case 0: chain.translation(dice.vector(0.3)); break;
    case 1: chain.rotation(dice.unit(), dice.uniform(-pi, pi)); break;
    case 2: chain.rotation(dice.turn()); break;
    case 3: chain.prismatic("slider_" + std::to_string(joints++), joint_axis(dice)); break;
    default: chain.revolute("hinge_" + std::to_string(joints++), joint_axis(dice)); break;
  }
}

inline Chain limb(Dice& dice, int objects, int generations, int& joints) {
  Chain chain;
  for (int i = 0; i < objects; ++i) {
    add_object(chain, dice, joints);
    if (dice.chance(0.5)) add_mass(chain, dice);
  }
  if (generations == 0) {
    if (dice.chance(0.5)) chain.endpoint();
    return chain;
  }
  std::vector<Chain> branches;
  const int count = 1 + dice.pick(3);
  for (int i = 0; i < count; ++i) branches.push_back(limb(dice, 1 + dice.pick(objects), generations - 1, joints));
  return chain.fork(branches);
}

}  // namespace detail

/// A tree of about 20 to 80 objects of all seven kinds, with joints about x, y, z and general axes, masses on
/// joints and on fixed objects, and forks in forks.
inline Model random_model(std::uint64_t seed) {
  Dice dice("random model", seed);
  int joints = 0;
  Chain chain;
  chain.base();
  detail::add_mass(chain, dice);
  std::vector<Chain> limbs;
  for (int i = 0; i < 2; ++i) limbs.push_back(detail::limb(dice, 6, 2, joints));
  chain.fork(limbs);
  return Model("random_" + std::to_string(seed), chain);
}

inline PlacedShape placed(const Shape& shape, const Vec3d& position = {}, const Mat3d& orientation = {}) {
  PlacedShape result;
  result.shape = shape;
  result.position = position;
  result.orientation = orientation;
  return result;
}

inline Chain two_legged_leg(const std::string& side, double sign) {
  using namespace properties;
  return Chain{}
      .translation({0, sign * 0.05, -0.04})
      .revolute(side + "_hip_roll", {1, 0, 0})
      .revolute(side + "_hip_pitch", {0, 1, 0})
      .with(mass, 0.4)
      .with(center_of_mass, {0, 0, -0.06})
      .with(inertia, {6e-4, 6e-4, 1e-4, 0, 0, 0})
      .translation({0, 0, -0.12})
      .revolute(side + "_knee", {0, 1, 0})
      .with(mass, 0.3)
      .with(center_of_mass, {0.01, 0, -0.06})
      .with(inertia, {5e-4, 5e-4, 1e-4, 0, 0, 0})
      .translation({0, 0, -0.12})
      .revolute(side + "_ankle", {0, 1, 0})
      .translation({0.02, 0, -0.03}, side + "_foot")
      .with(mass, 0.1)
      .with(inertia, {1e-4, 2e-4, 2e-4, 0, 0, 0})
      .with(shapes, {placed(Box{{0.06, 0.03, 0.01}}, {0, 0, 0.01})})
      .with(sole, {0.06, 0.03})
      .endpoint();
}

/// A robot of 3 kg with eight joints; its soles are 0.31 m below the base when all joints are at zero.
inline Model two_legged() {
  using namespace properties;
  return Model("two_legged", Chain{}
                                 .base("trunk")
                                 .with(mass, 1.4)
                                 .with(center_of_mass, {0, 0, 0.05})
                                 .with(inertia, {4e-3, 3e-3, 2e-3, 0, 1e-4, 0})
                                 .with(shapes, {placed(Box{{0.04, 0.06, 0.08}}, {0, 0, 0.05})})
                                 .fork(two_legged_leg("left", +1), two_legged_leg("right", -1)));
}

inline Model ball_model(double radius, double ball_mass) {
  using namespace properties;
  const double I = 0.4 * ball_mass * radius * radius;
  return Model("ball", Chain{}
                           .base("ball")
                           .with(mass, ball_mass)
                           .with(inertia, {I, I, I, 0, 0, 0})
                           .with(shapes, {placed(Sphere{radius})}));
}

/// One row per object, as kernels want it.
template <class S>
struct State {
  std::vector<S> q, qd;
  std::vector<Vec3<S>> r, v, w;
  std::vector<Mat3<S>> R;

  explicit State(int rows)
      : q(static_cast<std::size_t>(rows)), qd(q.size()), r(q.size()), v(q.size()), w(q.size()), R(q.size()) {}
};

/// Random joint positions and rates and a random base; the other rows are still to be computed.
inline State<double> random_state(const Model& model, Dice& dice) {
  State<double> s(model.size());
  for (const int joint : model.joints()) {
    s.q[joint] = dice.uniform(-3, 3);
    s.qd[joint] = dice.uniform(-2, 2);
  }
  s.r[0] = dice.vector(1);
  s.R[0] = dice.turn();
  s.v[0] = dice.vector(1);
  s.w[0] = dice.vector(2);
  return s;
}

/// The same number bit for bit, or both no number (the bits of a NaN say nothing).
inline bool same_bits(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

inline double difference(const Vec3d& a, const Vec3d& b) {
  return std::fmax(std::fabs(a.x - b.x), std::fmax(std::fabs(a.y - b.y), std::fabs(a.z - b.z)));
}
inline double difference(const Mat3d& a, const Mat3d& b) {
  return std::fmax(difference(a.x, b.x), std::fmax(difference(a.y, b.y), difference(a.z, b.z)));
}
inline double difference(const SymMat3d& a, const SymMat3d& b) {
  return std::fmax(difference(Vec3d{a.xx, a.yy, a.zz}, Vec3d{b.xx, b.yy, b.zz}),
                   difference(Vec3d{a.xy, a.xz, a.yz}, Vec3d{b.xy, b.xz, b.yz}));
}

/// Message of the SetupError that `action` throws; "no error" if it throws none.
template <class Action>
std::string error_of(const Action& action) {
  try {
    action();
  } catch (const SetupError& error) {
    return error.what();
  }
  return "no error";
}

/// All `parts` occur in the text.
inline ::testing::AssertionResult says(const std::string& text, std::initializer_list<std::string_view> parts) {
  for (const std::string_view part : parts) {
    if (text.find(part) == std::string::npos) {
      return ::testing::AssertionFailure() << "\"" << text << "\" does not say \"" << part << "\"";
    }
  }
  return ::testing::AssertionSuccess();
}

}  // namespace murosimf::fixtures
