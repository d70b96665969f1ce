#include "murosimf/robot_formats/mjcf/mjcf_geom.h"

#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::robot_formats::mjcf {
namespace {

std::vector<double> sizes(const MjcfAttributes& attributes, std::size_t needed) {
  const auto size = attributes.numbers("size", 1, 3);
  MUROSIMF_ASSERT(needed >= 1 && needed <= 3);
  const auto type = attributes.text("type", "sphere");
  if (size.size() < needed) {
    attributes.source("size").fail(
        fmt::format("size of a {} needs {} numbers, there are {}", type, needed, size.size()));
  }
  for (std::size_t i = 0; i < needed; ++i) {
    if (!(size[i] > 0)) {
      attributes.source("size").fail(fmt::format("size '{}' of a {} must be positive", attributes.text("size"), type));
    }
  }
  MUROSIMF_ASSERT(size.size() >= needed);
  return size;
}

Shape read_shape(const MjcfAttributes& attributes, const std::string& type) {
  if (type == "plane") return Plane{};
  if (type == "sphere") return Sphere{sizes(attributes, 1)[0]};
  if (type == "box" || type == "ellipsoid") {
    const auto size = sizes(attributes, 3);
    const Vec3d half{size[0], size[1], size[2]};
    return type == "box" ? Shape{Box{half}} : Shape{Ellipsoid{half}};
  }
  const auto size = sizes(attributes, 2);
  return type == "capsule" ? Shape{Capsule{size[0], size[1]}} : Shape{Cylinder{size[0], size[1]}};
}

/// Reads a long shape given by the ends of its z axis; sets the place as well.
Shape read_from_to(const MjcfAttributes& attributes, const std::string& type, PlacedShape& placed) {
  const auto [middle, turn, half] = between_ends(attributes);
  placed.position = middle;
  placed.orientation = turn;
  const double radius = sizes(attributes, 1)[0];
  if (type == "capsule") return Capsule{radius, half};
  if (type == "cylinder") return Cylinder{radius, half};
  if (type == "box") return Box{{radius, radius, half}};
  if (type == "ellipsoid") return Ellipsoid{{radius, radius, half}};
  attributes.source("fromto").fail(fmt::format("a {} cannot have fromto; give pos instead", type));
}

void check_mass(const MjcfAttributes& attributes) {
  for (const char* name : {"mass", "density"}) {
    if (attributes.number(name, 0) < 0) {
      attributes.source(name).fail(fmt::format("{} of geom is negative; it must be at least 0", name));
    }
  }
}

robot_formats::MassProperties read_solid(const MjcfAttributes& attributes, const PlacedShape& placed) {
  const double mass =
      attributes.number("mass", attributes.number("density", 1000.0) * robot_formats::volume(placed.shape));
  return {mass, placed.position, rotated(placed.orientation, mass * robot_formats::unit_inertia(placed.shape))};
}

/// A mask has one bit per kind of shape; -1 stands for all of them.
std::uint32_t read_mask(const MjcfAttributes& attributes, const char* name) {
  const double number = attributes.number(name, 1);
  if (number != std::floor(number) || number < -2147483648.0 || number > 4294967295.0) {
    attributes.source(name).fail(fmt::format("{} '{}' must be a whole number of 32 bits", name, attributes.text(name)));
  }
  // By way of 64 bits: a negative number must keep its bits, and conversion of it to unsigned is undefined.
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(number));
}

void read_surface(const MjcfAttributes& attributes, const Color& color, PlacedShape& placed) {
  placed.surface.friction = 1.0;  // default of the format
  if (const auto friction = attributes.numbers("friction", 1, 3); !friction.empty()) {
    if (friction[0] < 0) attributes.source("friction").fail("friction is negative; it must be at least 0");
    placed.surface.friction = friction[0];
  }
  placed.color = color;
  placed.contact_type = read_mask(attributes, "contype");
  placed.contact_affinity = read_mask(attributes, "conaffinity");
  placed.collides = placed.contact_type != 0 || placed.contact_affinity != 0;
}

