#include "murosimf/robot_formats/urdf/urdf_shape_writer.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/robot_formats/urdf/urdf_place_writer.h"

namespace murosimf::robot_formats::urdf {
namespace {

namespace fs = std::filesystem;

constexpr double same_place = 1e-9;  // [m] rounding stays far below it
constexpr int rings = 16;            // of an ellipsoid, from pole to pole

bool is_uniform(const Vec3d& scale) { return scale.x == scale.y && scale.y == scale.z; }

/// Whether the scaled file has a place in the mesh frame: a vertex v of the file stands at S R^T (v - p) there. With different scales along
/// turned axes there is none.
bool has_place(const robot_formats::MeshDescription& mesh) {
  return is_uniform(mesh.scale) || is_identity(mesh.origin.orientation);
}

Vec3d times(const Vec3d& a, const Vec3d& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

Transformd file_place(const robot_formats::MeshDescription& mesh) {
  const Mat3d back = transpose(mesh.origin.orientation);
  return {-times(mesh.scale, back * mesh.origin.position), back};
}

/// Place of the mesh that the shape is a part of.
Transformd mesh_place(const robot_formats::ShapeDescription& shape) {
  return shape.placed.place() * Transformd{-shape.middle, {}};
}

/// Whether both are different parts of the same mesh at the same place.
bool is_same_mesh(const robot_formats::ShapeDescription& a, const robot_formats::ShapeDescription& b) {
  if (a.mesh.empty() || a.mesh != b.mesh || a.where != b.where || a.name != b.name) return false;
  return !is_zero(a.middle - b.middle) && norm(mesh_place(a).position - mesh_place(b).position) < same_place;
}

std::string vertex_line(const Vec3d& v) { return fmt::format("v {} {} {}\n", v.x, v.y, v.z); }

std::string obj_of(const ConvexHull& hull) {
  std::string text;
  for (const Vec3d& v : hull.vertices) text += vertex_line(v);
  for (const auto& face : hull.faces) {
    text += 'f';
    // OBJ counts from 1.
    for (const std::uint32_t corner : face) text += fmt::format(" {}", corner + 1);
    text += '\n';
  }
  return text;
}

/// Points of the surface, and the faces between them; twice as many points around as from pole to pole.
std::string obj_of(const Ellipsoid& ellipsoid) {
  constexpr int around = 2 * rings;
  std::string text = vertex_line({0, 0, ellipsoid.semi_axes.z});
  for (int i = 1; i < rings; ++i) {
    for (int k = 0; k < around; ++k) {
      const double polar = pi * i / rings, angle = 2 * pi * k / around;
      const Vec3d on_sphere{std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), std::cos(polar)};
      text += vertex_line(times(ellipsoid.semi_axes, on_sphere));
    }
  }
  text += vertex_line({0, 0, -ellipsoid.semi_axes.z});
  // Number of a vertex in the file: 1 is the upper pole.
  const auto number = [](int ring, int k) { return 2 + (ring - 1) * around + k % around; };
  for (int k = 0; k < around; ++k) {
    text += fmt::format("f 1 {} {}\n", number(1, k), number(1, k + 1));
    for (int i = 1; i < rings - 1; ++i) {
      text += fmt::format("f {} {} {} {}\n", number(i, k), number(i + 1, k), number(i + 1, k + 1), number(i, k + 1));
    }
    text += fmt::format("f {} {} {}\n", number(rings - 1, k), 2 + (rings - 1) * around, number(rings - 1, k + 1));
  }
  return text;
}

/// Adds the element of a shape if URDF has one; false otherwise.
struct WritePrimitive {
  files::XmlText& xml;

  bool operator()(const Sphere& s) const { return done(xml.begin("sphere").numbers("radius", {s.radius})); }
  bool operator()(const Box& s) const { return done(xml.begin("box").vector("size", 2.0 * s.half_size)); }
  bool operator()(const Cylinder& s) const {
    return done(xml.begin("cylinder").numbers("radius", {s.radius}).numbers("length", {2 * s.half_length}));
  }
  bool operator()(const auto&) const { return false; }

  static bool done(files::XmlText& element) {
    element.end();
    return true;
  }
};

std::string file_safe(std::string name) {
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0 && c != '_' && c != '-'; }, '_');
  return name.empty() ? "shape" : name;
}

}  // namespace

UrdfShapeWriter::UrdfShapeWriter(const robot_formats::RobotDescription& description, const UrdfWriterOptions& options,
                                 files::XmlText& xml, UrdfText& result)
    : description_(description), options_(options), xml_(xml), result_(result) {}

void UrdfShapeWriter::write(const robot_formats::BodyDescription& body, const Transformd& place) {
  const bool has_looks =
      !body.visuals.empty() || std::ranges::any_of(body.shapes, [](const robot_formats::ShapeDescription& shape) {
        return !shape.placed.collides;
      });
  for (std::size_t i = 0; i < body.shapes.size(); ++i) {
    const robot_formats::ShapeDescription& shape = body.shapes[i];
    if (i > 0 && is_same_mesh(body.shapes[i - 1], shape) && mesh_in_file(shape.mesh)) continue;
    if (std::holds_alternative<Plane>(shape.placed.shape)) {
      result_.left_out.push_back(fmt::format("{}: a plane: URDF has none", shape.where));
      continue;
    }
    if (shape.placed.collides) write_shape("collision", shape, place);
    if (!shape.placed.collides || !has_looks) write_shape("visual", shape, place);
  }
  for (const robot_formats::VisualDescription& visual : body.visuals) write_visual(visual, place);
}

