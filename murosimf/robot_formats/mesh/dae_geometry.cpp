#include "murosimf/robot_formats/mesh/dae_geometry.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/mesh/mesh_file.h"

namespace murosimf::robot_formats::mesh {
namespace {

using Place = PicturePlaces::value_type;

struct PlacedCorner {
  std::uint32_t vertex = 0;
  Place place{};  // in a picture
};
using Corners = std::vector<PlacedCorner>;

std::optional<files::XmlElement> child(const files::XmlElement& parent, const char* tag) {
  const auto found = parent.children(tag);
  return found.empty() ? std::nullopt : std::optional(found[0]);
}

files::XmlElement needed(const files::XmlElement& parent, const char* tag) {
  const auto found = child(parent, tag);
  if (!found) parent.fail(fmt::format("<{}> without <{}>; export the mesh again", parent.tag(), tag));
  return *found;
}

/// A small whole number of an attribute; `fallback` if it is not there.
std::size_t whole(const files::XmlElement& element, const char* attribute, std::size_t fallback) {
  const auto text = element.attribute(attribute);
  if (!text) return fallback;
  const auto numbers = files::parse_numbers(*text);
  const bool fits = numbers && numbers->size() == 1 && (*numbers)[0] >= 0 && (*numbers)[0] <= 1e9;
  if (!fits) element.fail(fmt::format("{} '{}' is no count; export the mesh again", attribute, *text));
  return static_cast<std::size_t>((*numbers)[0]);
}

files::XmlElement input_of(const files::XmlElement& owner, const std::string& semantic) {
  for (const files::XmlElement& input : owner.children("input")) {
    if (input.attribute("semantic").value_or("") == semantic) return input;
  }
  owner.fail(fmt::format("<{}> has no {}; export the mesh again", owner.tag(), semantic));
}

/// Calls visit(numbers, index of the first) for each item of a source, of `size` numbers at least.
template <class Visit>
void for_items(const files::XmlElement& source, std::size_t size, const Visit& visit) {
  const auto numbers = dae_numbers(needed(source, "float_array"));
  std::size_t stride = size, offset = 0;
  // Other numbers of a vertex (weights) may stand between its coordinates.
  if (const auto technique = child(source, "technique_common")) {
    const files::XmlElement accessor = needed(*technique, "accessor");
    stride = std::max(whole(accessor, "stride", size), size);
    offset = whole(accessor, "offset", 0);
  }
  MUROSIMF_ASSERT(stride >= size);
  for (std::size_t i = offset; i + size <= numbers.size(); i += stride) visit(numbers, i);
}

std::vector<Vec3d> read_positions(const files::XmlElement& mesh, const DaeIds& ids) {
  std::vector<Vec3d> positions;
  for_items(ids.find(input_of(needed(mesh, "vertices"), "POSITION"), "source"), 3,
            [&](const std::vector<double>& numbers, std::size_t i) {
              positions.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
            });
  return positions;
}

/// The first places in pictures that a primitive refers to, and where their indices stand in its lists.
struct Places {
  std::vector<Place> places;
  std::size_t offset = 0;
};
/// None if they are not understood: they are for the eye only.
Places read_places(const files::XmlElement& primitive, const DaeIds& ids) {
  for (const files::XmlElement& input : primitive.children("input")) {
    if (input.attribute("semantic").value_or("") != "TEXCOORD") continue;
    try {
      Places found;
      found.offset = whole(input, "offset", 0);
      for_items(ids.find(input, "source"), 2, [&](const std::vector<double>& numbers, std::size_t i) {
        const auto right = static_cast<float>(numbers[i]), up = static_cast<float>(numbers[i + 1]);
        const bool finite = std::isfinite(right) && std::isfinite(up);
        found.places.push_back(finite ? Place{right, up} : Place{});
      });
      return found;
    } catch (const SetupError&) {
      return {};
    }
  }
  return {};
}

/// Selects the vertices and places in pictures from the lists of indices of one primitive, which interleave those of normals, too.
class Indices {
 public:
  Indices(const files::XmlElement& primitive, const DaeIds& ids, std::size_t vertices)
      : offset_(whole(input_of(primitive, "VERTEX"), "offset", 0)),
        vertices_(vertices),
        places_(read_places(primitive, ids)) {
    for (const files::XmlElement& input : primitive.children("input")) {
      stride_ = std::max(stride_, 1 + whole(input, "offset", 0));
    }
  }

  [[nodiscard]] Corners read(const files::XmlElement& list) const {
    const auto numbers = dae_numbers(list);
    Corners corners;
    MUROSIMF_ASSERT(stride_ > offset_);
    for (std::size_t i = offset_; i < numbers.size(); i += stride_) {
      const double number = numbers[i];
      if (!(number >= 0 && number < static_cast<double>(vertices_))) {
        list.fail(fmt::format("vertex {} is named, there are {}, counted from 0", number, vertices_));
      }
      corners.push_back({static_cast<std::uint32_t>(number), place_at(numbers, i - offset_ + places_.offset)});
    }
    return corners;
  }

