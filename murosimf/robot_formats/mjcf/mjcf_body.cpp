#include "murosimf/robot_formats/mjcf/mjcf_body.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/robot_formats/mjcf/mjcf_camera.h"
#include "murosimf/robot_formats/mjcf/mjcf_children.h"
#include "murosimf/robot_formats/mjcf/mjcf_inertia.h"
#include "murosimf/robot_formats/mjcf/mjcf_joint.h"

namespace murosimf::robot_formats::mjcf {
namespace {

class BodyReader {
 public:
  BodyReader(const MjcfContext& context, robot_formats::RobotDescription& description)
      : context_(context), description_(description) {}

  void read_world(const files::XmlElement& root) {
    description_.fixed_base = true;
    robot_formats::BodyDescription body;
    body.name = world_name;
    for (const files::XmlElement& world : root.children("worldbody")) {
      if (body.where.empty()) body.where = world.where();
      const std::string child_class = context_.defaults.child_class(world, {});
      for (const MjcfChild& child : children_in(world, child_class, context_.defaults, context_.compiler)) {
        const bool site = child.element.tag() == "site" && child.element.attribute("name");
        if (site) body.frames.push_back(read_site(child));
      }
    }
    description_.bodies.push_back(std::move(body));
  }

  void read_base(const files::XmlElement& base, const std::string& outer_class) {
    int joints = 0;
    for (const MjcfChild& child : children_in(base, {}, context_.defaults, context_.compiler)) {
      const files::XmlElement& joint = child.element;
      if (joint.tag() != "joint" && joint.tag() != "freejoint") continue;
      if (++joints > 1) joint.fail("the base has a second joint; besides its free joint it can have none");
      description_.base_joint = joint.attribute("name").value_or("");
    }
    check_gravity(base);
    robot_formats::BodyDescription body;
    body.name = context_.names.of(base);
    body.where = base.where();
    finish(base, context_.defaults.child_class(base, outer_class), std::move(body));
  }

  void read_body(const MjcfChild& child, int parent) {
    const files::XmlElement& element = child.element;
    check_gravity(element);
    robot_formats::BodyDescription body;
    body.name = context_.names.of(element);
    body.where = element.where();
    body.parent = parent;
    body.place = child.frame * place_of(own_attributes(element));
    MUROSIMF_ASSERT(parent >= 0 && parent < static_cast<int>(description_.bodies.size()));
    const std::string child_class = context_.defaults.child_class(element, child.child_class);
    for (const MjcfChild& inner : children_in(element, child_class, context_.defaults, context_.compiler)) {
      const files::XmlElement& joint = inner.element;
      if (joint.tag() == "freejoint") joint.fail("freejoint inside the robot; only its base may be free");
      if (joint.tag() == "joint") read_joints(inner, context_, body.joints);
    }
    finish(element, child_class, std::move(body));
  }

 private:
  /// Reads mass, shapes and sites of a body, then its child bodies.
  void finish(const files::XmlElement& element, const std::string& child_class, robot_formats::BodyDescription body) {
    const auto children = children_in(element, child_class, context_.defaults, context_.compiler);
    read_solid(element, children, body);
    for (const MjcfChild& child : children) {
      if (child.element.tag() == "site") body.frames.push_back(read_site(child));
      if (child.element.tag() == "camera") add_camera(child, body);
    }
    // Before the children, so that parents precede them.
    const int index = static_cast<int>(description_.bodies.size());
    description_.bodies.push_back(std::move(body));
    for (const MjcfChild& child : children) {
      if (child.element.tag() == "body") read_body(child, index);
    }
  }

  void read_solid(const files::XmlElement& element, const std::vector<MjcfChild>& children,
                  robot_formats::BodyDescription& body) {
    std::vector<robot_formats::MassProperties> solids;
    const bool from_geoms = mass_from_geoms(element, context_.compiler);
    for (const MjcfChild& child : children) {
      if (child.element.tag() != "geom") continue;
      const MjcfAttributes attributes = context_.defaults.resolve(child.element, child.child_class);
      const bool makes_mass = counts(attributes);
      const MjcfGeom geom = read_geom(attributes, {context_.compiler, context_.meshes, context_.materials,
                                                   from_geoms && makes_mass, context_.lenient, context_.warnings});
      if (makes_mass) {
        solids.push_back(robot_formats::moved(geom.solid, child.frame.position, child.frame.orientation));
      }
      MUROSIMF_ASSERT(geom.middles.size() == geom.shapes.size());
      for (std::size_t i = 0; i < geom.shapes.size(); ++i) {
        body.shapes.push_back(make_shape(child, attributes, geom.shapes[i]));
        body.shapes.back().middle = geom.middles[i];
      }
      if (geom.visual) body.visuals.push_back(placed_visual(child, *geom.visual));
    }
    body.solid = read_mass(element, solids, context_.compiler, context_.warnings);
    const auto inertials = element.children("inertial");
    if (!from_geoms && !inertials.empty()) body.solid_where = inertials[0].where();
  }

