#include "murosimf/geometry/gjk_simplex.h"

#include "murosimf/math/assert.h"

namespace murosimf::geometry {

bool GjkSimplex::add(const DifferencePoint& point) {
  MUROSIMF_ASSERT(count_ >= 0 && count_ < 4);
  points_[count_++] = point;
  bool inside = false;
  switch (count_) {
    case 1: keep(on_point(0)); break;
    case 2: keep(on_segment(0, 1)); break;
    case 3: keep(on_triangle(0, 1, 2)); break;
    default: keep(on_tetrahedron(inside)); break;
  }
  return inside;
}

Vec3d GjkSimplex::nearest() const {
  Vec3d sum;
  for (int i = 0; i < count_; ++i) sum += weight_[i] * points_[i].w;
  return sum;
}

Vec3d GjkSimplex::on_a() const {
  Vec3d sum;
  for (int i = 0; i < count_; ++i) sum += weight_[i] * points_[i].on_a;
  return sum;
}

Vec3d GjkSimplex::on_b() const {
  Vec3d sum;
  for (int i = 0; i < count_; ++i) sum += weight_[i] * points_[i].on_b;
  return sum;
}

bool GjkSimplex::has(const Vec3d& w) const {
  for (int i = 0; i < count_; ++i) {
    if (is_zero(points_[i].w - w)) return true;
  }
  return false;
}

GjkSimplex::Weights GjkSimplex::made_of(std::array<double, 4> weight) const {
  Vec3d sum;
  for (int i = 0; i < count_; ++i) sum += weight[i] * points_[i].w;
  return {dot(sum, sum), weight};
}

GjkSimplex::Weights GjkSimplex::on_point(int i) const {
  std::array<double, 4> weight{};
  weight[i] = 1;
  return made_of(weight);
}

GjkSimplex::Weights GjkSimplex::on_segment(int i, int j) const {
  const Vec3d &a = points_[i].w, way = points_[j].w - a;
  const double square = dot(way, way), along = -dot(a, way);
  if (along <= 0) return on_point(i);
  if (along >= square) return on_point(j);
  std::array<double, 4> weight{};
  weight[j] = along / square;
  weight[i] = 1 - weight[j];
  return made_of(weight);
}

GjkSimplex::Weights GjkSimplex::on_triangle(int i, int j, int k) const {
  const Vec3d &a = points_[i].w, &b = points_[j].w, &c = points_[k].w;
  const Vec3d n = cross(b - a, c - a);
  const double u = dot(n, cross(b, c)), v = dot(n, cross(c, a)), w = dot(n, cross(a, b));
  const double sum = dot(n, n);
  if (u > 0 && v > 0 && w > 0 && sum > 0) {
    std::array<double, 4> weight{};
    weight[i] = u / (u + v + w);
    weight[j] = v / (u + v + w);
    weight[k] = w / (u + v + w);
    return made_of(weight);
  }
  Weights best = on_segment(i, j);
  for (const Weights& other : {on_segment(j, k), on_segment(k, i)}) {
    if (other.square < best.square) best = other;
  }
  return best;
}

GjkSimplex::Weights GjkSimplex::on_tetrahedron(bool& inside) const {
  constexpr std::array<std::array<int, 4>, 4> faces{{{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}}};
  Weights best;
  inside = true;
  for (const auto& [i, j, k, opposite] : faces) {
    const Vec3d& a = points_[i].w;
    const Vec3d n = cross(points_[j].w - a, points_[k].w - a);
    const Vec3d up = points_[opposite].w - a;
    const double of_origin = -dot(n, a), of_opposite = dot(n, up);
    const bool has_volume = of_opposite * of_opposite > 1e-20 * dot(n, n) * dot(up, up);
    if (of_origin * of_opposite > 0 && has_volume) continue;
    const Weights here = on_triangle(i, j, k);
    if (inside || here.square < best.square) best = here;
    inside = false;
  }
  return best;
}

void GjkSimplex::keep(const Weights& weights) {
  int kept = 0;
  for (int i = 0; i < count_; ++i) {
    if (!(weights.weight[i] > 0)) continue;
    points_[kept] = points_[i];
    weight_[kept++] = weights.weight[i];
  }
  count_ = kept;
}

}  // namespace murosimf::geometry
