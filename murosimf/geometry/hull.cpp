#include "murosimf/geometry/hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "murosimf/geometry/mesh_mass.h"
#include "murosimf/geometry/qhull_faces.h"
#include "murosimf/model/error.h"

namespace murosimf::geometry {
namespace {

using Face = std::vector<std::uint32_t>;

/// Twice the area of a polygon along its normal (Newell: the mean of its projections).
Vec3d area_vector(const std::vector<Vec3d>& vertices, const Face& face) {
  Vec3d sum;
  const Vec3d& start = vertices[face[0]];
  for (std::size_t i = 2; i < face.size(); ++i) {
    sum += cross(vertices[face[i - 1]] - start, vertices[face[i]] - start);
  }
  return sum;
}

/// Renumbers the corners: used points only, in the order of the list.
std::vector<Vec3d> used_points(std::vector<Face>& faces, const std::vector<Vec3d>& points) {
  std::map<std::uint32_t, std::uint32_t> number;
  for (const Face& face : faces) {
    for (const std::uint32_t corner : face) number[corner] = 0;
  }
  std::vector<Vec3d> used;
  for (auto& [point, mine] : number) {
    mine = static_cast<std::uint32_t>(used.size());
    used.push_back(points[point]);
  }
  for (Face& face : faces) {
    for (std::uint32_t& corner : face) corner = number.at(corner);
  }
  return used;
}

/// Counterclockwise seen from outside, the lowest corner first. `inside` is a point of the hull.
void orient(Face& face, const std::vector<Vec3d>& vertices, const Vec3d& inside) {
  if (dot(area_vector(vertices, face), vertices[face[0]] - inside) < 0) std::ranges::reverse(face);
  std::rotate(face.begin(), std::ranges::min_element(face), face.end());
}

/// Neighbor lists from the edges of the faces. False if an edge is not run through once in each direction.
bool add_neighbors(ConvexHull& hull) {
  std::set<std::array<std::uint32_t, 2>> edges;
  for (const Face& face : hull.faces) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      if (!edges.insert({face[i], face[(i + 1) % face.size()]}).second) return false;
    }
  }
  hull.first_neighbor.assign(hull.vertices.size() + 1, 0);
  hull.neighbors.clear();
  for (const auto& [from, to] : edges) {
    if (!edges.contains({to, from})) return false;
    ++hull.first_neighbor[from + 1];
    hull.neighbors.push_back(to);
  }
  for (std::size_t i = 1; i < hull.first_neighbor.size(); ++i) hull.first_neighbor[i] += hull.first_neighbor[i - 1];
  return true;
}

/// V - E + F = 2 (Euler), where neighbors lists every edge twice.
bool is_sphere_like(const ConvexHull& hull) {
  return 2 * (hull.vertices.size() + hull.faces.size()) == hull.neighbors.size() + 4;
}

/// Coordinates for qhull, of size 1 to 2; a power of two changes no digit.
std::vector<double> scaled(const std::vector<Vec3d>& points, double half) {
  const double scale = std::ldexp(1.0, -std::ilogb(half));
  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Vec3d& p : points) coordinates.insert(coordinates.end(), {scale * p.x, scale * p.y, scale * p.z});
  return coordinates;
}

/// How far a corner of face `i` lies inside the line of the corners beside it [m].
double dent(const ConvexHull& hull, std::size_t i) {
  const Face& face = hull.faces[i];
  double deepest = 0;
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Vec3d& before = hull.vertices[face[k]];
    const Vec3d& here = hull.vertices[face[(k + 1) % face.size()]];
    const Vec3d& behind = hull.vertices[face[(k + 2) % face.size()]];
    const double bend = dot(hull.normals[i], cross(here - before, behind - here));
    deepest = std::max(deepest, -bend / norm(behind - before));
  }
  return deepest;
}

/// How far the neighbors of its corners stand out of face `i` [m].
double bulge(const ConvexHull& hull, std::size_t i) {
  double highest = 0;
  for (const std::uint32_t corner : hull.faces[i]) {
    for (std::uint32_t k = hull.first_neighbor[corner]; k < hull.first_neighbor[corner + 1]; ++k) {
      const Vec3d from_face = hull.vertices[hull.neighbors[k]] - hull.vertices[hull.faces[i][0]];
      highest = std::max(highest, dot(hull.normals[i], from_face));
    }
  }
  return highest;
}

