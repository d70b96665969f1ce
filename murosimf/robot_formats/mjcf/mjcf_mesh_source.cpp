#include "murosimf/robot_formats/mjcf/mjcf_mesh_source.h"

#include <fmt/format.h>

#include "murosimf/geometry/hull.h"
#include "murosimf/geometry/mesh_mass.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/mesh/mesh_library.h"

namespace murosimf::robot_formats::mjcf {
namespace {

std::vector<Vec3d> read_vertices(const MjcfAttributes& attributes) {
  const auto numbers = attributes.numbers("vertex", 12, 9 * robot_formats::mesh::most_triangles);
  if (numbers.size() % 3 != 0) {
    attributes.source("vertex").fail(fmt::format("vertex has {} numbers; each vertex needs three", numbers.size()));
  }
  std::vector<Vec3d> vertices;
  for (std::size_t i = 0; i < numbers.size(); i += 3) {
    vertices.push_back(
        {numbers[i] + 0.0, numbers[i + 1] + 0.0, numbers[i + 2] + 0.0});  // no -0: vertices are merged by value
  }
  return vertices;
}

std::uint32_t read_corner(const MjcfAttributes& attributes, double number, std::size_t vertices) {
  const bool inside = number >= 0 && number < static_cast<double>(vertices);
  if (!inside || number != static_cast<std::uint32_t>(number)) {
    attributes.source("face").fail(fmt::format("face names vertex {}; there are {}, counted from 0", number, vertices));
  }
  return static_cast<std::uint32_t>(number);
}

}  // namespace

std::string mesh_name(const MjcfAttributes& attributes) {
  if (attributes.has("name")) return attributes.text("name");
  if (!attributes.has("file")) attributes.element().fail("mesh without name and file; give it a name");
  return std::filesystem::path(attributes.text("file")).stem().string();
}

robot_formats::mesh::MeshFile read_inline_mesh(const MjcfAttributes& attributes) {
  robot_formats::mesh::MeshFile file;
  file.part_begin = {0};
  file.mesh.vertices = read_vertices(attributes);
  const auto corners = attributes.numbers("face", 3, 3 * robot_formats::mesh::most_triangles);
  if (corners.size() % 3 != 0) {
    attributes.source("face").fail(fmt::format("face has {} numbers; each triangle needs three", corners.size()));
  }
  const auto corner = [&](std::size_t i) { return read_corner(attributes, corners[i], file.mesh.vertices.size()); };
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    file.mesh.triangles.push_back({corner(i), corner(i + 1), corner(i + 2)});
    MUROSIMF_ASSERT(corners.size() % 3 == 0);
  }
  // Vertices without faces stand for their hull.
  if (corners.empty()) {
    const auto [hull, middle, error] = geometry::make_hull(file.mesh.vertices);
    file.mesh = geometry::triangles_of(hull);
    for (Vec3d& vertex : file.mesh.vertices) vertex += middle;
  }
  geometry::merge_vertices(file.mesh);
  return file;
}

void place_mesh(geometry::TriangleMesh& mesh, const MjcfAttributes& attributes) {
  const Vec3d scale = attributes.vector("scale", {1, 1, 1});
  if (scale.x == 0 || scale.y == 0 || scale.z == 0) {
    attributes.source("scale").fail(
        fmt::format("scale '{}' of mesh makes it flat; no number of it may be 0", attributes.text("scale")));
  }
  const Vec3d origin = attributes.vector("refpos", {});
  const Mat3d turn = read_quaternion(attributes, "refquat");
  // In this order, as MuJoCo does it: the reference pose is in the units of the file.
  for (Vec3d& vertex : mesh.vertices) vertex = transposed_times(turn, vertex - origin);
  robot_formats::mesh::scale_mesh(mesh, scale);
}

}  // namespace murosimf::robot_formats::mjcf
