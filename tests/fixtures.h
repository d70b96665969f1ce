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

/// One of each kind but the plane, of different sizes in all directions.
inline std::vector<Shape> shapes_of_all_kinds() {
  return {Sphere{0.1}, Box{{0.06, 0.1, 0.15}}, Capsule{0.05, 0.12}, Cylinder{0.08, 0.1}, Ellipsoid{{0.05, 0.09, 0.14}}};
}

namespace detail {

/// Distance [m] of a point of the shape's frame from its surface, negative inside.
struct Outside {
  Vec3d p;

  [[nodiscard]] static double rounded(const Vec3d& gap, double inside) {
    const Vec3d out{std::fmax(gap.x, 0), std::fmax(gap.y, 0), std::fmax(gap.z, 0)};
    return norm(out) + std::fmin(inside, 0);
  }
  double operator()(const Sphere& s) const { return norm(p) - s.radius; }
  double operator()(const Box& s) const {
    const Vec3d gap{std::fabs(p.x) - s.half_size.x, std::fabs(p.y) - s.half_size.y, std::fabs(p.z) - s.half_size.z};
    return rounded(gap, std::fmax(gap.x, std::fmax(gap.y, gap.z)));
  }
  double operator()(const Capsule& s) const {
    const double beyond = std::fmax(std::fabs(p.z) - s.half_length, 0);
    return std::sqrt(p.x * p.x + p.y * p.y + beyond * beyond) - s.radius;
  }
  double operator()(const Cylinder& s) const {
    const Vec3d gap{std::hypot(p.x, p.y) - s.radius, std::fabs(p.z) - s.half_length, -1};
    return rounded(gap, std::fmax(gap.x, gap.y));
  }
  /// To first order in the distance; its sign and its zero are exact.
  double operator()(const Ellipsoid& s) const {
    const Vec3d a{p.x / s.semi_axes.x, p.y / s.semi_axes.y, p.z / s.semi_axes.z};
    const Vec3d slope{a.x / s.semi_axes.x, a.y / s.semi_axes.y, a.z / s.semi_axes.z};
    return (dot(a, a) - 1) / (2 * std::fmax(norm(slope), 1e-9));
  }
  double operator()(const Plane&) const { return p.z; }
  /// Outside a corner or an edge this is less than the distance; its sign and its zero are exact.
  double operator()(const Convex& s) const {
    double highest = -1e300;
    for (std::size_t i = 0; i < s.hull->faces.size(); ++i) {
      highest = std::fmax(highest, dot(s.hull->normals[i], p - s.hull->vertices[s.hull->faces[i][0]]));
    }
    return highest;
  }
};

/// Calls add(angle) all round the z axis.
template <class Add>
void around(const Add& add) {
  for (int i = 0; i < 180; ++i) add(i * pi / 90);
}

struct SurfaceSamples {
  std::vector<Vec3d> points;

  void globe(const Vec3d& size, const Vec3d& center) {
    for (int i = 0; i <= 90; ++i) {
      const double s = std::sin(i * pi / 90), c = std::cos(i * pi / 90);
      around([&](double a) {
        points.push_back(center + Vec3d{size.x * s * std::cos(a), size.y * s * std::sin(a), size.z * c});
      });
    }
  }
  void tube(double radius, double half_length) {
    for (int i = -40; i <= 40; ++i) {
      around([&](double a) { points.push_back({radius * std::cos(a), radius * std::sin(a), half_length * i / 40.0}); });
    }
  }
  void operator()(const Sphere& s) { globe({s.radius, s.radius, s.radius}, {}); }
  void operator()(const Ellipsoid& s) { globe(s.semi_axes, {}); }
  void operator()(const Capsule& s) {
    tube(s.radius, s.half_length);
    // two globes, of which the halves inside the capsule do not count
    SurfaceSamples ends;
    for (const double end : {-s.half_length, s.half_length}) ends.globe({s.radius, s.radius, s.radius}, {0, 0, end});
    for (const Vec3d& p : ends.points) {
      if (std::fabs(p.z) >= s.half_length) points.push_back(p);
    }
  }
  void operator()(const Cylinder& s) {
    tube(s.radius, s.half_length);
    for (int i = 0; i <= 40; ++i) {
      for (const double end : {-s.half_length, s.half_length}) {
        around([&](double a) {
          points.push_back({s.radius * i / 40.0 * std::cos(a), s.radius * i / 40.0 * std::sin(a), end});
        });
      }
    }
  }
  void operator()(const Box& s) {
    const Vec3d& h = s.half_size;
    for (int i = -20; i <= 20; ++i) {
      for (int j = -20; j <= 20; ++j) {
        for (const double side : {-1.0, 1.0}) {
          points.push_back({side * h.x, h.y * i / 20.0, h.z * j / 20.0});
          points.push_back({h.x * i / 20.0, side * h.y, h.z * j / 20.0});
          points.push_back({h.x * i / 20.0, h.y * j / 20.0, side * h.z});
        }
      }
    }
  }
  /// Every face as a fan of triangles.
  void operator()(const Convex& s) {
    for (const auto& face : s.hull->faces) {
      const auto corner = [&](std::size_t i) { return s.hull->vertices[face[i]]; };
      for (std::size_t k = 2; k < face.size(); ++k) {
        for (int i = 0; i <= 20; ++i) {
          for (int j = 0; i + j <= 20; ++j) {
            points.push_back(corner(0) + (i / 20.0) * (corner(k - 1) - corner(0)) +
                             (j / 20.0) * (corner(k) - corner(0)));
          }
        }
      }
    }
  }
  /// Of the infinite plane a square that reaches 1 m.
  void operator()(const Plane&) {
    for (int i = -100; i <= 100; ++i) {
      for (int j = -100; j <= 100; ++j) points.push_back({i / 100.0, j / 100.0, 0});
    }
  }
};

}  // namespace detail

/// Distance [m] of a point of the shape's frame from its surface, negative inside (ellipsoid: to first order).
inline double outside(const Shape& shape, const Vec3d& point) { return std::visit(detail::Outside{point}, shape); }

/// Points of the surface, in the shape's frame, about two degrees or a fortieth of a length apart.
inline std::vector<Vec3d> surface_samples(const Shape& shape) {
  detail::SurfaceSamples samples;
  std::visit(samples, shape);
  return samples.points;
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

/// The largest; NaN counts as larger than any number, so that no comparison passes because of it.
inline double largest(double a, double b) { return std::isnan(a) || a > b ? a : b; }
inline double largest(double a, double b, double c) { return largest(a, largest(b, c)); }

inline double difference(const Vec3d& a, const Vec3d& b) {
  return largest(std::fabs(a.x - b.x), std::fabs(a.y - b.y), std::fabs(a.z - b.z));
}
inline double difference(const Mat3d& a, const Mat3d& b) {
  return largest(difference(a.x, b.x), difference(a.y, b.y), difference(a.z, b.z));
}
inline double difference(const SymMat3d& a, const SymMat3d& b) {
  return largest(difference(Vec3d{a.xx, a.yy, a.zz}, Vec3d{b.xx, b.yy, b.zz}),
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
