#include "murosimf/robot_formats/mjcf/mjcf_relations.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/mjcf/mjcf_children.h"
#include "murosimf/robot_formats/mjcf/mjcf_defaults.h"
#include "murosimf/robot_formats/mjcf/mjcf_sensor.h"

namespace murosimf::robot_formats::mjcf {
namespace {

std::vector<files::XmlElement> elements(const files::XmlElement& root, std::string_view section, std::string_view tag) {
  std::vector<files::XmlElement> result;
  for (const files::XmlElement& part : root.children(section)) {
    for (const files::XmlElement& element : part.children(tag)) result.push_back(element);
  }
  return result;
}

std::string name_in(const files::XmlElement& element, const char* attribute, std::string_view kind,
                    const std::vector<std::string>& known) {
  const auto name = element.attribute(attribute);
  if (!name) element.fail(fmt::format("{} without {}; add it", element.tag(), attribute));
  if (std::ranges::find(known, *name) == known.end()) {
    element.fail(unknown_name(kind, *name, {known.begin(), known.end()}));
  }
  return *name;
}

/// Whether the element refers to a joint, body or geom of the file that is not part of the robot.
bool is_beside(const files::XmlElement& element, const MjcfNames& names, const std::string& kind) {
  return std::ranges::any_of(std::array{kind + "1", kind + "2"}, [&](const std::string& attribute) {
    const auto name = element.attribute(attribute.c_str());
    return name && names.is_elsewhere(kind, *name);
  });
}

/// Reads a coupling: position of joint1 = polynomial of the position of joint2, both from their reference.
robot_formats::MimicDescription read_mimic(const files::XmlElement& element, const MjcfNames& names,
                                           const robot_formats::RobotDescription& description) {
  MjcfAttributes attributes(element);
  attributes.overlay(element);
  auto polynomial = attributes.numbers("polycoef", 1, 5);
  constexpr std::array<double, 5> otherwise{0, 1, 0, 0, 0};
  for (std::size_t i = polynomial.size(); i < otherwise.size(); ++i) polynomial.push_back(otherwise[i]);
  MUROSIMF_ASSERT(polynomial.size() == otherwise.size());
  if (std::any_of(polynomial.begin() + 2, polynomial.end(), [](double c) { return c != 0; })) {
    element.fail("only joints that are coupled linearly are supported; set the last three of polycoef to 0");
  }
  robot_formats::MimicDescription mimic{name_in(element, "joint1", "joint", names.joints()),
                                        name_in(element, "joint2", "joint", names.joints()), element.where(),
                                        polynomial[1]};
  // The file counts from the references, the description from zero.
  mimic.offset = polynomial[0] + robot_formats::reference_of(description, mimic.joint) -
                 mimic.ratio * robot_formats::reference_of(description, mimic.leader);
  return mimic;
}

void name_held_joint(const files::XmlElement& element, const MjcfNames& names,
                     robot_formats::RobotDescription& description) {
  const std::string joint = name_in(element, "joint1", "joint", names.joints());
  description.warnings.push_back(
      files::one_line(fmt::format("{}: nothing holds joint '{}' at a place; leave the joint out, or give joint2",
                                  element.where(), joint)));
}

std::vector<files::XmlElement> geoms_of_world(const files::XmlElement& root) {
  std::vector<files::XmlElement> geoms;
  for (const files::XmlElement& world : root.children("worldbody")) {
    for (const files::XmlElement& geom : elements_in(world, "geom")) geoms.push_back(geom);
  }
  return geoms;
}

/// The kinds of a geom outside of the robot, as may_touch (model/shape.h) needs them.
struct Kinds {
  std::uint32_t contact_type = 1, contact_affinity = 1;
};

Kinds kinds_of(const MjcfAttributes& geom) {
  const auto mask = [&](const char* name) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(geom.number(name, 1)));
  };
  return {mask("contype"), mask("conaffinity")};
}

/// Lets shapes that stand on the file's own floor stand on the scene's ground, which has the usual kinds.
void stand_on_usual_ground(const files::XmlElement& root, const MjcfDefaults& defaults,
                           robot_formats::RobotDescription& description) {
  std::vector<Kinds> world;
  for (const files::XmlElement& geom : geoms_of_world(root)) world.push_back(kinds_of(defaults.resolve(geom)));
  for (robot_formats::BodyDescription& body : description.bodies) {
    for (robot_formats::ShapeDescription& shape : body.shapes) {
      PlacedShape& placed = shape.placed;
      const auto stands_on = [&](const Kinds& kinds) { return may_touch(placed, kinds); };
      if (!placed.collides || stands_on({}) || std::ranges::none_of(world, stands_on)) continue;
      placed.contact_type |= 1U;
    }
  }
}

