#include "murosimf/robot_formats/mjcf/mjcf_geom_writer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/files/lower_case.h"
#include "murosimf/math/assert.h"
#include "murosimf/math/quaternion.h"
#include "murosimf/robot_formats/mesh/mesh_file.h"

namespace murosimf::robot_formats::mjcf {
namespace {

namespace fs = std::filesystem;

constexpr double same_place = 1e-9;  // [m] rounding stays far below it

bool is_mesh_file(const fs::path& file) {
  std::error_code none;
  const std::string extension = files::lower_case(file.extension().string());
  return (extension == ".stl" || extension == ".obj") && fs::is_regular_file(file, none);
}

std::string relative_name(const fs::path& file, const fs::path& folder) {
  const fs::path from = fs::absolute(folder.empty() ? "." : folder);
  return fs::proximate(fs::absolute(file), from).generic_string();
}

/// Adds the size of a shape; a mesh has none.
struct WriteShape {
  files::XmlText& xml;

  void operator()(const Sphere& s) const { xml.numbers("size", {s.radius}); }
  void operator()(const Box& s) const { xml.vector("size", s.half_size); }
  void operator()(const Capsule& s) const { xml.numbers("size", {s.radius, s.half_length}); }
  void operator()(const Cylinder& s) const { xml.numbers("size", {s.radius, s.half_length}); }
  void operator()(const Ellipsoid& s) const { xml.vector("size", s.semi_axes); }
  void operator()(const Plane&) const { xml.numbers("size", {1, 1, 1}); }  // finite: only for drawing
  void operator()(const Convex&) const {}
};

void write_color(files::XmlText& xml, const Color& color) {
  if (color != Color{}) xml.numbers("rgba", {color.red, color.green, color.blue, color.alpha});
}

/// Masks as the format stores them: integers of 32 bits with a sign.
double mask(std::uint32_t bits) { return static_cast<double>(static_cast<std::int32_t>(bits)); }

void write_contact(files::XmlText& xml, const PlacedShape& placed) {
  xml.number_unless(1, "contype", placed.collides ? mask(placed.contact_type) : 0);
  xml.number_unless(1, "conaffinity", placed.collides ? mask(placed.contact_affinity) : 0);
  if (!placed.collides) xml.text("group", "2");  // the group that viewers of MuJoCo show as visuals
  xml.number_unless(1, "friction", placed.surface.friction);
}

/// Place of the mesh that the shape is a part of.
Transformd mesh_place(const robot_formats::ShapeDescription& shape) {
  return shape.placed.place() * Transformd{-shape.middle, {}};
}

/// Whether both are parts of one geom: different parts of the same mesh at the same place.
bool is_same_geom(const robot_formats::ShapeDescription& a, const robot_formats::ShapeDescription& b) {
  if (a.mesh.empty() || a.mesh != b.mesh || a.where != b.where || a.name != b.name) return false;
  const bool same_part = is_zero(a.middle - b.middle);
  return !same_part && norm(mesh_place(a).position - mesh_place(b).position) < same_place;
}

}  // namespace

void write_place(files::XmlText& xml, const Transformd& place) {
  xml.vector_unless_zero("pos", place.position);
  if (is_identity(place.orientation)) return;
  const auto clean = [](double x) { return std::fabs(x) < 1e-15 ? 0.0 : x; };  // rounding of rotations
  const Quaterniond q = from_matrix(place.orientation);
  xml.numbers("quat", {clean(q.w), clean(q.x), clean(q.y), clean(q.z)});
}

MjcfGeomWriter::MjcfGeomWriter(const robot_formats::RobotDescription& description, const fs::path& folder,
                               files::XmlText& xml)
    : description_(description), folder_(folder), xml_(xml) {
  std::set<std::string> without_file;  // or with a kind of file that MuJoCo does not read
  for (const robot_formats::MeshDescription& mesh : description.meshes) {
    if (!is_mesh_file(mesh.file)) without_file.insert(mesh.name);
  }
  for (const robot_formats::BodyDescription& body : description.bodies) {
    for (const robot_formats::ShapeDescription& shape : body.shapes) {
      // Their hulls are written into the file: they are all that contact uses.
      if (without_file.contains(shape.mesh)) inline_meshes_.emplace(shape.mesh, &shape);
    }
  }
}

void MjcfGeomWriter::write_assets() {
  if (description_.meshes.empty()) return;
  xml_.begin("asset");
  for (const robot_formats::MeshDescription& mesh : description_.meshes) write_asset(mesh);
  xml_.end();
}

void MjcfGeomWriter::write_asset(const robot_formats::MeshDescription& mesh) {
  const auto in_file = inline_meshes_.find(mesh.name);
  if (in_file == inline_meshes_.end() && !is_mesh_file(mesh.file)) {
    unusable_.insert(mesh.name);
    xml_.comment(fmt::format("mesh {} is left out: {} is no STL or OBJ file that can be read", mesh.name,
                             mesh.file.empty() ? "what is only looked at" : mesh.file.filename().string()));
    return;
  }
  xml_.begin("mesh").text("name", mesh.name);
  if (in_file == inline_meshes_.end()) {
    xml_.text("file", relative_name(mesh.file, folder_));
    if (!is_zero(mesh.scale - Vec3d{1, 1, 1})) xml_.vector("scale", mesh.scale);
    xml_.vector_unless_zero("refpos", mesh.origin.position);
    if (!is_identity(mesh.origin.orientation)) {
      const Quaterniond q = from_matrix(mesh.origin.orientation);
      xml_.numbers("refquat", {q.w, q.x, q.y, q.z});
    }
  } else {
    const robot_formats::ShapeDescription& shape = *in_file->second;
    MUROSIMF_ASSERT(in_file->second != nullptr);
    std::vector<double> numbers;
    // The hull's vertices are relative to its own middle.
    for (const Vec3d& v : std::get<Convex>(shape.placed.shape).hull->vertices) {
      const Vec3d vertex = shape.middle + v;
      numbers.insert(numbers.end(), {vertex.x + 0.0, vertex.y + 0.0, vertex.z + 0.0});
    }
    xml_.text("vertex", fmt::format("{}", fmt::join(numbers, " ")));
  }
  xml_.end();
}

void MjcfGeomWriter::write_geoms(const robot_formats::BodyDescription& body) {
  for (std::size_t i = 0; i < body.shapes.size(); ++i) {
    if (i == 0 || !is_same_geom(body.shapes[i - 1], body.shapes[i])) write_shape(body.shapes[i]);
  }
  for (const robot_formats::VisualDescription& visual : body.visuals) {
    if (!unusable_.contains(visual.mesh)) write_visual(visual);
  }
}

void MjcfGeomWriter::write_shape(const robot_formats::ShapeDescription& shape) {
  const PlacedShape& placed = shape.placed;
  xml_.begin("geom");
  write_name(shape.name);
  xml_.text("type", shape_name(placed.shape)).text_unless_empty("mesh", shape.mesh);
  std::visit(WriteShape{xml_}, placed.shape);
  write_place(xml_, shape.mesh.empty() ? Transformd{placed.position, placed.orientation} : mesh_place(shape));
  write_contact(xml_, placed);
  write_color(xml_, placed.color);
  xml_.end();
}

void MjcfGeomWriter::write_visual(const robot_formats::VisualDescription& visual) {
  xml_.begin("geom");
  write_name(visual.name);
  xml_.text("type", "mesh").text("mesh", visual.mesh);
  write_place(xml_, visual.place);
  xml_.text("contype", "0").text("conaffinity", "0").text("group", "2");
  write_color(xml_, visual.color);
  xml_.end();
}

void MjcfGeomWriter::write_name(const std::string& name) {
  if (!name.empty() && taken_.insert(name).second) xml_.text("name", name);
}

}  // namespace murosimf::robot_formats::mjcf