/// Convex everywhere, but for `tolerance` [m].
bool is_convex(const ConvexHull& hull, double tolerance) {
  for (std::size_t i = 0; i < hull.faces.size(); ++i) {
    if (!(dent(hull, i) <= tolerance && bulge(hull, i) <= tolerance)) return false;
  }
  return true;
}

/// The hull that one run gives; nothing if that is no proper polyhedron.
std::optional<ConvexHull> try_hull(const std::vector<Vec3d>& points, std::vector<double>& coordinates,
                                   const std::string& options) {
  auto faces = qhull_faces(coordinates, options);
  if (!faces || faces->empty()) return std::nullopt;
  ConvexHull hull;
  hull.vertices = used_points(*faces, points);
  Vec3d inside;
  for (const Vec3d& vertex : hull.vertices) inside += (1.0 / static_cast<double>(hull.vertices.size())) * vertex;
  for (Face& face : *faces) orient(face, hull.vertices, inside);
  std::ranges::sort(*faces);
  hull.faces = std::move(*faces);
  for (const Face& face : hull.faces) {
    const Vec3d area = area_vector(hull.vertices, face);
    hull.normals.push_back((1.0 / norm(area)) * area);
  }
  if (!add_neighbors(hull) || !is_sphere_like(hull)) return std::nullopt;
  return hull;
}

/// The first run that gives a convex polyhedron: planes joined; where rounding leaves dents in joined planes, those that
/// are planes to the last digit; triangles.
std::optional<ConvexHull> find_hull(const std::vector<Vec3d>& points, double half) {
  auto coordinates = scaled(points, half);
  if (points.size() > many_points) {
    const double outside = thinning * std::ldexp(half, -std::ilogb(half));
    auto hull = try_hull(points, coordinates, fmt::format("qhull C-0 W{:.6e}", outside));
    if (hull && is_convex(*hull, 4 * plane_tolerance * half)) return hull;
  }
  for (const std::string& options :
       {fmt::format("qhull C-0 C{:.0e}", plane_tolerance), std::string("qhull"), std::string("qhull Qt")}) {
    auto hull = try_hull(points, coordinates, options);
    if (hull && is_convex(*hull, 4 * plane_tolerance * half)) return hull;
  }
  return std::nullopt;
}

/// Thickness of the plate that spreads its mass as wide as the hull does across its thinnest direction [m].
double thickness(const ConvexHull& hull) {
  const SolidMass solid = solid_mass(hull);
  const SymMat3d& I = solid.inertia;
  // second moments: half the trace of the inertia less the inertia
  const double half_trace = 0.5 * (I.xx + I.yy + I.zz);
  Eigen::Matrix3d moments;
  moments << half_trace - I.xx, -I.xy, -I.xz, -I.xy, half_trace - I.yy, -I.yz, -I.xz, -I.yz, half_trace - I.zz;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments, Eigen::EigenvaluesOnly);
  return std::sqrt(12.0 * solver.eigenvalues()[0] / solid.volume);
}

struct Extent {
  Vec3d low, high;

  explicit Extent(std::span<const Vec3d> points) : low(points[0]), high(points[0]) {
    for (const Vec3d& p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  [[nodiscard]] Vec3d middle() const { return 0.5 * (low + high); }
  [[nodiscard]] double half() const { return 0.5 * std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }
};

void check(std::span<const Vec3d> points) {
  if (points.size() < 4)
    throw SetupError(fmt::format("{} points enclose nothing; at least 4 are needed", points.size()));
  for (const Vec3d& p : points) {
    // sums of squares must not overflow
    if (!(std::fabs(p.x) < 1e100 && std::fabs(p.y) < 1e100 && std::fabs(p.z) < 1e100)) {
      throw SetupError(fmt::format("point ({}, {}, {}) is not finite", p.x, p.y, p.z));
    }
  }
}

}  // namespace

Hull make_hull(std::span<const Vec3d> points) {
  check(points);
  const Extent extent(points);
  if (!(extent.half() > 1e-100)) throw SetupError("all points lie at one place; a hull needs a volume");
  std::vector<Vec3d> shifted;
  shifted.reserve(points.size());
  for (const Vec3d& p : points) shifted.push_back(p - extent.middle());
  auto hull = find_hull(shifted, extent.half());
  if (!hull || !(thickness(*hull) > least_thickness * extent.half())) {
    throw SetupError("the points lie in a plane; a hull needs a volume");
  }
  return {std::move(*hull), extent.middle(), points.size() > many_points ? thinning * extent.half() : 0};
}

}  // namespace murosimf::geometry