void UrdfShapeWriter::write_shape(const char* tag, const robot_formats::ShapeDescription& shape,
                                  const Transformd& place) {
  if (std::holds_alternative<Capsule>(shape.placed.shape)) return write_capsule(tag, shape, place);
  const robot_formats::MeshDescription* mesh = mesh_in_file(shape.mesh);
  xml_.begin(tag).text_unless_empty("name", shape.name);
  write_origin(xml_, place * (mesh ? mesh_place(shape) * file_place(*mesh) : shape.placed.place()));
  xml_.begin("geometry");
  if (mesh) {
    write_mesh(relative_name(mesh->file), mesh->scale);
  } else {
    write_geometry(shape);
  }
  xml_.end();
  if (tag == std::string_view("visual")) write_color(shape.placed.color);
  xml_.end();
}

void UrdfShapeWriter::write_capsule(const char* tag, const robot_formats::ShapeDescription& shape,
                                    const Transformd& place) {
  MUROSIMF_ASSERT(std::holds_alternative<Capsule>(shape.placed.shape));
  const auto& [radius, half_length] = std::get<Capsule>(shape.placed.shape);
  const auto write_part = [&](const Shape& part, double height, const char* name) {
    robot_formats::ShapeDescription one = shape;
    one.placed.shape = part;
    one.placed.position = shape.placed.position + shape.placed.orientation * Vec3d{0, 0, height};
    if (!shape.name.empty()) one.name += name;
    write_shape(tag, one, place);
  };
  write_part(Cylinder{radius, half_length}, 0, "");
  write_part(Sphere{radius}, half_length, "_upper_end");
  write_part(Sphere{radius}, -half_length, "_lower_end");
}

void UrdfShapeWriter::write_geometry(const robot_formats::ShapeDescription& shape) {
  if (std::visit(WritePrimitive{xml_}, shape.placed.shape)) return;
  std::string text;
  if (const auto* convex = std::get_if<Convex>(&shape.placed.shape)) text = obj_of(*convex->hull);
  if (const auto* ellipsoid = std::get_if<Ellipsoid>(&shape.placed.shape)) text = obj_of(*ellipsoid);
  const std::string stem = file_safe(shape.mesh.empty() ? shape.name : shape.mesh);
  std::string name = fmt::format("{}/{}.obj", options_.mesh_folder, stem);
  // The same shape in another place, also as a visual, is the same file.
  for (int number = 2; result_.meshes.contains(name) && result_.meshes.at(name) != text; ++number) {
    name = fmt::format("{}/{}_{}.obj", options_.mesh_folder, stem, number);
  }
  MUROSIMF_ASSERT(!text.empty());
  result_.meshes.emplace(name, std::move(text));
  write_mesh(name, {1, 1, 1});
}

void UrdfShapeWriter::write_mesh(const std::string& file, const Vec3d& scale) {
  xml_.begin("mesh").text("filename", file);
  if (!is_zero(scale - Vec3d{1, 1, 1})) xml_.vector("scale", scale);
  xml_.end();
}

void UrdfShapeWriter::write_visual(const robot_formats::VisualDescription& visual, const Transformd& place) {
  const robot_formats::MeshDescription* mesh = mesh_in_file(visual.mesh);
  if (!mesh) {
    result_.left_out.push_back(
        fmt::format("{}: mesh '{}' for the eye: there is no file that could be named", visual.where, visual.mesh));
    return;
  }
  xml_.begin("visual").text_unless_empty("name", visual.name);
  write_origin(xml_, place * visual.place * file_place(*mesh));
  xml_.begin("geometry");
  write_mesh(relative_name(mesh->file), mesh->scale);
  xml_.end();
  write_color(visual.color);
  xml_.end();
}

/// Writes a material. One of the same name has the same color in all of the file, so the name is the color.
void UrdfShapeWriter::write_color(const Color& color) {
  if (color == Color{}) return;
  const auto byte = [](double share) { return static_cast<int>(std::lround(255 * std::clamp(share, 0.0, 1.0))); };
  const std::string name = fmt::format("color_{:02x}{:02x}{:02x}{:02x}", byte(color.red), byte(color.green),
                                       byte(color.blue), byte(color.alpha));
  xml_.begin("material").text("name", name);
  xml_.begin("color").numbers("rgba", {color.red, color.green, color.blue, color.alpha}).end();
  xml_.end();
}

/// The mesh of a shape. Null: the mesh has no file, or one that cannot be placed.
const robot_formats::MeshDescription* UrdfShapeWriter::mesh_in_file(const std::string& name) const {
  if (name.empty()) return nullptr;
  const auto mesh = std::ranges::find(description_.meshes, name, &robot_formats::MeshDescription::name);
  std::error_code none;
  const bool usable = mesh != description_.meshes.end() && fs::is_regular_file(mesh->file, none) && has_place(*mesh);
  return usable ? &*mesh : nullptr;
}

std::string UrdfShapeWriter::relative_name(const fs::path& file) const {
  const fs::path from = fs::absolute(options_.folder.empty() ? "." : options_.folder);
  return fs::proximate(fs::absolute(file), from).generic_string();
}

}  // namespace murosimf::robot_formats::urdf
