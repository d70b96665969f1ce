#include "murosimf/io/mjcf_geom.h"

#include <utility>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::io {
namespace {

double cube(double x) { return x * x * x; }

/// Diagonal of a box-like or ellipsoid-like inertia: factor * (b^2 + c^2, a^2 + c^2, a^2 + b^2).
SymMat3d from_squares(double factor, const Vec3d& a) {
  const double xx = a.x * a.x, yy = a.y * a.y, zz = a.z * a.z;
  return {factor * (yy + zz), factor * (xx + zz), factor * (xx + yy)};
}

struct Volume {
  double operator()(const Sphere& s) const { return 4.0 / 3.0 * pi * cube(s.radius); }
  double operator()(const Box& s) const { return 8.0 * s.half_size.x * s.half_size.y * s.half_size.z; }
  double operator()(const Capsule& s) const {
    return (*this)(Sphere{s.radius}) + (*this)(Cylinder{s.radius, s.half_length});
  }
  double operator()(const Cylinder& s) const { return 2.0 * pi * s.radius * s.radius * s.half_length; }
  double operator()(const Ellipsoid& s) const { return 4.0 / 3.0 * pi * s.semi_axes.x * s.semi_axes.y * s.semi_axes.z; }
  double operator()(const Plane&) const { return 0; }
  double operator()(const Convex& s) const { return geometry::solid_mass(*s.hull).volume; }
};

// Source: tables of moments of inertia of homogeneous solids, as in Goldstein, Classical Mechanics, or any
// handbook of mechanics; the capsule is a cylinder and two half balls, whose centers lie 3/8 r behind their flat side.
struct UnitInertia {
  SymMat3d operator()(const Sphere& s) const { return diagonal(0.4 * s.radius * s.radius); }
  SymMat3d operator()(const Box& s) const { return from_squares(1.0 / 3.0, s.half_size); }
  SymMat3d operator()(const Ellipsoid& s) const { return from_squares(0.2, s.semi_axes); }
  SymMat3d operator()(const Cylinder& s) const {
    const double rr = s.radius * s.radius;
    const double across = 0.25 * rr + s.half_length * s.half_length / 3.0;
    return {across, across, 0.5 * rr};
  }
  SymMat3d operator()(const Capsule& s) const {
    const double r = s.radius, h = s.half_length;
    const double balls = volume(Sphere{r}) / volume(Shape{s});  // share of the mass
    // half balls: 2/5 r^2 about the middle of their flat side, moved to the middle of the capsule
    const double across = 0.4 * r * r + h * h + 0.75 * h * r;
    const SymMat3d caps{across, across, 0.4 * r * r};
    return balls * caps + (1.0 - balls) * (*this)(Cylinder{r, h});
  }
  SymMat3d operator()(const Plane&) const { return {}; }
  SymMat3d operator()(const Convex& s) const {
    const auto solid = geometry::solid_mass(*s.hull);
    return (1.0 / solid.volume) * solid.inertia;
  }
};

std::vector<double> sizes(const MjcfAttributes& attributes, std::size_t needed) {
  const auto size = attributes.numbers("size", 1, 3);
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

/// A long shape given by the ends of its z axis; sets the place, too.
Shape read_from_to(const MjcfAttributes& attributes, const std::string& type, PlacedShape& placed) {
  const auto ends = attributes.numbers("fromto", 6, 6);
  const Vec3d from{ends[0], ends[1], ends[2]}, to{ends[3], ends[4], ends[5]};
  const double half = 0.5 * norm(to - from);
  if (!(half > 1e-9)) attributes.source("fromto").fail("fromto needs two different points");
  placed.position = 0.5 * (from + to);
  placed.orientation = turn_of_z(from - to);
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

MassProperties read_solid(const MjcfAttributes& attributes, const PlacedShape& placed) {
  const double mass = attributes.number("mass", attributes.number("density", 1000.0) * volume(placed.shape));
  return {mass, placed.position, rotated(placed.orientation, mass * unit_inertia(placed.shape))};
}

void read_surface(const MjcfAttributes& attributes, PlacedShape& placed) {
  placed.surface.friction = 1.0;  // default of the format
  if (const auto friction = attributes.numbers("friction", 1, 3); !friction.empty()) {
    if (friction[0] < 0) attributes.source("friction").fail("friction is negative; it must be at least 0");
    placed.surface.friction = friction[0];
  }
  if (const auto color = attributes.numbers("rgba", 4, 4); !color.empty())
    placed.color = {color[0], color[1], color[2]};
  placed.collides = attributes.number("contype", 1) != 0 || attributes.number("conaffinity", 1) != 0;
}

/// Zero where nothing of it counts, so that a mesh for the eye needs no volume.
MassProperties read_mesh_solid(const MjcfAttributes& attributes, const PlacedShape& placed,
                               const MjcfGeomContext& context) {
  const bool silent =
      attributes.number("mass", 1) == 0 || (!attributes.has("mass") && attributes.number("density", 1) == 0);
  if (!context.mass_counts || silent) return {};
  const auto solid = context.meshes.mass(attributes.text("mesh"), attributes.element());
  const double mass = attributes.number("mass", attributes.number("density", 1000.0) * solid.volume);
  return {mass, placed.position + placed.orientation * solid.center,
          rotated(placed.orientation, (mass / solid.volume) * solid.inertia)};
}

std::vector<MjcfGeom> read_mesh_geom(const MjcfAttributes& attributes, const std::string& type,
                                     const MjcfGeomContext& context) {
  const XmlElement& element = attributes.element();
  if (!attributes.has("mesh")) element.fail("geom of type mesh without a mesh; add mesh=\"...\"");
  if (type != "mesh") {
    element.fail(fmt::format("a {} cannot be fitted to a mesh here; write type=\"mesh\", or give its size", type));
  }
  if (attributes.has("fromto")) attributes.source("fromto").fail("a mesh cannot have fromto; give pos instead");
  PlacedShape placed;
  placed.position = attributes.vector("pos", {});
  placed.orientation = read_orientation(attributes, context.compiler);
  read_surface(attributes, placed);
  MassProperties solid = read_mesh_solid(attributes, placed, context);
  std::vector<MjcfGeom> geoms;
  for (const MeshPart& part : context.meshes.parts(attributes.text("mesh"), element, placed.collides)) {
    geoms.push_back({placed, std::exchange(solid, {})});
    geoms.back().placed.shape = part.shape;
    geoms.back().placed.position += placed.orientation * part.middle;
  }
  return geoms;
}

std::vector<MjcfGeom> read_mesh_unless_unfit(const MjcfAttributes& attributes, const std::string& type,
                                             const MjcfGeomContext& context) {
  try {
    return read_mesh_geom(attributes, type, context);
  } catch (const SetupError& error) {
    if (!context.lenient) throw;
    context.warnings.push_back(fmt::format("{}: mesh '{}' ignored: {}", attributes.element().where(),
                                           one_line(attributes.text("mesh")), error.what()));
    return {};
  }
}

}  // namespace

double volume(const Shape& shape) { return std::visit(Volume{}, shape); }

SymMat3d unit_inertia(const Shape& shape) { return std::visit(UnitInertia{}, shape); }

MassProperties combined(const std::vector<MassProperties>& parts) {
  MassProperties sum;
  for (const MassProperties& part : parts) {
    sum.mass += part.mass;
    sum.center += part.mass * part.center;
  }
  if (sum.mass > 0) sum.center = (1.0 / sum.mass) * sum.center;
  for (const MassProperties& part : parts) {
    sum.inertia += part.inertia + part.mass * inertia_of_point(part.center - sum.center);
  }
  return sum;
}

std::vector<MjcfGeom> read_geom(const MjcfAttributes& attributes, const MjcfGeomContext& context) {
  const auto type = attributes.choice("type", {"sphere", "box", "capsule", "cylinder", "ellipsoid", "plane", "mesh"});
  check_mass(attributes);
  if (type == "mesh" || attributes.has("mesh")) return read_mesh_unless_unfit(attributes, type, context);
  MjcfGeom geom;
  if (attributes.has("fromto")) {
    geom.placed.shape = read_from_to(attributes, type, geom.placed);
  } else {
    geom.placed.shape = read_shape(attributes, type);
    geom.placed.position = attributes.vector("pos", {});
    geom.placed.orientation = read_orientation(attributes, context.compiler);
  }
  geom.solid = read_solid(attributes, geom.placed);
  read_surface(attributes, geom.placed);
  return {geom};
}

}  // namespace murosimf::io
