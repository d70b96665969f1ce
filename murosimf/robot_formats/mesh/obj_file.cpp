#include "murosimf/robot_formats/mesh/obj_file.h"

#include <charconv>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "murosimf/files/text_lines.h"
#include "murosimf/math/assert.h"

namespace murosimf::robot_formats::mesh {
namespace {

constexpr std::size_t most_vertices = 3 * most_triangles;

using Place = PicturePlaces::value_type;

class ObjReader {
 public:
  explicit ObjReader(const std::filesystem::path& path) : lines_(path, true) {
    while (lines_.next()) {
      const auto word = lines_.word();
      if (word == "v") read_vertex();
      if (word == "vt") read_place();
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

  /// A line that is none counts as one: places in pictures are for the eye only.
  void read_place() {
    if (places_.size() == most_vertices) return;
    Place place{};
    for (float& number : place) {
      const std::string_view text = lines_.word();
      float value = 0;
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      if (error == std::errc() && std::isfinite(value)) number = value;
    }
    places_.push_back(place);
  }

  struct Corner {
    std::uint32_t vertex = 0;
    Place place{};
  };

  /// Adds a polygon as a fan. Corners like 3, 3/1, 3//2 or -1/-1/-1: the first number is the vertex, the second one its place in a picture.
  void read_face() {
    Corner first, last;
    std::size_t corners = 0;
    for (auto text = lines_.word(); !text.empty() && text.front() != '#'; text = lines_.word()) {
      const Corner corner{vertex_number(text), place_of(text)};
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

  /// The one of a corner; where there is none, the lower left corner of the picture.
  [[nodiscard]] Place place_of(std::string_view text) const {
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) return {};
    const auto count = static_cast<long long>(places_.size());
    long long number = 0;
    std::from_chars(text.data() + slash + 1, text.data() + text.size(), number);
    if (number < 0) number += count + 1;
    return number >= 1 && number <= count ? places_[static_cast<std::size_t>(number - 1)] : Place{};
  }

  void add_triangle(const Corner& a, const Corner& b, const Corner& c) {
    auto& triangles = result.mesh.triangles;
    if (triangles.size() == most_triangles) lines_.fail(too_many());
    triangles.push_back({a.vertex, b.vertex, c.vertex});
    if (!places_.empty()) {
      result.picture_places.resize(triangles.size() - 1);
      result.picture_places.push_back({a.place, b.place, c.place});
    }
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
  std::vector<Place> places_;                                    // in pictures
  std::map<std::string, std::uint32_t, std::less<>> materials_;  // their numbers, from 1
  std::uint32_t material_ = 0;                                   // at present; 0: none
};

}  // namespace

MeshFile read_obj(const std::filesystem::path& path) { return ObjReader(path).result; }

}  // namespace murosimf::robot_formats::mesh