 private:
  [[nodiscard]] Place place_at(const std::vector<double>& numbers, std::size_t i) const {
    if (i >= numbers.size()) return {};
    const double number = numbers[i];
    const bool inside = number >= 0 && number < static_cast<double>(places_.places.size());
    return inside ? places_.places[static_cast<std::size_t>(number)] : Place{};
  }

  std::size_t offset_, stride_ = 1, vertices_;
  Places places_;
};

void add_triangle(DaeGeometry& to, const files::XmlElement& at, const PlacedCorner& a, const PlacedCorner& b,
                  const PlacedCorner& c) {
  if (to.mesh.triangles.size() == most_triangles) at.fail(too_many());
  to.mesh.triangles.push_back({a.vertex, b.vertex, c.vertex});
  to.places.push_back({a.place, b.place, c.place});
}

/// Adds corners `first` to `first + count - 1` as a fan: exact for convex polygons, which exporters write.
void add_fan(DaeGeometry& to, const files::XmlElement& at, const Corners& corners, std::size_t first,
             std::size_t count) {
  if (first + count > corners.size()) at.fail("there are fewer corners than the polygons have; export the mesh again");
  for (std::size_t i = 2; i < count; ++i) {
    MUROSIMF_ASSERT(first + i < corners.size());
    add_triangle(to, at, corners[first], corners[first + i - 1], corners[first + i]);
  }
}

void add_strip(DaeGeometry& to, const files::XmlElement& at, const Corners& corners) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const std::size_t odd = i % 2;  // the order of corners alternates in a strip
    add_triangle(to, at, corners[i - 2 + odd], corners[i - 1 - odd], corners[i]);
  }
}

void add_polylist(DaeGeometry& to, const files::XmlElement& primitive, const Corners& corners) {
  std::size_t first = 0;
  for (const double number : dae_numbers(needed(primitive, "vcount"))) {
    if (!(number >= 0 && number <= static_cast<double>(corners.size()))) primitive.fail("impossible vcount");
    const auto count = static_cast<std::size_t>(number);
    add_fan(to, primitive, corners, first, count);
    first += count;
  }
}

void add_primitive(DaeGeometry& to, const files::XmlElement& primitive, const DaeIds& ids) {
  const std::string tag = primitive.tag();
  const bool surface =
      tag == "triangles" || tag == "polylist" || tag == "polygons" || tag == "tristrips" || tag == "trifans";
  if (!surface) return;
  const Indices indices(primitive, ids, to.mesh.vertices.size());
  if (child(primitive, "ph")) primitive.fail("polygons with holes are not read; export triangles");
  for (const files::XmlElement& list : primitive.children("p")) {
    const Corners corners = indices.read(list);
    if (tag == "triangles") {
      for (std::size_t i = 0; i < corners.size(); i += 3) add_fan(to, list, corners, i, 3);
    } else if (tag == "polylist") {
      add_polylist(to, primitive, corners);
    } else if (tag == "tristrips") {
      add_strip(to, list, corners);
    } else {
      add_fan(to, list, corners, 0, corners.size());
    }
  }
}

}  // namespace

DaeIds::DaeIds(const files::XmlElement& root) {
  std::vector<files::XmlElement> open{root};
  while (!open.empty()) {
    const files::XmlElement element = open.back();
    open.pop_back();
    // Of a repeated id the first element counts; emplace() keeps it.
    if (const auto id = element.attribute("id")) elements_.emplace(*id, element);
    for (const files::XmlElement& inner : element.children()) open.push_back(inner);
  }
}

const files::XmlElement& DaeIds::find(const files::XmlElement& user, const char* attribute) const {
  const std::string url = user.attribute(attribute).value_or("");
  const auto found = elements_.find(url.starts_with('#') ? url.substr(1) : url);
  if (found == elements_.end()) user.fail(fmt::format("{} '{}' is not in the file", attribute, url));
  return found->second;
}

std::optional<files::XmlElement> DaeIds::find(const std::string& id) const {
  const auto found = elements_.find(id);
  return found == elements_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<double> dae_numbers(const files::XmlElement& element, std::size_t count) {
  auto numbers = files::parse_numbers(element.text());
  if (!numbers) element.fail(fmt::format("<{}> holds something that is no finite number", element.tag()));
  if (count > 0 && numbers->size() != count) {
    element.fail(fmt::format("<{}> has {} numbers, it needs {}", element.tag(), numbers->size(), count));
  }
  return *numbers;
}

DaeGeometry read_dae_geometry(const files::XmlElement& geometry, const DaeIds& ids) {
  DaeGeometry result;
  const auto mesh = child(geometry, "mesh");
  if (!mesh) return result;
  result.mesh.vertices = read_positions(*mesh, ids);
  for (const files::XmlElement& primitive : mesh->children()) {
    add_primitive(result, primitive, ids);
    const auto symbol = static_cast<std::uint32_t>(result.symbols.size());
    if (result.symbol_of.size() == result.mesh.triangles.size()) continue;
    result.symbols.push_back(primitive.attribute("material").value_or(""));
    result.symbol_of.resize(result.mesh.triangles.size(), symbol);
  }
  return result;
}

}  // namespace murosimf::robot_formats::mesh
