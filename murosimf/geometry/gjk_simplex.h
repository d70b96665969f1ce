/// gjk_simplex.h - up to four points of the difference of two bodies, and their hull's point nearest to the origin.
#pragma once

#include <array>

#include "murosimf/math/vec3.h"

namespace murosimf::geometry {

/// A point of A - B.
struct DifferencePoint {
  Vec3d w, on_a, on_b;  ///< [m] w = on_a - on_b
};

/// Closest points of segments, triangles and tetrahedra: Ericson, Real-Time Collision Detection, 2005, sec. 5.1.
class GjkSimplex {
 public:
  /// Adds a point and keeps only those that carry the nearest point. True if the origin is inside.
  bool add(const DifferencePoint& point);

  [[nodiscard]] Vec3d nearest() const;
  [[nodiscard]] Vec3d on_a() const;
  [[nodiscard]] Vec3d on_b() const;
  [[nodiscard]] bool has(const Vec3d& w) const;

 private:
  struct Weights {
    double square = 0;               // of the distance
    std::array<double, 4> weight{};  // of each point; zero: it does not carry
  };
  [[nodiscard]] Weights on_point(int i) const;
  [[nodiscard]] Weights on_segment(int i, int j) const;
  [[nodiscard]] Weights on_triangle(int i, int j, int k) const;
  [[nodiscard]] Weights on_tetrahedron(bool& inside) const;
  [[nodiscard]] Weights made_of(std::array<double, 4> weight) const;
  void keep(const Weights& weights);

  int count_ = 0;
  std::array<DifferencePoint, 4> points_;
  std::array<double, 4> weight_{};
};

}  // namespace murosimf::geometry
