#include "murosimf/robot_formats/sdf/sdf_link.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/sdf/sdf_value.h"
#include "murosimf/robot_formats/urdf/urdf_shape.h"
#include "murosimf/robot_formats/urdf/urdf_value.h"

namespace murosimf::robot_formats::sdf {
namespace {

/// The pose of a part; the identity where libsdformat has none.
Transformd place_of(const std::map<std::string, Transformd>& places, const files::XmlElement& part) {
  const auto found = places.find(part.attribute("name").value_or(""));
  return found == places.end() ? Transformd{} : found->second;
}

/// The file of the diffuse texture as the file spells it; empty: none.
std::string picture_of(const files::XmlElement& visual) {
  const auto material = urdf::only_child(visual, "material");
  const auto pbr = material ? urdf::only_child(*material, "pbr") : std::nullopt;
  const auto metal = pbr ? urdf::only_child(*pbr, "metal") : std::nullopt;
  return metal ? child_text(*metal, "albedo_map", "") : "";
}

/// The color of `material`, white with a texture alone, with the transparency of the visual.
Color color_of(const files::XmlElement& visual) {
  Color color = picture_of(visual).empty() ? Color{} : Color{1, 1, 1};
  if (const auto material = urdf::only_child(visual, "material")) {
    const auto diffuse = urdf::only_child(*material, "diffuse");
    const auto element = diffuse ? diffuse : urdf::only_child(*material, "ambient");
    const auto numbers = element ? files::parse_numbers(element->text()) : std::nullopt;
    if (element && (!numbers || numbers->size() < 3 || numbers->size() > 4)) {
      element->fail(fmt::format("<{}> must be three or four numbers: red, green, blue, alpha", element->tag()));
    }
    if (numbers) color = {(*numbers)[0], (*numbers)[1], (*numbers)[2], numbers->size() > 3 ? (*numbers)[3] : 1.0};
  }
  color.alpha *= 1.0 - std::clamp(number(visual, "transparency", 0), 0.0, 1.0);
  return color;
}

std::optional<Shape> primitive(const files::XmlElement& element) {
  const std::string tag = element.tag();
  if (tag == "sphere") return Sphere{positive(element, "radius")};
  if (tag == "cylinder") return Cylinder{positive(element, "radius"), 0.5 * positive(element, "length")};
  if (tag == "capsule") return Capsule{positive(element, "radius"), 0.5 * positive(element, "length")};
  if (tag != "box" && tag != "ellipsoid") return std::nullopt;
  const char* sizes = tag == "box" ? "size" : "radii";
  const Vec3d size = vector(element, sizes, {});
  if (!(size.x > 0 && size.y > 0 && size.z > 0)) {
    element.fail(fmt::format("<{}> of {} must be three numbers more than 0", sizes, tag));
  }
  if (tag == "box") return Box{0.5 * size};
  return Ellipsoid{size};
}

/// Moments default to 1 kg m^2, as in the format.
SymMat3d tensor(const files::XmlElement& inertia) {
  return {number(inertia, "ixx", 1), number(inertia, "iyy", 1), number(inertia, "izz", 1),
          number(inertia, "ixy", 0), number(inertia, "ixz", 0), number(inertia, "iyz", 0)};
}

}  // namespace

urdf::UrdfMeshes& SdfLinks::meshes_of(const std::filesystem::path& file) {
  const auto known = meshes_.find(file);
  if (known != meshes_.end()) return known->second;
  // Relative to the file that contains the link: an included model has its own folder of meshes.
  urdf::UrdfMeshPaths paths(file, options_.packages, options_.search_paths);
  return meshes_.try_emplace(file, std::move(paths), options_.part_per_group, description_, log_).first->second;
}

robot_formats::MassProperties SdfLinks::read_inertial(const SdfPart& link, const SdfLinkPose& pose) {
  const auto inertial = urdf::only_child(link.element, "inertial");
  robot_formats::MassProperties solid;
  solid.mass = inertial ? at_least_zero(*inertial, "mass", 1) : 1;
  if (!inertial) log_.note(link.element, "links without inertial weigh 1 kg with 1 kg m^2, as the format has it");
  const auto inertia = inertial ? urdf::only_child(*inertial, "inertia") : std::nullopt;
  const SymMat3d written = inertia ? tensor(*inertia) : diagonal(1.0);
  for (const double moment : {written.xx, written.yy, written.zz, written.xy, written.xz, written.yz}) {
    if (!std::isfinite(moment)) inertia->fail("a moment of inertia is not finite");
  }
  solid.center = pose.inertial.position;
  // The tensor is given in the inertial frame, which may be turned against the link.
  solid.inertia = rotated(pose.inertial.orientation, written);
  const Vec3d moments = robot_formats::principal_moments(solid.inertia);
  if (robot_formats::breaks_triangle_inequality(moments)) {
    log_.warn(inertial ? *inertial : link.element,
              fmt::format(
                  "no solid body has the principal moments {:.4g} {:.4g} {:.4g} kg m^2 of link '{}': two of them must "
                  "not be less than the third",
                  moments.x, moments.y, moments.z, link.name));
  }
  MUROSIMF_ASSERT(solid.mass >= 0);
  return solid;
}

double SdfLinks::friction_of(const files::XmlElement& collision) {
  std::optional<files::XmlElement> element = collision;
  for (const char* tag : {"surface", "friction", "ode"}) {
    element = element ? urdf::only_child(*element, tag) : std::nullopt;
  }
  if (!element) return urdf::standard_friction;
  const double mu = at_least_zero(*element, "mu", urdf::standard_friction);
  // Friction is isotropic in all contact laws here.
  if (at_least_zero(*element, "mu2", mu) != mu) {
    log_.warn(*element, "friction differs by direction; mu is taken for all");
  }
  return mu;
}

void SdfLinks::warn_of_settings(const files::XmlElement& link) {
  if (!flag(link, "gravity", true)) {
    log_.warn(link, "gravity is switched off for parts of the robot; here all of it has weight");
  }
  if (flag(link, "kinematic", false)) log_.refuse(link, "a link that is kinematic is not supported");
}

robot_formats::BodyDescription SdfLinks::read(const SdfPart& link, const SdfLinkPose& pose) {
  robot_formats::BodyDescription body;
  body.name = link.name;
  body.where = link.element.where();
  body.solid = read_inertial(link, pose);
  if (const auto inertial = urdf::only_child(link.element, "inertial")) body.solid_where = inertial->where();
  warn_of_settings(link.element);
  urdf::UrdfMeshes& meshes = meshes_of(link.file);
  const auto visuals = link.element.children("visual");
  // Collision shapes have no color of their own: they get that of the first visual.
  const Color color = visuals.empty() ? Color{} : color_of(visuals[0]);
  for (const files::XmlElement& collision : link.element.children("collision")) {
    add_shape({collision, place_of(pose.collisions, collision), true, color, friction_of(collision)}, meshes, body);
  }
  for (const files::XmlElement& visual : visuals) {
    add_shape({visual, place_of(pose.visuals, visual), false, color_of(visual), urdf::standard_friction}, meshes, body);
  }
  return body;
}

void SdfLinks::add_shape(const Shape& shape, urdf::UrdfMeshes& meshes, robot_formats::BodyDescription& body) {
  const files::XmlElement geometry = urdf::needed_child(shape.owner, "geometry");
  for (const files::XmlElement& element : geometry.children()) {
    if (element.tag() == "mesh") return add_mesh(shape, element, meshes, body);
    const auto known = primitive(element);
    if (!known) continue;  // the schema has reported it
    body.shapes.push_back({shape.owner.attribute("name").value_or(""), shape.owner.where(),
                           urdf::placed_shape(*known, shape.place, shape.color, shape.collides, shape.friction), ""});
    return;
  }
}

void SdfLinks::add_mesh(const Shape& shape, const files::XmlElement& mesh, urdf::UrdfMeshes& meshes,
                        robot_formats::BodyDescription& body) {
  const std::string uri = child_text(mesh, "uri", "");
  if (uri.empty()) mesh.fail("mesh without uri; add it");
  const std::string name = shape.owner.attribute("name").value_or("");
  const auto found = meshes.find(uri, vector(mesh, "scale", {1, 1, 1}), mesh.where());
  if (!shape.collides) {
    if (!found) return log_.warn(mesh, fmt::format("for the eye, {}; it is left out", meshes.complaint(uri)));
    body.visuals.push_back(
        {name, shape.owner.where(), found->name, shape.place, shape.color, shape.owner.children("material").empty()});
    const std::string texture = picture_of(shape.owner);
    if (texture.empty()) return;
    const auto picture = meshes.find_picture(texture);
    if (!picture) return log_.warn(shape.owner, fmt::format("for the eye, there is no texture '{}'", texture));
    body.visuals.back().picture = picture->string();
    return;
  }
  try {
    if (!found) mesh.fail(meshes.complaint(uri));
    for (const robot_formats::mesh::ConvexPart& convex : meshes.parts(*found, mesh)) {
      const Transformd at_middle = shape.place * Transformd{convex.middle, {}};
      body.shapes.push_back({name, shape.owner.where(),
                             urdf::placed_shape(convex.shape, at_middle, shape.color, true, shape.friction),
                             found->name, convex.middle});
    }
  } catch (const SetupError& error) {
    if (!log_.lenient()) throw;
    log_.warn(mesh, fmt::format("collision mesh left out: {}", error.what()));
  }
}

}  // namespace murosimf::robot_formats::sdf
