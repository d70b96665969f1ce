#include "murosimf/robot_formats/mesh/dae_file.h"

#include <cmath>
#include <map>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/mesh/dae_geometry.h"
#include "murosimf/robot_formats/mesh/dae_material.h"

namespace murosimf::robot_formats::mesh {
namespace {

// Nodes and geometries can be referred to any number of times: the budget counts each use.
constexpr std::size_t most_elements = 1'000'000;
constexpr std::size_t most_vertices = 3 * most_triangles;

/// v becomes turn v + shift; the turn may scale.
struct Affine {
  Mat3d turn;
  Vec3d shift;
};

Affine operator*(const Affine& a, const Affine& b) { return {a.turn * b.turn, a.turn * b.shift + a.shift}; }

Affine read_step(const files::XmlElement& element) {
  const std::string tag = element.tag();
  if (tag == "matrix") {
    const auto m = dae_numbers(element, 16);  // by rows
    return {{{m[0], m[4], m[8]}, {m[1], m[5], m[9]}, {m[2], m[6], m[10]}}, {m[3], m[7], m[11]}};
  }
  if (tag == "translate") {
    const auto v = dae_numbers(element, 3);
    return {{}, {v[0], v[1], v[2]}};
  }
  if (tag == "scale") {
    const auto v = dae_numbers(element, 3);
    return {{{v[0], 0, 0}, {0, v[1], 0}, {0, 0, v[2]}}, {}};
  }
  if (tag != "rotate") return {};
  const auto v = dae_numbers(element, 4);  // axis, angle [deg]
  const Vec3d axis{v[0], v[1], v[2]};
  if (!(norm(axis) > 1e-12)) return {};  // some exporters write a rotation about nothing
  return {rotation((1.0 / norm(axis)) * axis, v[3] * pi / 180.0), {}};
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : xml_(file), ids_(xml_.root()) {}

  MeshFile read() {
    const files::XmlElement root = xml_.root();
    if (root.tag() != "COLLADA") root.fail(fmt::format("the root is <{}>, not <COLLADA>", root.tag()));
    const double unit = read_unit(root);
    // The unit of length is the outermost transformation, so that translations of nodes are scaled with it.
    const Affine frame{{{unit, 0, 0}, {0, unit, 0}, {0, 0, unit}}, {}};
    for (const files::XmlElement& scene : root.children("scene")) {
      for (const files::XmlElement& instance : scene.children("instance_visual_scene")) {
        for (const files::XmlElement& node : ids_.find(instance, "url").children("node")) add_node(node, frame);
      }
    }
    return std::move(file_);
  }

 private:
  /// [m] Unit of length of the file.
  static double read_unit(const files::XmlElement& root) {
    for (const files::XmlElement& asset : root.children("asset")) {
      for (const files::XmlElement& unit : asset.children("unit")) {
        const auto meter = files::parse_numbers(unit.attribute("meter").value_or("1"));
        if (!meter || meter->size() != 1 || !((*meter)[0] > 0)) unit.fail("meter of <unit> is no length; correct it");
        return (*meter)[0];
      }
    }
    return 1;
  }

  void add_node(const files::XmlElement& node, Affine frame, int depth = 0) {
    MUROSIMF_ASSERT(depth >= 0);
    const auto children = node.children();
    elements_ += 1 + children.size();
    // Nodes may refer to each other in a circle, and a tree of references grows exponentially.
    if (elements_ > most_elements || depth > 200) node.fail("the nodes of the file never end; export the mesh again");
    // All transformations of a node apply to all of its children, whatever their order in the file.
    for (const files::XmlElement& child : children) frame = frame * read_step(child);
    for (const files::XmlElement& child : children) {
      const std::string tag = child.tag();
      if (tag == "node") add_node(child, frame, depth + 1);
      if (tag == "instance_node") add_node(ids_.find(child, "url"), frame, depth + 1);
      if (tag == "instance_geometry") add_geometry(ids_.find(child, "url"), frame, bound_materials(child, ids_));
    }
  }

  void add_geometry(const files::XmlElement& geometry, const Affine& frame,
                    const std::map<std::string, MeshMaterial>& bound) {
    auto known = geometries_.find(geometry.id());
    if (known == geometries_.end()) {
      known = geometries_.emplace(geometry.id(), read_dae_geometry(geometry, ids_)).first;
    }
    const geometry::TriangleMesh& mesh = known->second.mesh;
    auto& vertices = file_.mesh.vertices;
    auto& triangles = file_.mesh.triangles;
    if (vertices.size() + mesh.vertices.size() > most_vertices) {
      geometry.fail(fmt::format("the mesh has more than {} vertices; simplify it", most_vertices));
    }
    if (triangles.size() + mesh.triangles.size() > most_triangles) geometry.fail(too_many());
    file_.part_begin.push_back(triangles.size());
    const auto base = static_cast<std::uint32_t>(vertices.size());
    for (const Vec3d& v : mesh.vertices) {
      vertices.push_back(frame.turn * v + frame.shift);
      if (!std::isfinite(norm(vertices.back()))) geometry.fail("its nodes scale the mesh beyond all numbers");
    }
    // A reflection turns the surface inside out: the other order of corners turns it back.
    const bool mirrored = dot(frame.turn.x, cross(frame.turn.y, frame.turn.z)) < 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      MUROSIMF_ASSERT(a < mesh.vertices.size() && b < mesh.vertices.size() && c < mesh.vertices.size());
      triangles.push_back({base + a, base + (mirrored ? c : b), base + (mirrored ? b : c)});
    }
    for (const auto& [a, b, c] : known->second.places)
      file_.picture_places.push_back({a, mirrored ? c : b, mirrored ? b : c});
    add_materials(known->second, bound);
    if (mesh.triangles.empty()) file_.part_begin.pop_back();  // every part begins with a triangle
  }

  /// Of the triangles that were added last.
  void add_materials(const DaeGeometry& geometry, const std::map<std::string, MeshMaterial>& bound) {
    std::vector<std::uint32_t> numbers;
    for (const std::string& symbol : geometry.symbols) {
      const auto material = bound.find(symbol);
      numbers.push_back(material == bound.end() ? 0 : number_of(material->second));
    }
    for (const std::uint32_t symbol : geometry.symbol_of) file_.material_of.push_back(numbers[symbol]);
    MUROSIMF_ASSERT(file_.material_of.size() == file_.mesh.triangles.size());
  }

  /// From 1.
  std::uint32_t number_of(const MeshMaterial& material) {
    const auto known = numbers_.emplace(material.name, static_cast<std::uint32_t>(file_.materials.size() + 1));
    if (known.second) file_.materials.push_back(material);
    return known.first->second;
  }

  files::XmlFile xml_;
  DaeIds ids_;
  std::map<std::string, std::uint32_t> numbers_;   // of materials
  std::map<const void*, DaeGeometry> geometries_;  // as read, without the frames of their nodes
  MeshFile file_;
  std::size_t elements_ = 0;
};

}  // namespace

MeshFile read_dae(const std::filesystem::path& file) { return Reader(file).read(); }

bool has_y_up(const std::filesystem::path& file) {
  const files::XmlFile xml(file);
  for (const files::XmlElement& asset : xml.root().children("asset")) {
    for (const files::XmlElement& axis : asset.children("up_axis")) return axis.text() == "Y_UP";
  }
  return true;  // the default of the format
}

}  // namespace murosimf::robot_formats::mesh
