#include "murosimf/robot_formats/urdf/urdf_gazebo.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/robot_formats/urdf/gazebo_schema.h"
#include "murosimf/robot_formats/urdf/urdf_sensor.h"
#include "murosimf/robot_formats/urdf/urdf_value.h"

namespace murosimf::robot_formats::urdf {
namespace {

const files::XmlRule& rule() { return gazebo_schema().at("gazebo"); }

bool contains(const files::XmlWords& words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

bool is_true(const files::XmlElement& element) {
  const std::string text = element.text();
  return text == "true" || text == "True" || text == "1";
}

bool takes_weight(const files::XmlElement& element) {
  const std::string tag = element.tag();
  return tag == "gravity" ? !is_true(element) : tag == "turnGravityOff" && is_true(element);
}

/// Whether the element takes motion or speed from a part of the robot.
bool takes_motion(const files::XmlElement& element) {
  const std::string tag = element.tag();
  if (tag == "static" || tag == "kinematic") return is_true(element);
  return tag == "dampingFactor" && text_number(element) != 0;
}

/// Reports elements with the same meaning in any block.
void note_other(const files::XmlElement& element, UrdfLog& log) {
  const std::string tag = element.tag();
  // Order: what changes the motion, then known words, then unknown ones.
  if (takes_weight(element)) {
    log.warn(element, "gravity is switched off for parts of the robot in gazebo; here all of it has weight");
  } else if (takes_motion(element)) {
    log.refuse(element, fmt::format("<{}> {} in a gazebo block is not supported; remove it", tag, element.text()));
  } else if (contains(rule().unsupported_children, tag)) {
    log.refuse(element, fmt::format("<{}> in a gazebo block is not supported; write it as URDF", tag));
  } else if (contains(rule().unused_children, tag)) {
    log.unused(element, fmt::format("gazebo/{}", tag), fmt::format("element '{}' in gazebo is not used", tag));
  } else if (contains(rule().children, tag)) {
    log.unused(element, fmt::format("gazebo/{}", tag),
               fmt::format("element '{}' has no effect in this gazebo block", tag));
  } else {
    log.warn(element, fmt::format("unknown element '{}' in gazebo is not used", tag));
  }
}

double text_at_least_zero(const files::XmlElement& element) {
  const double number = text_number(element);
  if (number < 0) element.fail(fmt::format("<{}> is negative; it must be at least 0", element.tag()));
  return number;
}

/// Reads friction; `first` is the tag of the first direction.
void read_friction(const files::XmlElement& block, const char* first, robot_formats::BodyDescription& body,
                   UrdfLog& log) {
  const auto mu1 = only_child(block, first), mu2 = only_child(block, "mu2");
  if (!mu1 && !mu2) return;
  const double friction = text_at_least_zero(mu1 ? *mu1 : *mu2);
  if (mu2 && text_at_least_zero(*mu2) != friction) {
    log.warn(*mu2, fmt::format("friction of link '{}' differs by direction; {} is taken for all", body.name, first));
  }
  // A block replaces the friction of all shapes of its link, as Gazebo does.
  for (robot_formats::ShapeDescription& shape : body.shapes) shape.placed.surface.friction = friction;
}

void note_surface(const files::XmlElement& element, UrdfLog& log) {
  log.unused(element, "gazebo/collision",
             fmt::format("element '{}' of a collision in gazebo is not used", element.tag()));
}

/// Reads a surface: friction acts like mu1 and mu2; contact solving and bouncing are not used.
void read_surface(const files::XmlElement& surface, robot_formats::BodyDescription& body, UrdfLog& log) {
  for (const files::XmlElement& part : surface.children()) {
    const auto ode = part.tag() == "friction" ? only_child(part, "ode") : std::nullopt;
    if (ode) {
      read_friction(*ode, "mu", body, log);
    } else {
      note_surface(part, log);
    }
  }
}

/// Reads SDF inside URDF: only the surface of a collision is allowed here.
void read_collision(const files::XmlElement& collision, robot_formats::BodyDescription& body, UrdfLog& log) {
  for (const files::XmlElement& element : collision.children()) {
    const std::string tag = element.tag();
    if (tag == "surface") {
      read_surface(element, body, log);
    } else if (tag == "geometry" || tag == "pose") {
      log.refuse(element, fmt::format("<{}> of a collision in a gazebo block is not supported; write it as URDF", tag));
    } else {
      note_surface(element, log);
    }
  }
}

void read_link_block(const files::XmlElement& block, robot_formats::BodyDescription& body,
                     robot_formats::RobotDescription& description, UrdfLog& log) {
  read_friction(block, "mu1", body, log);
  for (const files::XmlElement& element : block.children()) {
    const std::string tag = element.tag();
    if (tag == "mu1" || tag == "mu2") continue;
    if (tag == "collision") {
      read_collision(element, body, log);
      continue;
    }
    if (tag == "sensor") {
      MUROSIMF_ASSERT(body.parent < static_cast<int>(description.bodies.size()));
      const std::string parent = body.parent < 0 ? "" : description.bodies[body.parent].name;
      description.sensors.push_back(read_sensor(element, {body.name, parent, body.name}, log));
    } else {
      note_other(element, log);
    }
  }
}

/// Reads a block of a joint. A sensor is on the link behind the joint, which has the joint's frame: a fixed joint is no object of the model.
void read_joint_block(const files::XmlElement& block, const SensorPlace& at, robot_formats::JointDescription* joint,
                      robot_formats::RobotDescription& description, UrdfLog& log) {
  for (const files::XmlElement& element : block.children()) {
    const std::string tag = element.tag();
    if (tag == "springStiffness" && joint) {
      joint->stiffness = text_at_least_zero(element);
    } else if (tag == "springReference" && joint) {
      joint->spring_reference = text_number(element);
    } else if (tag == "sensor") {
      description.sensors.push_back(read_sensor(element, at, log));
    } else {
      note_other(element, log);
    }
  }
}

robot_formats::JointDescription* moving_joint(robot_formats::RobotDescription& description, const std::string& name) {
  for (robot_formats::BodyDescription& body : description.bodies) {
    for (robot_formats::JointDescription& joint : body.joints) {
      if (joint.name == name) return &joint;
    }
  }
  return nullptr;
}

void read_block(const files::XmlElement& block, const std::string& name, const UrdfTree& tree,
                robot_formats::RobotDescription& description, UrdfLog& log) {
  const auto body =
      std::ranges::find_if(description.bodies, [&](const robot_formats::BodyDescription& b) { return b.name == name; });
  if (body != description.bodies.end()) return read_link_block(block, *body, description, log);
  if (const int joint = tree.find_joint(name); joint >= 0) {
    MUROSIMF_ASSERT(tree.joints[joint].child >= 0 && tree.joints[joint].parent >= 0);
    const std::string& child = tree.links[tree.joints[joint].child].name;
    const std::string& parent = tree.links[tree.joints[joint].parent].name;
    robot_formats::JointDescription* moving = moving_joint(description, name);
    const SensorPlace at{moving ? moving->name : child, parent, child};
    return read_joint_block(block, at, moving, description, log);
  }
  log.warn(block, fmt::format("gazebo block for '{}', which is no link or joint; it is left out", name));
}

}  // namespace

void read_gazebo(const files::XmlElement& robot, const UrdfTree& tree, robot_formats::RobotDescription& description,
                 UrdfLog& log) {
  for (const files::XmlElement& block : robot.children("gazebo")) {
    if (const auto name = block.attribute("reference")) {
      read_block(block, *name, tree, description, log);
    } else {
      for (const files::XmlElement& element : block.children()) note_other(element, log);
    }
  }
}

}  // namespace murosimf::robot_formats::urdf
