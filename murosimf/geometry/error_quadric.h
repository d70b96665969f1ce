/// error_quadric.h - weighted squared distances of a point from planes, summed up in ten numbers.
///
/// Source: Garland, Heckbert, "Surface simplification using quadric error metrics", SIGGRAPH 1997, sec. 4.
#pragma once

#include "murosimf/math/mat3.h"

namespace murosimf::geometry {

struct ErrorQuadric {
  /// A plane through `point` with unit normal `n`.
  void add_plane(const Vec3d& n, const Vec3d& point, double weight) {
    const double offset = -dot(n, point);
    matrix += weight * outer(n);
    vector += (weight * offset) * n;
    constant += weight * offset * offset;
  }
  ErrorQuadric& operator+=(const ErrorQuadric& other) {
    matrix += other.matrix;
    vector += other.vector;
    constant += other.constant;
    return *this;
  }
  /// Sum over all planes of weight times squared distance; at least 0 but for rounding.
  [[nodiscard]] double operator()(const Vec3d& p) const { return dot(p, matrix * p) + 2 * dot(vector, p) + constant; }

  SymMat3d matrix{};
  Vec3d vector{};
  double constant = 0;
};

}  // namespace murosimf::geometry
