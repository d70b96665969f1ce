/// pairs.h - what tests of pairs of shapes share: poses near each other, and the depth by brute force.
///
/// The least shift along the unit vector n that parts A from B is g(n) = h_B(n) + h_A(-n), where h(n) is the largest n . x
/// over a shape. Its least value over all n is the depth if it is positive, else the distance, negated.
#pragma once

#include <algorithm>
#include <functional>

#include "murosimf/geometry/manifold.h"
#include "tests/fixtures.h"

namespace murosimf::pairs {

using fixtures::Dice;
using geometry::Manifold;
using geometry::ManifoldPoint;

inline Vec3d unit(const Vec3d& v) { return (1 / norm(v)) * v; }

/// A polyhedron of given corners and faces, counterclockwise seen from outside.
inline Shape hull(std::vector<Vec3d> vertices, std::vector<std::vector<std::uint32_t>> faces) {
  ConvexHull hull{std::move(vertices), std::move(faces), {}, {}, {}};
  std::vector<std::vector<std::uint32_t>> neighbors(hull.vertices.size());
  for (const auto& face : hull.faces) {
    const Vec3d &a = hull.vertices[face[0]], &b = hull.vertices[face[1]], &c = hull.vertices[face[2]];
    hull.normals.push_back(unit(cross(b - a, c - a)));
    for (std::size_t k = 0; k < face.size(); ++k) neighbors[face[k]].push_back(face[(k + 1) % face.size()]);
  }
  for (const auto& list : neighbors) {
    hull.first_neighbor.push_back(static_cast<std::uint32_t>(hull.neighbors.size()));
    hull.neighbors.insert(hull.neighbors.end(), list.begin(), list.end());
  }
  hull.first_neighbor.push_back(static_cast<std::uint32_t>(hull.neighbors.size()));
  return Convex{std::make_shared<const ConvexHull>(std::move(hull))};
}

inline Shape octahedron(double x, double y, double z) {
  return hull({{x, 0, 0}, {-x, 0, 0}, {0, y, 0}, {0, -y, 0}, {0, 0, z}, {0, 0, -z}},
              {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
}

/// Regular, of n sides, its axis along z.
inline Shape prism(int n, double radius, double half_length) {
  std::vector<Vec3d> vertices;
  std::vector<std::uint32_t> top, bottom;
  std::vector<std::vector<std::uint32_t>> faces;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * pi * i / n;
    const Vec3d rim{radius * std::cos(angle), radius * std::sin(angle), 0};
    vertices.push_back(rim + Vec3d{0, 0, -half_length});
    vertices.push_back(rim + Vec3d{0, 0, half_length});
    const auto low = static_cast<std::uint32_t>(2 * i), next = static_cast<std::uint32_t>(2 * ((i + 1) % n));
    top.push_back(low + 1);
    bottom.insert(bottom.begin(), low);
    faces.push_back({low, next, next + 1, low + 1});
  }
  faces.push_back(top);
  faces.push_back(bottom);
  return hull(std::move(vertices), std::move(faces));
}

/// One of each kind but the plane, of about the size of a robot's link, and polyhedra.
inline std::vector<Shape> all_kinds() {
  std::vector<Shape> shapes = fixtures::shapes_of_all_kinds();
  shapes.push_back(octahedron(0.12, 0.08, 0.1));
  shapes.push_back(prism(5, 0.09, 0.07));
  return shapes;
}

namespace detail {

struct Reach {
  Vec3d d;
  double operator()(const Sphere& s) const { return s.radius * norm(d); }
  double operator()(const Box& s) const {
    return s.half_size.x * std::abs(d.x) + s.half_size.y * std::abs(d.y) + s.half_size.z * std::abs(d.z);
  }
  double operator()(const Capsule& s) const { return s.radius * norm(d) + s.half_length * std::abs(d.z); }
  double operator()(const Cylinder& s) const { return s.radius * std::hypot(d.x, d.y) + s.half_length * std::abs(d.z); }
  double operator()(const Ellipsoid& s) const {
    return norm(Vec3d{s.semi_axes.x * d.x, s.semi_axes.y * d.y, s.semi_axes.z * d.z});
  }
  double operator()(const Plane&) const { return d.z > 0.999999999999 * norm(d) ? 0 : 1e9; }
  double operator()(const Convex& s) const {
    double highest = -1e300;
    for (const Vec3d& v : s.hull->vertices) highest = std::fmax(highest, dot(d, v));
    return highest;
  }
};

/// Directions of straight lines of the surface: along these the reach has a kink.
struct Lines {
  std::vector<Vec3d> operator()(const Sphere&) const { return {}; }
  std::vector<Vec3d> operator()(const Box&) const { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}; }
  std::vector<Vec3d> operator()(const Capsule&) const { return {{0, 0, 1}}; }
  std::vector<Vec3d> operator()(const Cylinder&) const { return {{0, 0, 1}}; }
  std::vector<Vec3d> operator()(const Ellipsoid&) const { return {}; }
  std::vector<Vec3d> operator()(const Plane&) const { return {}; }
  std::vector<Vec3d> operator()(const Convex& s) const {
    std::vector<Vec3d> lines;
    for (const auto& face : s.hull->faces) {
      for (std::size_t k = 0; k < face.size(); ++k) {
        const Vec3d way = unit(s.hull->vertices[face[(k + 1) % face.size()]] - s.hull->vertices[face[k]]);
        bool known = false;
        for (const Vec3d& line : lines) known = known || norm(cross(line, way)) < 1e-9;
        if (!known) lines.push_back(way);
      }
    }
    return lines;
  }
};

}  // namespace detail

/// Largest n . x over a shape [m], world frame.
inline double reach(const Shape& shape, const Transformd& at, const Vec3d& n) {
  return dot(n, at.position) + std::visit(detail::Reach{transposed_times(at.orientation, n)}, shape);
}

/// Least shift of A along n that parts it from B.
inline double shift(const Shape& a, const Transformd& at_a, const Shape& b, const Transformd& at_b, const Vec3d& n) {
  return reach(b, at_b, n) + reach(a, at_a, -n);
}

/// The least shift over all directions, by samples, refined: at kinks (products of two lines), along kinks (upright on
/// one line), and elsewhere. Never less than the true one.
class LeastShift {
 public:
  LeastShift(const Shape& a, const Transformd& at_a, const Shape& b, const Transformd& at_b)
      : g_([&](const Vec3d& n) { return shift(a, at_a, b, at_b, n); }) {
    std::vector<Vec3d> lines;
    for (const auto& [shape, at] : {std::pair(&a, &at_a), std::pair(&b, &at_b)}) {
      for (const Vec3d& line : std::visit(detail::Lines{}, *shape)) lines.push_back(at->orientation * line);
    }
    for (const Vec3d& u : lines) {
      see(u);
      see(-u);
      along(u);
      for (const Vec3d& v : lines) crossing(u, v);
    }
    everywhere();
    see(unit(at_a.position - at_b.position));
  }
  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] const Vec3d& direction() const { return n_; }

