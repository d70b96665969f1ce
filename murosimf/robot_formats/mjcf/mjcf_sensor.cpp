#include "murosimf/robot_formats/mjcf/mjcf_sensor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/robot_formats/mjcf/mjcf_camera.h"
#include "murosimf/robot_formats/mjcf/mjcf_children.h"

namespace murosimf::robot_formats::mjcf {
namespace {

/// Kinds by the attribute that names their object. Frame sensors have objtype and objname.
struct Family {
  const char* attribute;
  std::array<std::string_view, 16> kinds;
};

constexpr std::array families{
    Family{"site", {"accelerometer", "gyro", "velocimeter", "force", "torque", "touch", "rangefinder", "magnetometer"}},
    Family{"joint", {"jointpos", "jointvel", "jointactuatorfrc", "jointlimitpos", "jointlimitvel", "jointlimitfrc"}},
    Family{"actuator", {"actuatorpos", "actuatorvel", "actuatorfrc"}},
    Family{"body", {"subtreecom", "subtreelinvel", "subtreeangmom"}},
    Family{"objname",
           {"framepos", "framequat", "framexaxis", "frameyaxis", "framezaxis", "framelinvel", "frameangvel",
            "framelinacc", "frameangacc"}}};

/// The attribute that names the object of a kind; null for unknown kinds.
const char* attribute_of(std::string_view kind) {
  for (const Family& family : families) {
    // Empty entries fill the arrays.
    if (!kind.empty() && std::ranges::find(family.kinds, kind) != family.kinds.end()) return family.attribute;
  }
  return nullptr;
}

const robot_formats::BodyDescription* find_body(const robot_formats::RobotDescription& description,
                                                const std::string& name) {
  const auto body = std::ranges::find(description.bodies, name, &robot_formats::BodyDescription::name);
  return body == description.bodies.end() ? nullptr : &*body;
}

bool has_joint(const robot_formats::RobotDescription& description, const std::string& name) {
  return std::ranges::any_of(description.bodies, [&](const robot_formats::BodyDescription& body) {
    return std::ranges::find(body.joints, name, &robot_formats::JointDescription::name) != body.joints.end();
  });
}

bool has_frame(const robot_formats::RobotDescription& description, const std::string& name, std::string_view kind) {
  return std::ranges::any_of(description.bodies, [&](const robot_formats::BodyDescription& body) {
    return std::ranges::any_of(body.frames, [&](const robot_formats::FrameDescription& f) {
      return f.name == name && f.kind == kind;
    });
  });
}

std::vector<files::XmlElement> actuators_called(const files::XmlElement& root, const std::string& name) {
  std::vector<files::XmlElement> found;
  for (const files::XmlElement& section : root.children("actuator")) {
    for (const files::XmlElement& actuator : section.children()) {
      if (actuator.attribute("name") == name) found.push_back(actuator);
    }
  }
  return found;
}

/// Makes a sensor of an actuator one of its joint: the force is the same if no gear is between them.
void move_to_joint(robot_formats::SensorDescription& sensor, const files::XmlElement& root,
                   const MjcfDefaults& defaults) {
  for (const files::XmlElement& actuator : actuators_called(root, sensor.frame)) {
    const MjcfAttributes attributes = defaults.resolve(actuator);
    const auto gear = attributes.numbers("gear", 1, 6);
    if (!gear.empty() && gear[0] != 1) sensor.obstacle = "the gear of its actuator is not 1";
    if (const std::string joint = attributes.text("joint"); !joint.empty()) {
      sensor.frame = joint;
      sensor.object_kind = "joint";
      return;
    }
  }
  sensor.obstacle = "its actuator moves no joint";
}

void place_on_body(robot_formats::SensorDescription& sensor, const robot_formats::RobotDescription& description) {
  if (sensor.kind == "framequat") {
    sensor.obstacle = "it shows axes of inertia; write objtype=\"xbody\"";
    // Sensors of a "body" measure at the center of mass.
  } else if (const robot_formats::BodyDescription* body = find_body(description, sensor.frame)) {
    sensor.place.position = body->solid.center;
  }
}

void read_signal(const MjcfAttributes& attributes, robot_formats::SensorDescription& sensor) {
  const double noise = attributes.number("noise", 0), cutoff = attributes.number("cutoff", 0);
  if (noise < 0) attributes.source("noise").fail("noise of the sensor is negative; it must be at least 0");
  if (noise > 0) sensor.signals[""].noise = noise;
  if (!(cutoff > 0) || sensor.kind == "framequat") return;
  sensor.signals[""].highest = cutoff;
  sensor.signals[""].lowest = -cutoff;
}

/// Whether the object is in the written file.
bool object_is_there(const robot_formats::SensorDescription& sensor,
                     const robot_formats::RobotDescription& description) {
  const std::string &kind = sensor.object_kind, &name = sensor.frame;
  if (kind == "joint") return has_joint(description, name);
  if (kind == "body" || kind == "xbody") return find_body(description, name) || has_frame(description, name, "body");
  return has_frame(description, name, kind);
}

/// Kind in the written file: actuators are written as sensors of their joints' torques.
const char* written_kind(const robot_formats::SensorDescription& sensor) {
  return sensor.kind == "actuatorfrc" ? "jointactuatorfrc" : sensor.kind.c_str();
}

void write_sensor(files::XmlText& xml, const robot_formats::SensorDescription& sensor) {
  const char* kind = written_kind(sensor);
  MUROSIMF_ASSERT(attribute_of(kind) != nullptr);
  const std::string attribute = attribute_of(kind);
  xml.begin(kind).text_unless_empty("name", sensor.name);
  if (attribute == "objname") xml.text("objtype", sensor.object_kind);
  xml.text(attribute.c_str(), sensor.frame);
  if (const auto signal = sensor.signals.find(""); signal != sensor.signals.end()) {
    xml.number_unless(0, "noise", signal->second.noise);
    if (std::isfinite(signal->second.highest)) xml.numbers("cutoff", {signal->second.highest});
  }
  xml.end();
}

}  // namespace

robot_formats::SensorDescription read_mjcf_sensor(const files::XmlElement& element, const files::XmlElement& root,
                                                  const MjcfDefaults& defaults,
                                                  const robot_formats::RobotDescription& description) {
  robot_formats::SensorDescription sensor{element.tag(), element.attribute("name").value_or(""), "", element.where()};
  for (const char* attribute : {"site", "objname", "joint", "body", "actuator", "geom", "camera"}) {
    const auto name = element.attribute(attribute);
    if (!name) continue;
    sensor.frame = *name;
    sensor.object_kind =
        attribute == std::string_view("objname") ? element.attribute("objtype").value_or("") : attribute;
  }
  if (sensor.object_kind == "geom") sensor.obstacle = "it is that of a geom; put a site there";
  if (element.attribute("refname")) sensor.obstacle = "it is relative to another frame";
  if (sensor.object_kind == "actuator") move_to_joint(sensor, root, defaults);
  if (sensor.object_kind == "body" && sensor.kind.starts_with("frame")) place_on_body(sensor, description);
  MjcfAttributes attributes(element);
  attributes.overlay(element);
  read_signal(attributes, sensor);
  return sensor;
}

bool is_mjcf_sensor(const robot_formats::SensorDescription& sensor,
                    const robot_formats::RobotDescription& description) {
  if (is_mjcf_camera(sensor)) return object_is_there(sensor, description);
  const bool complete = sensor.obstacle.empty() && !sensor.object_kind.empty();
  return complete && attribute_of(written_kind(sensor)) && object_is_there(sensor, description);
}

void write_mjcf_sensors(files::XmlText& xml, const robot_formats::RobotDescription& description) {
  const auto fits = [&](const robot_formats::SensorDescription& sensor) {
    return !is_mjcf_camera(sensor) && is_mjcf_sensor(sensor, description);
  };
  const bool any = std::ranges::any_of(description.sensors, fits);
  if (any) xml.begin("sensor");
  for (const robot_formats::SensorDescription& sensor : description.sensors) {
    if (is_mjcf_camera(sensor)) continue;  // written in its body
    if (fits(sensor)) {
      write_sensor(xml, sensor);
    } else {
      xml.comment(fmt::format("sensor {} '{}' at '{}'", sensor.kind, sensor.name, sensor.frame));
    }
  }
  if (any) xml.end();
}

}  // namespace murosimf::robot_formats::mjcf
