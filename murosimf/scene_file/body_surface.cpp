#include "murosimf/scene_file/body_surface.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/collision/relief/height_field.h"
#include "murosimf/files/data_path.h"
#include "murosimf/files/height_file.h"
#include "murosimf/geometry/hull.h"
#include "murosimf/geometry/mesh_mass.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/mesh/mesh_file.h"
#include "murosimf/robot_formats/mesh/mesh_library.h"
#include "murosimf/scene_file/section_readers.h"

namespace murosimf::scene_file {
namespace {

using files::HeightTable;

constexpr double farthest = 1e3;                 // [m] of a surface from its middle
constexpr std::size_t most_triangles = 200'000;  // of ground: each becomes a shape of its own
constexpr double usual_base = 0.1;               // [m]

std::filesystem::path find_file(const files::TomlTable& table, const std::filesystem::path& folder) {
  std::string name;
  table.read("file", name);
  require(!name.empty(), table, "file", "is empty");
  return with_context(table.where("file"), [&] { return files::find_data_file(name, "models", "", folder); });
}

double read_positive(const files::TomlTable& table, std::string_view key, double value) {
  table.read(key, value);
  require(value > 0 && value <= farthest, table, key, "must be above 0, and no more than 1000");
  return value;
}

HeightTable read_numbers(const files::TomlTable& table) {
  const toml::array* rows = table.find("heights")->as_array();
  HeightTable heights;
  for (std::size_t i = 0; rows && i < rows->size(); ++i) {
    const auto row = files::numbers_of(*rows->get(i));
    require(row && rows->get(i)->is_array(), table, "heights", "must be rows of numbers: [[0, 0.1], [0, 0]]");
    require(i == 0 || row->size() == heights.columns, table, "heights", "has rows of different lengths");
    heights.columns = row->size();
    heights.heights.insert(heights.heights.end(), row->begin(), row->end());
    ++heights.rows;
  }
  MUROSIMF_ASSERT(heights.heights.size() == heights.rows * heights.columns);
  files::check_heights(fmt::format("{}: 'heights'", table.where("heights")), heights);
  return heights;
}

HeightTable read_heights(const files::TomlTable& table, const std::filesystem::path& folder) {
  const bool has_file = table.find("file") != nullptr, has_numbers = table.find("heights") != nullptr;
  require(has_file != has_numbers, table, "file",
          has_file ? "and 'heights' say the same; keep one"
                   : "of the heights is missing: PNG, NPY or CSV; or 'heights'");
  if (has_numbers) return read_numbers(table);
  const auto file = find_file(table, folder);
  return with_context(table.where("file"), [&] { return files::read_height_file(file); });
}

/// Reverses the triangles of a closed mesh that is inside out. For an open one the sign of its area from above decides.
void turn_outwards(const files::TomlTable& table, const BodySpec& body, geometry::TriangleMesh& mesh) {
  if (geometry::find_seams(mesh).closed()) {
    if (geometry::solid_mass(mesh).volume >= 0) return;
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    return;
  }
  double upwards = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    upwards += cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]).z;
  }
  require(upwards > 0 || body.roll != 0 || body.pitch != 0, table, "file",
          "has a surface that is open and looks downwards: bodies would fall through it; turn its triangles round");
}

void make_ground(const files::TomlTable& table, geometry::TriangleMesh mesh, BodySpec& body) {
  require(mesh.triangles.size() <= most_triangles, table, "file",
          fmt::format("has {} triangles; static bodies may have {}", mesh.triangles.size(), most_triangles));
  turn_outwards(table, body, mesh);
  const collision::Relief::Options options{.thickness = read_positive(table, "thickness", usual_base), .bottom = {}};
  body.relief = with_context(table.where("file"),
                             [&] { return std::make_shared<const collision::Relief>(std::move(mesh), options); });
}

void make_hull(const files::TomlTable& table, const std::filesystem::path& file, double scale,
               const geometry::TriangleMesh& mesh, BodySpec& body) {
  MUROSIMF_ASSERT(scale > 0);
  require(table.find("thickness") == nullptr, table, "thickness", "is nothing that a mesh that moves has");
  geometry::Hull hull = with_context(table.where("file"), [&] { return geometry::make_hull(mesh.vertices); });
  body.center = geometry::solid_mass(hull.hull).center;
  body.shape = Convex{std::make_shared<const ConvexHull>(std::move(hull.hull))};
  body.mesh.emplace();
  body.mesh->file = file.string();
  body.mesh->scale = {scale, scale, scale};
  body.mesh->file_position = (1 / scale) * (hull.middle + body.center);
  body.mesh->color = body.color;
}

}  // namespace

/// Limits are generous; they find sizes in mm.
void read_height_field(const files::TomlTable& table, const std::filesystem::path& folder, BodySpec& body) {
  require(body.is_static, table, "shape", "\"heightfield\" is ground: it needs static = true");
  Vec3d size;
  require(table.find("size") != nullptr, table, "size", "is missing: of the height field, [x, y] in m");
  table.read("size", size);
  require(size.x > 0 && size.y > 0 && size.z == 0, table, "size",
          "of a height field must be two numbers above 0: [x, y] in m");
  require(norm(size) <= farthest, table, "size", "is more than 1000 m");
  const HeightTable heights = read_heights(table, folder);
  double scale = 1;
  table.read("height_scale", scale);
  collision::HeightField field{heights.rows, heights.columns, heights.heights,
                               size.x,       size.y,          read_positive(table, "thickness", usual_base)};
  for (double& height : field.heights) {
    height *= scale;
    require(std::abs(height) <= farthest, table, "height_scale", "makes a height of more than 1000 m");
  }
  body.relief = with_context(table.where("shape"), [&] { return collision::make_relief(field); });
}

/// Scaled and checked before use: files in mm are the usual mistake.
void read_mesh(const files::TomlTable& table, const std::filesystem::path& folder, BodySpec& body) {
  require(table.find("file") != nullptr, table, "file", "of the mesh is missing: STL, OBJ or DAE");
  const auto file = find_file(table, folder);
  auto mesh = with_context(table.where("file"), [&] { return robot_formats::mesh::read_mesh_file(file).mesh; });
  const double scale = read_positive(table, "scale", 1);
  robot_formats::mesh::scale_mesh(mesh, {scale, scale, scale});
  const auto is_far = [](const Vec3d& v) { return !(norm(v) <= farthest); };
  require(std::ranges::none_of(mesh.vertices, is_far), table, "file",
          "reaches farther than 1000 m; is it in mm ('scale')?");
  if (body.is_static) {
    make_ground(table, std::move(mesh), body);
  } else {
    make_hull(table, file, scale, mesh, body);
  }
}

}  // namespace murosimf::scene_file
