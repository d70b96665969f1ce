#include "murosimf/robot_formats/mesh/mesh_library.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/geometry/hull.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::robot_formats::mesh {
namespace {

constexpr double concave_ratio = 1.1;  // [1] hull over mesh volume, above which contact differs visibly
constexpr double most_width = 20;      // [m] wider than any robot: the file is in millimeters

ConvexPart make_part(const geometry::TriangleMesh& mesh) {
  auto [hull, middle, error] = geometry::make_hull(mesh.vertices);
  MUROSIMF_ASSERT(!hull.vertices.empty());
  return {{std::make_shared<const ConvexHull>(std::move(hull))}, middle, error};
}

geometry::SolidMass part_mass(const ConvexPart& part) {
  auto solid = geometry::solid_mass(*part.shape.hull);
  solid.center += part.middle;
  return solid;
}

double width(const std::vector<Vec3d>& vertices) {
  double largest = 0;
  for (const Vec3d& v : vertices) largest = std::max(largest, norm(v - vertices[0]));
  return largest;
}

void doubt_surface(const SolidMesh& mesh, std::vector<std::string>& doubts) {
  // An open surface has no volume that could be compared with the hull's.
  if (!mesh.seams.closed()) {
    doubts.push_back(
        fmt::format("the mesh is not closed ({} open edges, {} between triangles that look different ways); "
                    "contact sees its convex hull",
                    mesh.seams.open, mesh.seams.flipped));
    return;
  }
  const double ratio = hull_mass(mesh.parts).volume / std::fabs(geometry::solid_mass(mesh.triangles).volume);
  if (ratio > concave_ratio) {
    doubts.push_back(
        fmt::format("the mesh is concave: contact sees its convex hull, {:.3g} times its volume; where that matters, "
                    "split it into convex parts",
                    ratio));
  }
}

}  // namespace

void scale_mesh(geometry::TriangleMesh& mesh, const Vec3d& scale) {
  for (Vec3d& v : mesh.vertices) v = {scale.x * v.x, scale.y * v.y, scale.z * v.z};
  // An odd number of mirrored axes turns the surface inside out.
  const bool mirrored = (scale.x < 0) != ((scale.y < 0) != (scale.z < 0));
  if (!mirrored) return;
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  for (auto& places : mesh.places) std::swap(places[1], places[2]);
}

SolidMesh make_solid_mesh(MeshFile file, bool part_per_group) {
  SolidMesh mesh;
  try {
    if (part_per_group) {
      for (const auto& part : split_parts(file)) mesh.parts.push_back(make_part(part));
    } else {
      mesh.parts.push_back(make_part(file.mesh));
    }
  } catch (const SetupError& error) {
    mesh.parts.clear();  // a flat mesh may still be drawn: the reason is kept for those that collide
    mesh.flat = error.what();
  }
  mesh.triangles = std::move(file.mesh);
  mesh.seams = geometry::find_seams(mesh.triangles);
  return mesh;
}

geometry::SolidMass hull_mass(const std::vector<ConvexPart>& parts) {
  geometry::SolidMass sum;
  for (const ConvexPart& part : parts) {
    const auto solid = part_mass(part);
    sum.volume += solid.volume;
    sum.center += solid.volume * solid.center;
  }
  MUROSIMF_ASSERT(sum.volume > 0);
  sum.center = (1.0 / sum.volume) * sum.center;
  for (const ConvexPart& part : parts) {
    const auto solid = part_mass(part);
    sum.inertia += solid.inertia + solid.volume * inertia_of_point(solid.center - sum.center);
  }
  return sum;
}

std::vector<std::string> mesh_doubts(const SolidMesh& mesh) {
  std::vector<std::string> doubts;
  if (const double size = width(mesh.triangles.vertices); size > most_width) {
    doubts.push_back(fmt::format("it is {:.4g} m wide; a file in millimeters needs scale=\"0.001 0.001 0.001\"", size));
  }
  doubt_surface(mesh, doubts);
  for (const ConvexPart& part : mesh.parts) {
    const std::size_t count = part.shape.hull->vertices.size();
    if (count > geometry::many_vertices) {
      const std::string thinned =
          part.error > 0
              ? fmt::format(" although it leaves out what stands out by less than {:.2g} mm", 1e3 * part.error)
              : "";
      doubts.push_back(fmt::format("its hull has {} vertices{}, which slows contact down; simplify it ({} are plenty)",
                                   count, thinned, geometry::many_vertices));
    }
  }
  return doubts;
}

const SolidMesh& MeshLibrary::get(const std::filesystem::path& file, const Vec3d& scale, bool part_per_group) {
  const std::pair key{file, std::array{scale.x, scale.y, scale.z}};
  if (const auto found = meshes_.find(key); found != meshes_.end()) return found->second;
  if (scale.x == 0 || scale.y == 0 || scale.z == 0) throw SetupError("a scale of 0 makes the mesh flat; correct it");
  MeshFile read = read_mesh_file(file);
  scale_mesh(read.mesh, scale);
  return meshes_.emplace(key, make_solid_mesh(std::move(read), part_per_group)).first->second;
}

}  // namespace murosimf::robot_formats::mesh