/// Mass of a mesh; zero where it does not count, so that a visual mesh needs no volume.
robot_formats::MassProperties read_mesh_solid(const MjcfAttributes& attributes, const PlacedShape& placed,
                                              const MjcfGeomContext& context) {
  const bool silent =
      attributes.number("mass", 1) == 0 || (!attributes.has("mass") && attributes.number("density", 1) == 0);
  if (!context.mass_counts || silent) return {};
  const auto solid = context.meshes.mass(attributes.text("mesh"), attributes.element());
  const double mass = attributes.number("mass", attributes.number("density", 1000.0) * solid.volume);
  return {mass, placed.position + placed.orientation * solid.center,
          rotated(placed.orientation, (mass / solid.volume) * solid.inertia)};
}

MjcfGeom read_mesh_geom(const MjcfAttributes& attributes, const std::string& type, const MjcfGeomContext& context) {
  const files::XmlElement& element = attributes.element();
  if (!attributes.has("mesh")) element.fail("geom of type mesh without a mesh; add mesh=\"...\"");
  if (type != "mesh") {
    element.fail(fmt::format("a {} cannot be fitted to a mesh here; write type=\"mesh\", or give its size", type));
  }
  if (attributes.has("fromto")) attributes.source("fromto").fail("a mesh cannot have fromto; give pos instead");
  PlacedShape placed;
  placed.position = attributes.vector("pos", {});
  placed.orientation = read_orientation(attributes, context.compiler);
  const std::string of_mesh = context.meshes.material(attributes.text("mesh"), element);
  read_surface(attributes, context.materials.color_of(attributes, of_mesh), placed);
  MjcfGeom geom;
  geom.solid = read_mesh_solid(attributes, placed, context);
  const std::string mesh = attributes.text("mesh");
  // A visual mesh may be as large and as open as it likes: only its file is checked.
  if (!placed.collides) {
    context.meshes.check_file(mesh, element);
    const Transformd place{placed.position, placed.orientation};
    geom.visual = robot_formats::VisualDescription{attributes.text("name"), element.where(), mesh, place, placed.color};
    const MjcfMaterials::Picture picture = context.materials.picture_of(attributes, of_mesh);
    geom.visual->picture = picture.file.string();
    geom.visual->picture_repeat = picture.repeat;
    return geom;
  }
  for (const robot_formats::mesh::ConvexPart& part : context.meshes.parts(mesh, element)) {
    geom.shapes.push_back(placed);
    geom.shapes.back().shape = part.shape;
    geom.shapes.back().position += placed.orientation * part.middle;
    geom.middles.push_back(part.middle);
  }
  MUROSIMF_ASSERT(geom.middles.size() == geom.shapes.size());
  return geom;
}

MjcfGeom read_mesh_unless_unfit(const MjcfAttributes& attributes, const std::string& type,
                                const MjcfGeomContext& context) {
  try {
    return read_mesh_geom(attributes, type, context);
  } catch (const SetupError& error) {
    if (!context.lenient) throw;
    context.warnings.push_back(fmt::format("{}: mesh '{}' ignored: {}", attributes.element().where(),
                                           files::one_line(attributes.text("mesh")), error.what()));
    return {};
  }
}

}  // namespace

MjcfSpan between_ends(const MjcfAttributes& attributes) {
  const auto ends = attributes.numbers("fromto", 6, 6);
  const Vec3d from{ends[0], ends[1], ends[2]}, to{ends[3], ends[4], ends[5]};
  const double half = 0.5 * norm(to - from);
  if (!(half > 1e-9)) attributes.source("fromto").fail("fromto needs two different points");
  MUROSIMF_ASSERT(half > 0);
  return {0.5 * (from + to), turn_of_z(from - to), half};
}

MjcfGeom read_geom(const MjcfAttributes& attributes, const MjcfGeomContext& context) {
  const auto type = attributes.choice("type", {"sphere", "box", "capsule", "cylinder", "ellipsoid", "plane", "mesh"});
  check_mass(attributes);
  if (type == "mesh" || attributes.has("mesh")) return read_mesh_unless_unfit(attributes, type, context);
  PlacedShape placed;
  if (attributes.has("fromto")) {
    placed.shape = read_from_to(attributes, type, placed);
  } else {
    placed.shape = read_shape(attributes, type);
    placed.position = attributes.vector("pos", {});
    placed.orientation = read_orientation(attributes, context.compiler);
  }
  read_surface(attributes, context.materials.color_of(attributes), placed);
  return {{placed}, {{}}, std::nullopt, read_solid(attributes, placed)};
}

}  // namespace murosimf::robot_formats::mjcf