std::vector<std::string> world_geoms(const files::XmlElement& root) {
  std::vector<std::string> names;
  for (const files::XmlElement& geom : geoms_of_world(root)) names.push_back(geom.attribute("name").value_or(""));
  return names;
}

class Pairs {
 public:
  Pairs(const files::XmlElement& root, const MjcfNames& names, robot_formats::RobotDescription& description)
      : outside_(world_geoms(root)), names_(names), description_(description) {}

  void read(const files::XmlElement& element) {
    if (is_of_other_tree(element, "geom1") || is_of_other_tree(element, "geom2")) return;
    const auto first = shapes_of(element, "geom1");
    const auto second = shapes_of(element, "geom2");
    for (robot_formats::ShapeDescription* shape : first) collide(*shape, second.empty());
    for (robot_formats::ShapeDescription* shape : second) collide(*shape, first.empty());
    if (!first.empty() && !second.empty()) {
      description_.pairs.push_back({first[0]->name, second[0]->name, element.where()});
    }
  }

 private:
  [[nodiscard]] bool is_of_other_tree(const files::XmlElement& element, const char* attribute) const {
    const auto name = element.attribute(attribute);
    return name && names_.is_elsewhere("geom", *name) && std::ranges::find(outside_, *name) == outside_.end();
  }

  /// The shapes of a geom; none for a geom outside of the robot.
  std::vector<robot_formats::ShapeDescription*> shapes_of(const files::XmlElement& element, const char* attribute) {
    const auto name = element.attribute(attribute);
    if (!name) element.fail(fmt::format("pair without {}; add it", attribute));
    std::vector<robot_formats::ShapeDescription*> shapes;
    std::vector<std::string_view> known(outside_.begin(), outside_.end());
    for (robot_formats::BodyDescription& body : description_.bodies) {
      for (robot_formats::ShapeDescription& shape : body.shapes) {
        if (shape.name == *name) shapes.push_back(&shape);
        if (!shape.name.empty()) known.push_back(shape.name);
      }
    }
    for (const robot_formats::BodyDescription& body : description_.bodies) {
      for (const robot_formats::VisualDescription& visual : body.visuals) {
        if (visual.name == *name) {
          element.fail(
              fmt::format("contact pair with the mesh '{}', which does not collide; give it contype and "
                          "conaffinity",
                          *name));
        }
      }
    }
    if (shapes.empty() && std::ranges::find(outside_, *name) == outside_.end()) {
      element.fail(unknown_name("geom", *name, known));
    }
    return shapes;
  }

  /// Makes a shape collide; with the world it needs the usual kind as well, since the scene has no pairs.
  static void collide(robot_formats::ShapeDescription& shape, bool with_the_world) {
    shape.placed.collides = true;
    if (!with_the_world) return;
    shape.placed.contact_type |= 1U;
    shape.placed.contact_affinity |= 1U;
  }

  std::vector<std::string> outside_;  // names of geoms of the world
  const MjcfNames& names_;
  robot_formats::RobotDescription& description_;
};

}  // namespace

void read_relations(const files::XmlElement& root, const MjcfNames& names, const MjcfDefaults& defaults,
                    robot_formats::RobotDescription& description) {
  // First: a pair may add kinds that would change the answer.
  stand_on_usual_ground(root, defaults, description);
  for (const files::XmlElement& element : elements(root, "equality", "joint")) {
    if (is_beside(element, names, "joint") || element.attribute("active") == "false") continue;
    if (element.attribute("joint2")) {
      description.mimics.push_back(read_mimic(element, names, description));
    } else {
      name_held_joint(element, names, description);
    }
  }
  for (const files::XmlElement& element : elements(root, "contact", "exclude")) {
    if (is_beside(element, names, "body")) continue;
    description.exclusions.push_back({name_in(element, "body1", "body", names.bodies()),
                                      name_in(element, "body2", "body", names.bodies()), element.where()});
  }
  Pairs pairs(root, names, description);
  for (const files::XmlElement& element : elements(root, "contact", "pair")) pairs.read(element);
  for (const files::XmlElement& section : root.children("sensor")) {
    for (const files::XmlElement& element : section.children()) {
      description.sensors.push_back(read_mjcf_sensor(element, root, defaults, description));
    }
  }
}

}  // namespace murosimf::robot_formats::mjcf
