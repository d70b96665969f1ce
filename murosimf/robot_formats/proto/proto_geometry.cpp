#include "murosimf/robot_formats/proto/proto_geometry.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/files/file_spelling.h"
#include "murosimf/geometry/hull.h"
#include "murosimf/geometry/mesh_mass.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/mesh_entry.h"
#include "murosimf/robot_formats/proto/proto_schema.h"

namespace murosimf::robot_formats::proto {
namespace {

constexpr std::size_t most_nodes = 100'000;  // a node that is used in many places counts in each
constexpr double standard_friction = 1.0;    // [1] coulombFriction without ContactProperties

PlacedShape placed_shape(const Shape& shape, const Transformd& place, bool collides) {
  PlacedShape placed;
  placed.shape = shape;
  placed.position = place.position;
  placed.orientation = place.orientation;
  placed.surface.friction = standard_friction;
  placed.collides = collides;
  return placed;
}

Vec3d by_parts(const Vec3d& a, const Vec3d& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

Vec3d absolute(const Vec3d& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

/// The solid of density 1 kg/m^3 that fills the shape, in body axes.
robot_formats::MassProperties filled(const PlacedShape& placed) {
  const double mass = robot_formats::volume(placed.shape);
  const SymMat3d inertia = mass * robot_formats::unit_inertia(placed.shape);
  // The center of mass of a hull is not the middle of its axis-aligned box, where its origin is.
  if (const Convex* convex = std::get_if<Convex>(&placed.shape)) {
    const geometry::SolidMass solid = geometry::solid_mass(*convex->hull);
    return robot_formats::moved({solid.volume, solid.center, solid.inertia}, placed.position, placed.orientation);
  }
  return robot_formats::moved({mass, {}, inertia}, placed.position, placed.orientation);
}

/// The points of an IndexedFaceSet [m].
std::vector<Vec3d> points_of(const Node& geometry, const Vec3d& scale) {
  const NodePtr coordinate = geometry.child("coord");
  const Field* field = coordinate ? coordinate->find("point") : nullptr;
  if (!field || field->numbers.empty() || field->numbers.size() % 3 != 0) {
    geometry.fail("IndexedFaceSet has no coord Coordinate { point [...] } with three numbers for each point");
  }
  MUROSIMF_ASSERT(field->numbers.size() % 3 == 0);
  std::vector<Vec3d> points;
  for (std::size_t i = 0; i + 2 < field->numbers.size(); i += 3) {
    points.push_back(by_parts(scale, {field->numbers[i], field->numbers[i + 1], field->numbers[i + 2]}));
  }
  return points;
}

std::string url_of(const Node& mesh) {
  const Field* field = mesh.find("url");
  if (!field || field->texts.empty()) mesh.fail("Mesh has no url; write the name of a file");
  return field->texts[0];
}

double transparency_of(const Node& node) { return std::clamp(1 - node.number("transparency", 0), 0.0, 1.0); }

}  // namespace

bool is_even(const Vec3d& scale) { return scale.x > 0 && scale.y == scale.x && scale.z == scale.x; }

Placing placed_in(const Placing& outer, const Node& node) {
  if (node.type == "Group") return outer;
  const Vec3d scale = node.vector("scale", {1, 1, 1});
  if (scale.x == 0 || scale.y == 0 || scale.z == 0) node.fail("scale must not be 0", node.find("scale"));
  Transformd pose = node.pose();
  // A turn inside an uneven scale shears, which no shape here can represent.
  if (!is_even(outer.scale) && !is_identity(pose.orientation)) {
    node.fail(fmt::format("{} turns what a Transform around it scales by {} {} {}; scale inside it", node.type,
                          outer.scale.x, outer.scale.y, outer.scale.z),
              node.find("rotation"));
  }
  pose.position = by_parts(outer.scale, pose.position);
  return {outer.place * pose, by_parts(outer.scale, scale)};
}

std::optional<ProtoGeometry::Part> ProtoGeometry::primitive(const Node& geometry, const Placing& at) const {
  // Cylinders of old files are along y, those of shapes here along z.
  const auto turned = [&](const Shape& shape) {
    return Part{shape, upright_ ? at.place * Transformd{{}, rotation_x(-0.5 * pi)} : at.place};
  };
  if (geometry.type == "Box") {
    const Vec3d size = geometry.vector("size", {0.1, 0.1, 0.1});
    if (!(size.x > 0 && size.y > 0 && size.z > 0)) {
      geometry.fail("size of Box must be three numbers more than 0", geometry.find("size"));
    }
    return Part{Box{0.5 * by_parts(absolute(at.scale), size)}, at.place};
  }
  const bool is_long = geometry.type == "Capsule" || geometry.type == "Cylinder";
  if (geometry.type != "Sphere" && !is_long) return std::nullopt;
  if (!is_even(at.scale)) {
    geometry.fail(fmt::format("{} in a Transform with scale {} {} {}; write out its size", geometry.type, at.scale.x,
                              at.scale.y, at.scale.z));
    MUROSIMF_ASSERT(is_even(at.scale));
  }
  const double scale = at.scale.x;
  if (!is_long) return Part{Sphere{scale * geometry.positive("radius", 0.1)}, at.place};
  const double radius = scale * geometry.positive("radius", 0.05);
  const double half_length = 0.5 * scale * geometry.positive("height", 0.1);
  if (geometry.type == "Capsule") return turned(Capsule{radius, half_length});
  return turned(Cylinder{radius, half_length});
}

std::optional<robot_formats::MeshDescription> ProtoGeometry::find_mesh(const Node& mesh, const Vec3d& scale) {
  const auto file = files::find_spelled(mesh.file->parent_path(), url_of(mesh));
  if (!file) return std::nullopt;
  return robot_formats::mesh_entry(description_, *file, scale, mesh.where);
}

std::vector<ProtoGeometry::Part> ProtoGeometry::mesh_parts(const Node& geometry, const Placing& at) {
  const auto found = find_mesh(geometry, at.scale);
  if (!found) geometry.fail(fmt::format("there is no mesh file '{}'", url_of(geometry)), geometry.find("url"));
  const bool split = std::ranges::find(part_per_group_, found->name) != part_per_group_.end();
  const std::string where = fmt::format("{}: mesh '{}'", geometry.where, found->name);
  const mesh::SolidMesh& solid =
      with_context(where, [&]() -> const mesh::SolidMesh& { return library_.get(found->file, found->scale, split); });
  if (!solid.flat.empty()) throw SetupError(fmt::format("{}: {}", where, solid.flat));
  for (const std::string& doubt : mesh::mesh_doubts(solid)) {
    log_.warn(geometry.where, fmt::format("mesh '{}': {}", found->name, doubt));
  }
  std::vector<Part> parts;
  for (const mesh::ConvexPart& part : solid.parts) {
    MUROSIMF_ASSERT(part.shape.hull != nullptr);
    parts.push_back({part.shape, at.place * Transformd{part.middle, {}}, found->name, part.middle});
  }
  return parts;
}

std::vector<ProtoGeometry::Part> ProtoGeometry::convex_parts(const Node& geometry, const Placing& at) {
  if (const auto part = primitive(geometry, at)) return {*part};
  if (geometry.type == "Mesh") return mesh_parts(geometry, at);
  if (geometry.type == "IndexedFaceSet") {
    const auto points = points_of(geometry, at.scale);
    const geometry::Hull hull = with_context(geometry.where, [&] { return geometry::make_hull(points); });
    return {{Convex{std::make_shared<const ConvexHull>(hull.hull)}, at.place * Transformd{hull.middle, {}}}};
  }
  log_.refuse(geometry,
              fmt::format("{} as boundingObject is not supported; use Box, Sphere, Capsule, Cylinder, Mesh or "
                          "IndexedFaceSet",
                          geometry.type));
  return {};
}

void ProtoGeometry::count(const Node& node) {
  // USE multiplies nodes: counted before memory for their bodies is needed.
  if (++seen_ > most_nodes) node.fail(fmt::format("the robot has more than {} nodes; make it smaller", most_nodes));
}

std::vector<robot_formats::MassProperties> ProtoGeometry::add_bounding(const Node& node, const Placing& at,
                                                                       robot_formats::BodyDescription& body) {
  count(node);
  log_.check_fields(node);
  std::vector<robot_formats::MassProperties> solids;
  if (is_group(node.type)) {
    const Placing inner = placed_in(at, node);
    for (const NodePtr& child : node.children("children")) {
      for (const auto& solid : add_bounding(*child, inner, body)) solids.push_back(solid);
    }
    return solids;
  }
  if (node.type == "Shape") {
    const NodePtr geometry = node.child("geometry");
    return geometry ? add_bounding(*geometry, at, body) : solids;
  }
  for (Part& part : convex_parts(node, at)) {
    // Each convex part counts with its own volume, overlaps twice, as in Webots.
    const PlacedShape placed = placed_shape(part.shape, part.place, true);
    solids.push_back(filled(placed));
    body.shapes.push_back({node.def, node.where, placed, part.mesh, part.middle});
  }
  return solids;
}

Color ProtoGeometry::color_of(const Node& shape) {
  const NodePtr appearance = shape.child("appearance");
  if (!appearance) return {};
  if (appearance->type == "PBRAppearance") {
    const Vec3d color = appearance->vector("baseColor", {1, 1, 1});
    return {color.x, color.y, color.z, transparency_of(*appearance)};
  }
  const NodePtr material = appearance->type == "Appearance" ? appearance->child("material") : nullptr;
  if (!material) {
    // PROTOs of appearances (brushed metal, ...) need no color to be simulated.
    if (appearance->type != "Appearance") {
      log_.note(appearance->where, fmt::format("appearance {} is not known here; gray is taken", appearance->type));
    }
    return {};
  }
  const Vec3d color = material->vector("diffuseColor", {0.8, 0.8, 0.8});
  return {color.x, color.y, color.z, transparency_of(*material)};
}

void ProtoGeometry::add_visual(const Node& shape, const Placing& at, robot_formats::BodyDescription& body) {
  const NodePtr geometry = shape.child("geometry");
  if (!geometry) return;
  const Color color = color_of(shape);
  if (!is_even(at.scale) && geometry->type != "Mesh" && geometry->type != "Box") {
    // A sphere with an uneven scale would be an ellipsoid; for a picture that is not worth an error.
    const std::string message = fmt::format("{} for the eye with an uneven scale is not drawn", geometry->type);
    return log_.unused(geometry->where, "Transform.scale", message);
  }
  if (const auto part = primitive(*geometry, at)) {
    PlacedShape placed = placed_shape(part->shape, part->place, false);
    placed.color = color;
    body.shapes.push_back({shape.def, shape.where, placed, ""});
  } else if (geometry->type == "Mesh") {
    add_visual_mesh(*geometry, at, color, body);
  } else {
    log_.unused(geometry->where, "Shape." + geometry->type, fmt::format("{} for the eye is not drawn", geometry->type));
  }
}

void ProtoGeometry::add_visual_mesh(const Node& mesh, const Placing& at, const Color& color,
                                    robot_formats::BodyDescription& body) {
  const auto found = find_mesh(mesh, at.scale);
  if (!found) {
    log_.warn(mesh.where, fmt::format("for the eye, there is no mesh file '{}'; it is left out", url_of(mesh)));
    return;
  }
  body.visuals.push_back({mesh.def, mesh.where, found->name, at.place, color});
}

}  // namespace murosimf::robot_formats::proto
