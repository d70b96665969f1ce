#include "murosimf/robot_formats/mesh/obj_file.h"

#include <charconv>
#include <map>
#include <string>

#include <fmt/format.h>

#include "murosimf/files/text_lines.h"
#include "murosimf/math/assert.h"

namespace murosimf::robot_formats::mesh {
namespace {

constexpr std::size_t most_vertices = 3 * most_triangles;

class ObjReader {
 public:
  explicit ObjReader(const std::filesystem::path& path) : lines_(path, true) {
    while (lines_.next()) {
      const auto word = lines_.word();
      if (word == "v") read_vertex();
      if (word == "f") read_face();
      if (word == "o" || word == "g") begin_part();
      if (word == "usemtl") use_material(lines_.word());
    }
  }

  MeshFile result;

 private:
  void read_vertex() {
    if (result.mesh.vertices.size() == most_vertices) {
      lines_.fail(fmt::format("the mesh has more than {} vertices; simplify it", most_vertices));
    }
    Vec3d vertex;
    vertex.x = lines_.number("vertex");
    vertex.y = lines_.number("vertex");
    vertex.z = lines_.number("vertex");
    result.mesh.vertices.push_back(vertex);
  }

  /// Adds a polygon as a fan. Corners like 3, 3/1, 3//2 or -1/-1/-1: the first number is the vertex.
  void read_face() {
    std::uint32_t first = 0, last = 0;
    std::size_t corners = 0;
    for (auto text = lines_.word(); !text.empty() && text.front() != '#'; text = lines_.word()) {
      const std::uint32_t corner = vertex_number(text);
      if (++corners == 1) first = corner;
      if (corners >= 3) add_triangle(first, last, corner);
      last = corner;
    }
    if (corners < 3) lines_.fail(fmt::format("a face of {} vertices; it needs three or more", corners));
  }

  [[nodiscard]] std::uint32_t vertex_number(std::string_view text) const {
    const std::string_view digits = text.substr(0, text.find('/'));
    const auto count = static_cast<long long>(result.mesh.vertices.size());
    // Negative numbers count back from the last vertex so far.
    long long number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error == std::errc::invalid_argument || end != digits.data() + digits.size()) {
      lines_.fail(fmt::format("{} in a face is not a vertex number", files::quoted(text)));
    }
    const bool inside = error == std::errc() && ((number > 0 && number <= count) || (number < 0 && number >= -count));
    if (!inside) {
      lines_.fail(
          fmt::format("the face names vertex {}, but {} vertices stand before it", files::quoted(digits), count));
    }
    MUROSIMF_ASSERT(inside);
    return static_cast<std::uint32_t>(number > 0 ? number - 1 : count + number);
  }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    auto& triangles = result.mesh.triangles;
    if (triangles.size() == most_triangles) lines_.fail(too_many());
    triangles.push_back({a, b, c});
    if (material_ == 0) return;
    result.material_of.resize(triangles.size() - 1);
    result.material_of.push_back(material_);
  }

  void use_material(std::string_view name) {
    const auto known = materials_.emplace(name, static_cast<std::uint32_t>(result.materials.size() + 1));
    if (known.second) result.materials.push_back({.name = std::string(name)});
    material_ = known.first->second;
  }

  void begin_part() {
    // An object and its first group begin at the same triangle: one part.
    const std::size_t here = result.mesh.triangles.size();
    if (result.part_begin.empty() || result.part_begin.back() != here) result.part_begin.push_back(here);
  }

  files::TextLines lines_;
  std::map<std::string, std::uint32_t, std::less<>> materials_;  // their numbers, from 1
  std::uint32_t material_ = 0;                                   // at present; 0: none
};

}  // namespace

MeshFile read_obj(const std::filesystem::path& path) { return ObjReader(path).result; }

}  // namespace murosimf::robot_formats::mesh
