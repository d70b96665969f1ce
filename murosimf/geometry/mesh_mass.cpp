#include "murosimf/geometry/mesh_mass.h"

#include <cmath>

namespace murosimf::geometry {
namespace {

/// Sums of mass, mass times place, and inertia about the origin.
struct Sums {
  double mass = 0;
  Vec3d first;
  SymMat3d second;

  /// A simplex with `count` corners: the three given ones, and the origin if it has four.
  void add(double size, double count, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const Vec3d s = a + b + c;
    mass += size;
    first += (size / count) * s;
    second += (size / (count * (count + 1))) *
              (inertia_of_point(a) + inertia_of_point(b) + inertia_of_point(c) + inertia_of_point(s));
  }
  /// The sums belong to the frame at `pivot`.
  [[nodiscard]] SolidMass about_center(const Vec3d& pivot) const {
    const Vec3d center = (1.0 / mass) * first;
    return {mass, pivot + center, second - mass * inertia_of_point(center)};
  }
};

struct Triangle {
  Vec3d a, b, c;

  [[nodiscard]] double area() const { return 0.5 * norm(cross(b - a, c - a)); }
  /// Six times this is the determinant; of the tetrahedron with the origin.
  [[nodiscard]] double volume() const { return dot(a, cross(b, c)) / 6.0; }
};

/// Calls f(triangle) with corners seen from `pivot`.
template <class F>
void for_each_triangle(const TriangleMesh& mesh, const Vec3d& pivot, const F& f) {
  for (const auto& [a, b, c] : mesh.triangles) {
    f(Triangle{mesh.vertices[a] - pivot, mesh.vertices[b] - pivot, mesh.vertices[c] - pivot});
  }
}

/// Tetrahedra from `pivot` to every triangle.
Sums tetrahedra(const TriangleMesh& mesh, const Vec3d& pivot, bool all_positive) {
  Sums sums;
  for_each_triangle(mesh, pivot, [&](const Triangle& t) {
    const double volume = t.volume();
    sums.add(all_positive ? std::fabs(volume) : volume, 4, t.a, t.b, t.c);
  });
  return sums;
}

}  // namespace

SolidMass shell_mass(const TriangleMesh& mesh) {
  const Vec3d pivot = mesh.vertices.at(0);
  Sums sums;
  for_each_triangle(mesh, pivot, [&](const Triangle& t) { sums.add(t.area(), 3, t.a, t.b, t.c); });
  return sums.about_center(pivot);
}

SolidMass solid_mass(const TriangleMesh& mesh) {
  // a pivot inside or near keeps the sums free of cancellation
  const Vec3d pivot = shell_mass(mesh).center;
  return tetrahedra(mesh, pivot, false).about_center(pivot);
}

SolidMass summed_mass(const TriangleMesh& mesh) {
  const Vec3d pivot = shell_mass(mesh).center;
  const Vec3d center = tetrahedra(mesh, pivot, true).about_center(pivot).center;
  const Sums sums = tetrahedra(mesh, center, true);
  return {sums.mass, center, sums.second};
}

TriangleMesh triangles_of(const ConvexHull& hull) {
  TriangleMesh mesh{hull.vertices, {}};
  for (const auto& face : hull.faces) {
    for (std::size_t i = 2; i < face.size(); ++i) mesh.triangles.push_back({face[0], face[i - 1], face[i]});
  }
  return mesh;
}

SolidMass solid_mass(const ConvexHull& hull) { return solid_mass(triangles_of(hull)); }

}  // namespace murosimf::geometry