  /// Whether geoms of this group make mass.
  [[nodiscard]] bool counts(const MjcfAttributes& geom) const {
    const double group = geom.number("group", 0);
    return group >= context_.compiler.first_group && group <= context_.compiler.last_group;
  }

  [[nodiscard]] robot_formats::ShapeDescription make_shape(const MjcfChild& child, const MjcfAttributes& attributes,
                                                           PlacedShape placed) const {
    if (std::holds_alternative<Plane>(placed.shape)) {
      child.element.fail("a plane cannot be part of a robot; use a box");
    }
    const Transformd place = child.frame * placed.place();
    placed.position = place.position;
    placed.orientation = place.orientation;
    return {child.element.attribute("name").value_or(""), child.element.where(), placed, attributes.text("mesh")};
  }

  [[nodiscard]] static robot_formats::VisualDescription placed_visual(const MjcfChild& child,
                                                                      robot_formats::VisualDescription visual) {
    visual.place = child.frame * visual.place;
    return visual;
  }

  [[nodiscard]] robot_formats::FrameDescription read_site(const MjcfChild& child) const {
    const MjcfAttributes attributes = context_.defaults.resolve(child.element, child.child_class);
    robot_formats::FrameDescription frame{context_.names.of(child.element), child.element.where()};
    const bool along = attributes.has("fromto");
    frame.place = child.frame * (along ? between_ends(attributes).place() : place_of(attributes));
    // Only a flat box has a length and a width that a sole could have.
    const bool box = !along && attributes.text("type") == "box" && attributes.has("size");
    const auto size = box ? attributes.numbers("size", 2, 3) : std::vector<double>(2);
    if (size[0] > 0 && size[1] > 0) frame.box = Sole{size[0], size[1]};
    return frame;
  }

  /// Adds a camera. With a name it is also a frame for other uses, with the axes of MJCF; a camera that moves on its
  /// body is not a frame.
  void add_camera(const MjcfChild& child, robot_formats::BodyDescription& body) {
    const MjcfAttributes attributes = context_.defaults.resolve(child.element, child.child_class);
    const auto name = child.element.attribute("name");
    robot_formats::SensorDescription camera = read_mjcf_camera(attributes, name.value_or(body.name));
    const Transformd place = child.frame * place_of(attributes);
    if (!camera.obstacle.empty()) {
      camera.frame = body.name;
    } else if (name) {
      body.frames.push_back({*name, child.element.where(), "camera", place, {}});
    } else {
      camera.object_kind = "xbody";
      camera.place = place * camera.place;
    }
    description_.sensors.push_back(std::move(camera));
  }

  /// Refuses gravity compensation (gravcomp), which is not simulated.
  void check_gravity(const files::XmlElement& body) const {
    if (own_attributes(body).number("gravcomp", 0) == 0) return;
    const std::string what =
        fmt::format("body '{}' feels another gravity (gravcomp), which is not simulated", context_.names.of(body));
    if (!context_.lenient) body.fail(what + "; --lenient reads it without");
    context_.warnings.push_back(files::one_line(fmt::format("{}: {}", body.where(), what)));
  }

  [[nodiscard]] static MjcfAttributes own_attributes(const files::XmlElement& element) {
    MjcfAttributes attributes(element);
    attributes.overlay(element);
    return attributes;
  }
  [[nodiscard]] Transformd place_of(const MjcfAttributes& attributes) const {
    return {attributes.vector("pos", {}), read_orientation(attributes, context_.compiler)};
  }

  const MjcfContext& context_;
  robot_formats::RobotDescription& description_;
};

}  // namespace

bool has_free_joint(const files::XmlElement& body, const std::string& outer_class, const MjcfDefaults& defaults) {
  if (!elements_in(body, "freejoint").empty()) return true;
  const std::string child_class = defaults.child_class(body, outer_class);
  return std::ranges::any_of(elements_in(body, "joint"), [&](const files::XmlElement& joint) {
    return defaults.resolve(joint, child_class).text("type") == "free";
  });
}

void read_bodies(const files::XmlElement& root, const MjcfTrees& trees, const MjcfContext& context,
                 robot_formats::RobotDescription& description) {
  BodyReader reader(context, description);
  if (trees.bolted) reader.read_world(root);
  for (const MjcfTree& tree : trees.all) {
    if (!tree.of_robot) continue;
    trees.bolted ? reader.read_body({tree.body, tree.child_class, tree.frame}, 0)
                 : reader.read_base(tree.body, tree.child_class);
  }
}

}  // namespace murosimf::robot_formats::mjcf
