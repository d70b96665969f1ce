#include "murosimf/robot_formats/mesh/mesh_file.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/files/input_file.h"
#include "murosimf/files/lower_case.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/mesh/dae_file.h"
#include "murosimf/robot_formats/mesh/msh_file.h"
#include "murosimf/robot_formats/mesh/obj_file.h"
#include "murosimf/robot_formats/mesh/stl_file.h"

namespace murosimf::robot_formats::mesh {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view message) {
  throw SetupError(files::one_line(fmt::format("{}: {}", path.string(), message)));
}

/// Size of a regular file that is not empty [byte].
std::size_t checked_size(const std::filesystem::path& path) {
  const auto size = files::check_input_file(path, files::most_mesh_bytes);
  if (size == 0) fail(path, "the mesh file is empty");
  return size;
}

MeshFile read_any(const std::filesystem::path& path) {
  const std::string extension = files::lower_case(path.extension().string());
  const bool known = extension == ".stl" || extension == ".obj" || extension == ".dae" || extension == ".msh";
  if (!known) fail(path, fmt::format("unknown kind of mesh file '{}'; convert it to .stl, .obj or .dae", extension));
  const std::size_t size = checked_size(path);
  if (extension == ".dae") return read_dae(path);
  if (extension == ".msh") return read_msh(path, size);
  return extension == ".stl" ? read_stl(path, size) : read_obj(path);
}

/// Makes every part begin with a triangle, the first one at the first triangle.
void tidy_parts(MeshFile& file) {
  auto& begin = file.part_begin;
  MUROSIMF_ASSERT(std::ranges::is_sorted(begin));
  if (!begin.empty() && begin.back() == file.mesh.triangles.size()) begin.pop_back();
  if (begin.empty() || begin.front() != 0) begin.insert(begin.begin(), 0);
  MUROSIMF_ASSERT(begin.front() == 0 && begin.back() < file.mesh.triangles.size());
}

}  // namespace

std::string too_many(std::size_t count) {
  const std::string have = count > 0 ? std::to_string(count) : fmt::format("more than {}", most_triangles);
  return fmt::format("the mesh has {} triangles, at most {} are read; simplify it", have, most_triangles);
}

MeshFile read_mesh_file(const std::filesystem::path& path) {
  MeshFile file = read_any(path);
  if (file.mesh.triangles.empty()) fail(path, "there are no triangles in the file");
  tidy_parts(file);
  // STL has no shared corners at all: seams and inertia need them.
  geometry::merge_vertices(file.mesh);
  return file;
}

std::vector<geometry::TriangleMesh> split_parts(const MeshFile& file) {
  std::vector<geometry::TriangleMesh> parts;
  const auto& triangles = file.mesh.triangles;
  for (std::size_t i = 0; i < file.part_begin.size(); ++i) {
    const std::size_t end = i + 1 < file.part_begin.size() ? file.part_begin[i + 1] : triangles.size();
    MUROSIMF_ASSERT(file.part_begin[i] <= end && end <= triangles.size());
    const auto at = [&](std::size_t index) { return triangles.begin() + static_cast<std::ptrdiff_t>(index); };
    // All vertices first; merging removes those of other parts, which no triangle uses.
    parts.push_back({file.mesh.vertices, {at(file.part_begin[i]), at(end)}});
    geometry::merge_vertices(parts.back());
  }
  return parts;
}

}  // namespace murosimf::robot_formats::mesh