 private:
  void see(const Vec3d& n) {
    if (!(norm(n) > 0.5)) return;
    const double value = g_(n);
    if (!(value < value_)) return;
    value_ = value;
    n_ = n;
  }
  void crossing(const Vec3d& u, const Vec3d& v) {
    const Vec3d n = cross(u, v);
    if (norm(n) < 1e-9) return;
    see(unit(n));
    see(-unit(n));
  }
  void along(const Vec3d& u) {
    const Vec3d e = unit(std::abs(u.x) < 0.7 ? cross(u, Vec3d{1, 0, 0}) : cross(u, Vec3d{0, 1, 0})), f = cross(u, e);
    const auto at = [&](double angle) { return std::cos(angle) * e + std::sin(angle) * f; };
    constexpr int steps = 90;
    const double step = 2 * pi / steps;
    for (int i = 0; i < steps; ++i) {
      const double here = g_(at(i * step));
      if (here > g_(at((i - 1) * step)) || here > g_(at((i + 1) * step))) continue;
      double low = (i - 1) * step, high = (i + 1) * step;
      while (high - low > 1e-9) {
        const double p = low + 0.382 * (high - low), q = low + 0.618 * (high - low);
        (g_(at(p)) < g_(at(q)) ? high : low) = g_(at(p)) < g_(at(q)) ? q : p;
      }
      see(at(0.5 * (low + high)));
    }
  }
  void everywhere() {
    constexpr int samples = 600;
    std::vector<std::pair<double, Vec3d>> all;
    for (int i = 0; i < samples; ++i) {
      const double z = 1 - (2 * i + 1.0) / samples, angle = 2.399963229728653 * i, r = std::sqrt(1 - z * z);
      const Vec3d n{r * std::cos(angle), r * std::sin(angle), z};
      all.emplace_back(g_(n), n);
    }
    std::sort(all.begin(), all.end(), [](const auto& p, const auto& q) { return p.first < q.first; });
    for (int i = 0; i < 8; ++i) refine(all[i].second);
  }
  void refine(Vec3d n) {
    double best = g_(n), step = 0.05;
    for (int round = 0; step > 1e-8; ++round) {
      const Vec3d e = unit(std::abs(n.x) < 0.7 ? cross(n, Vec3d{1, 0, 0}) : cross(n, Vec3d{0, 1, 0})), f = cross(n, e);
      bool better = false;
      for (int i = 0; i < 8; ++i) {
        const double angle = i * pi / 4 + round;
        const Vec3d next = unit(n + step * std::cos(angle) * e + step * std::sin(angle) * f);
        if (g_(next) >= best) continue;
        best = g_(next);
        n = next;
        better = true;
        break;
      }
      if (!better) step *= 0.6;
    }
    see(n);
  }

  std::function<double(const Vec3d&)> g_;
  double value_ = 1e300;
  Vec3d n_;
};

inline Transformd random_pose(Dice& dice, double reach) { return {dice.vector(reach), dice.turn()}; }

inline Vec3d to_shape(const Transformd& at, const Vec3d& point) {
  return transposed_times(at.orientation, point - at.position);
}

}  // namespace murosimf::pairs
