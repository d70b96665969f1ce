// A sphere against anything, a plane against anything.
#include "murosimf/geometry/build_manifold.h"
#include "murosimf/geometry/low_points.h"
#include "murosimf/geometry/pair_tests.h"
#include "murosimf/geometry/sphere_contact.h"
#include "murosimf/geometry/support.h"

namespace murosimf::geometry {

bool collide_sphere(const Sphere& a, const Transformd& at_a, const Shape& b, const Transformd& at_b, Manifold& found) {
  const Vec3d center = transposed_times(at_b.orientation, at_a.position - at_b.position);
  const auto contact = sphere_contact(center, a.radius, b);
  if (!contact) return false;
  const Vec3d normal = at_b.orientation * contact->normal;
  const Vec3d surface = at_b.position + at_b.orientation * contact->point;
  only_point({normal, contact->depth}, surface - (0.5 * contact->depth) * normal, 0, found);
  return true;
}

bool collide_with_plane(const Shape& a, const Transformd& at_a, const Transformd& at_b, Manifold& found) {
  const Vec3d n = at_b.orientation.z;
  const double height = dot(n, at_b.position);
  bool any = false;
  const auto emit = [&](std::uint32_t feature, const Vec3d& point, double) {
    const double depth = height - dot(n, point);
    if (!(depth > 0)) return;
    if (!any) begin({n, depth}, found);
    any = true;
    found.points[found.count++] = {point + 0.5 * depth * n, depth, feature};
  };
  const LowPoints points{at_a.position, at_a.orientation, n, height};
  std::visit([&](const auto& shape) { points(shape, emit); }, a);
  if (found.count == Manifold::most_points && std::holds_alternative<Convex>(a)) {
    const Vec3d lowest = support(a, transposed_times(at_a.orientation, -n));
    finish({n, height - dot(n, at_a.position + at_a.orientation * lowest)}, found);
  }
  return any;
}

}  // namespace murosimf::geometry
