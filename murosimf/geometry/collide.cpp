#include "murosimf/geometry/collide.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "murosimf/geometry/pair_tests.h"
#include "murosimf/math/assert.h"

namespace murosimf::geometry {
namespace {

/// Each pair of kinds has its test for one order only: the one of lower rank comes first.
int rank(const Shape& shape) {
  constexpr std::array ranks{0, 1, 2, 3, 4, 6, 5};  // by index in Shape: the plane comes last
  MUROSIMF_ASSERT(shape.index() < ranks.size());
  return ranks[shape.index()];
}

/// Order of two shapes of one kind by their sizes.
struct Sizes {
  std::tuple<double, double, double> operator()(const Sphere& s) const { return {s.radius, 0, 0}; }
  std::tuple<double, double, double> operator()(const Box& s) const { return of(s.half_size); }
  std::tuple<double, double, double> operator()(const Capsule& s) const { return {s.radius, s.half_length, 0}; }
  std::tuple<double, double, double> operator()(const Cylinder& s) const { return {s.radius, s.half_length, 0}; }
  std::tuple<double, double, double> operator()(const Ellipsoid& s) const { return of(s.semi_axes); }
  std::tuple<double, double, double> operator()(const Plane&) const { return {}; }
  std::tuple<double, double, double> operator()(const Convex& s) const {
    MUROSIMF_ASSERT(s.hull && !s.hull->vertices.empty());
    const double count = static_cast<double>(s.hull->vertices.size());
    return {count, static_cast<double>(s.hull->faces.size()), s.hull->vertices[0].x};
  }

 private:
  static std::tuple<double, double, double> of(const Vec3d& v) { return {v.x, v.y, v.z}; }
};

/// True if the test of A and B has to be asked the other way round. Of equal shapes, the one farther along a skew
/// direction comes first: then the answer does not depend on how the caller names them.
bool swapped(const Shape& a, const Transformd& at_a, const Shape& b, const Transformd& at_b) {
  if (a.index() != b.index()) return rank(a) > rank(b);
  const auto size_a = std::visit(Sizes{}, a), size_b = std::visit(Sizes{}, b);
  if (size_a != size_b) return size_a < size_b;
  constexpr Vec3d skew{0.4082, 0.3517, 0.8424};
  return dot(at_a.position - at_b.position, skew) < 0;
}

bool in_order(const Shape& a, const Transformd& at_a, const Shape& b, const Transformd& at_b, Manifold& found) {
  if (const auto* sphere = std::get_if<Sphere>(&a)) return collide_sphere(*sphere, at_a, b, at_b, found);
  if (std::holds_alternative<Plane>(b)) return collide_with_plane(a, at_a, at_b, found);
  if (const auto* box = std::get_if<Box>(&a)) {
    if (const auto* other = std::get_if<Box>(&b)) return collide_boxes(*box, at_a, *other, at_b, found);
    if (const auto* other = std::get_if<Capsule>(&b)) return collide_box_capsule(*box, at_a, *other, at_b, found);
  }
  if (const auto* capsule = std::get_if<Capsule>(&a)) {
    if (const auto* other = std::get_if<Capsule>(&b)) return collide_capsules(*capsule, at_a, *other, at_b, found);
  }
  return collide_general(a, at_a, b, at_b, found);
}

}  // namespace

bool collide(const Shape& a, const Transformd& at_a, const Shape& b, const Transformd& at_b, Manifold& found) {
  if (!swapped(a, at_a, b, at_b)) return in_order(a, at_a, b, at_b, found);
  if (!in_order(b, at_b, a, at_a, found)) return false;
  found.normal = -found.normal;
  return true;
}

}  // namespace murosimf::geometry
