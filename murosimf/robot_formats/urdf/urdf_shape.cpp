#include "murosimf/robot_formats/urdf/urdf_shape.h"

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/urdf/urdf_value.h"

namespace murosimf::robot_formats::urdf {
namespace {

std::optional<UrdfPaint> own_paint(const files::XmlElement& material) {
  const auto color = only_child(material, "color"), texture = only_child(material, "texture");
  UrdfPaint paint{{1, 1, 1}};
  if (texture) paint.picture = needed_text(*texture, "filename");
  if (color) {
    const auto rgba = needed_numbers(*color, needed_text(*color, "rgba"), 4, "rgba of <color>");
    paint.color = {rgba[0], rgba[1], rgba[2], rgba[3]};
  }
  return color || texture ? std::optional(paint) : std::nullopt;
}

void add_paint(const files::XmlElement& material, UrdfPaints& paints) {
  const std::string name = material.attribute("name").value_or("");
  const auto paint = own_paint(material);
  if (paint && !name.empty()) paints.emplace(name, *paint);
}

/// Reads a primitive. Lengths of URDF are whole ones, those of shapes half ones.
Shape read_primitive(const files::XmlElement& element) {
  const std::string tag = element.tag();
  if (tag == "sphere") return Sphere{positive(element, "radius")};
  if (tag == "cylinder") return Cylinder{positive(element, "radius"), 0.5 * positive(element, "length")};
  if (tag == "capsule") return Capsule{positive(element, "radius"), 0.5 * positive(element, "length")};
  const Vec3d size = needed_vector(element, "size");
  if (!(size.x > 0 && size.y > 0 && size.z > 0)) element.fail("size of <box> must be three numbers more than 0");
  return Box{0.5 * size};
}

bool is_primitive(const std::string& tag) {
  return tag == "box" || tag == "cylinder" || tag == "sphere" || tag == "capsule";
}

/// The one shape in a `geometry`.
files::XmlElement only_shape(const files::XmlElement& owner) {
  const files::XmlElement geometry = needed_child(owner, "geometry");
  const auto shapes = geometry.children();
  if (shapes.empty()) geometry.fail("<geometry> is empty; put a box, cylinder, sphere, capsule or mesh into it");
  if (shapes.size() > 1) shapes[1].fail("second shape in <geometry>; give it a visual or collision of its own");
  return shapes[0];
}

/// [1] Friction of the link's `contact`.
std::optional<double> own_friction(const files::XmlElement& link) {
  const auto contact = only_child(link, "contact");
  const auto friction = contact ? only_child(*contact, "lateral_friction") : std::nullopt;
  if (!friction || !friction->attribute("value")) return std::nullopt;
  return at_least_zero(*friction, "value");
}

}  // namespace

PlacedShape placed_shape(const Shape& shape, const Transformd& place, const Color& color, bool collides,
                         double friction) {
  PlacedShape placed;
  placed.shape = shape;
  placed.position = place.position;
  placed.orientation = place.orientation;
  placed.surface.friction = friction;
  placed.color = color;
  placed.collides = collides;
  return placed;
}

UrdfPaints read_paints(const files::XmlElement& robot) {
  UrdfPaints paints;
  for (const files::XmlElement& material : robot.children("material")) add_paint(material, paints);
  // Materials are global: a link may use one that a later link defines.
  for (const files::XmlElement& link : robot.children("link")) {
    for (const files::XmlElement& visual : link.children("visual")) {
      for (const files::XmlElement& material : visual.children("material")) add_paint(material, paints);
    }
  }
  return paints;
}

UrdfPaint UrdfShapes::paint_of(const files::XmlElement& visual) {
  const auto material = only_child(visual, "material");
  if (!material) return {};
  if (const auto paint = own_paint(*material)) return *paint;
  const std::string name = material->attribute("name").value_or("");
  if (const auto found = paints_.find(name); found != paints_.end()) return found->second;
  log_.note(*material, fmt::format("material '{}' has no color; gray is taken", name));
  return {};
}

void UrdfShapes::add(const files::XmlElement& link, robot_formats::BodyDescription& body) {
  const auto visuals = link.children("visual");
  // Collision shapes have no color of their own: they get that of the first visual.
  const UrdfPaint paint = visuals.empty() ? UrdfPaint{} : paint_of(visuals[0]);
  for (const files::XmlElement& collision : link.children("collision")) add_part({collision, true, paint}, body);
  for (const files::XmlElement& visual : visuals) add_part({visual, false, paint_of(visual)}, body);
  const auto friction = own_friction(link);
  for (robot_formats::ShapeDescription& shape : body.shapes) {
    if (friction) shape.placed.surface.friction = *friction;
  }
}

void UrdfShapes::add_part(const Part& part, robot_formats::BodyDescription& body) {
  const files::XmlElement shape = only_shape(part.element);
  const std::string tag = shape.tag();
  if (tag == "mesh") return add_mesh(part, shape, body);
  if (!is_primitive(tag)) return;  // the schema has reported it
  body.shapes.push_back(
      {part.element.attribute("name").value_or(""), part.element.where(),
       placed_shape(read_primitive(shape), read_origin(part.element), part.paint.color, part.collides), ""});
}

void UrdfShapes::add_mesh(const Part& part, const files::XmlElement& mesh, robot_formats::BodyDescription& body) {
  if (!part.collides) return add_visual_mesh(part, mesh, body);
  try {
    add_collision_mesh(part, mesh, body);
  } catch (const SetupError& error) {
    if (!log_.lenient()) throw;
    log_.warn(mesh, fmt::format("collision mesh left out: {}", error.what()));
  }
}

void UrdfShapes::add_visual_mesh(const Part& part, const files::XmlElement& mesh,
                                 robot_formats::BodyDescription& body) {
  const auto found = meshes_.find(mesh);
  if (!found) return log_.warn(mesh, fmt::format("for the eye, {}; it is left out", meshes_.complaint(mesh)));
  body.visuals.push_back({part.element.attribute("name").value_or(""), part.element.where(), found->name,
                          read_origin(part.element), part.paint.color, part.element.children("material").empty()});
  if (part.paint.picture.empty()) return;
  const auto picture = meshes_.find_picture(part.paint.picture);
  if (!picture)
    return log_.warn(part.element, fmt::format("for the eye, there is no texture '{}'", part.paint.picture));
  body.visuals.back().picture = picture->string();
}

void UrdfShapes::add_collision_mesh(const Part& part, const files::XmlElement& mesh,
                                    robot_formats::BodyDescription& body) {
  const auto found = meshes_.find(mesh);
  if (!found) mesh.fail(meshes_.complaint(mesh));
  const Transformd place = read_origin(part.element);
  for (const robot_formats::mesh::ConvexPart& convex : meshes_.parts(*found, mesh)) {
    MUROSIMF_ASSERT(convex.shape.hull != nullptr);
    const Transformd at_middle = place * Transformd{convex.middle, {}};
    body.shapes.push_back({part.element.attribute("name").value_or(""), part.element.where(),
                           placed_shape(convex.shape, at_middle, part.paint.color, true), found->name, convex.middle});
  }
}

}  // namespace murosimf::robot_formats::urdf
