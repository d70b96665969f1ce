#include "murosimf/robot_formats/proto/proto_walk.h"

#include <fmt/format.h>

#include "murosimf/files/lower_case.h"
#include "murosimf/math/assert.h"
#include "murosimf/robot_formats/proto/proto_joint.h"
#include "murosimf/robot_formats/proto/proto_physics.h"
#include "murosimf/robot_formats/proto/proto_schema.h"
#include "murosimf/robot_formats/proto/proto_sensor.h"

namespace murosimf::robot_formats::proto {
namespace {

/// The name of a Solid; without one "solid", "camera", as in Webots.
std::string name_of(const Node& solid) {
  const std::string usual = solid.def.empty() ? files::lower_case(solid.type) : solid.def;
  const std::string name = solid.text("name", usual);
  return name.empty() ? usual : name;
}

/// Whether a device without measurement has no effect at all: no body and no children.
bool is_bodiless(const Node& device) {
  return !device.child("physics") && !device.child("boundingObject") && device.children("children").empty();
}

}  // namespace

std::string ProtoWalk::free_name(std::set<std::string>& taken, const std::string& name) const {
  std::string free = name;
  for (int number = 2; !taken.insert(free).second; ++number) free = fmt::format("{}_{}", name, number);
  return free;
}

void ProtoWalk::check_scale(const Node& node, const Spot& spot) {
  const Placing inner = placed_in(spot.at, node);
  if (is_zero(inner.scale - Vec3d{1, 1, 1})) return;
  log_.refuse(node, fmt::format("{} in a Transform with a scale, which masses do not follow", node.type));
}

int ProtoWalk::begin_body(const Node& solid) {
  robot_formats::BodyDescription body;
  body.name = free_name(bodies_, name_of(solid));
  if (body.name != name_of(solid)) {
    log_.note(solid.where, fmt::format("a second {} is called '{}' here", name_of(solid), body.name));
  }
  body.where = solid.where;
  description_.bodies.push_back(std::move(body));
  MUROSIMF_ASSERT(!description_.bodies.empty());
  return static_cast<int>(description_.bodies.size()) - 1;
}

void ProtoWalk::add_masses(const Node& solid, robot_formats::BodyDescription& body) {
  std::vector<robot_formats::MassProperties> bounding;
  if (const NodePtr shape = solid.child("boundingObject")) bounding = geometry_.add_bounding(*shape, {}, body);
  const NodePtr physics = solid.child("physics");
  if (!physics) return;
  body.solid = read_physics(*physics, bounding, log_);
  body.solid_where = physics->where;
}

void ProtoWalk::fill_body(const Node& solid, int number) {
  MUROSIMF_ASSERT(number >= 0 && number < static_cast<int>(description_.bodies.size()));
  log_.check_fields(solid);
  // Moved out: children append bodies, which would invalidate a reference.
  robot_formats::BodyDescription body = std::move(description_.bodies[number]);
  add_masses(solid, body);
  description_.bodies[number] = std::move(body);
  add_children(solid, {number, {}});
}

void ProtoWalk::add_base(const Node& robot) {
  check_scale(robot, {});
  MUROSIMF_ASSERT(description_.bodies.empty());
  const int base = begin_body(robot);
  if (!robot.child("physics")) {
    description_.fixed_base = true;
    log_.note(robot.where, fmt::format("the robot is bolted to the world, since its {} has no Physics", robot.type));
  }
  fill_body(robot, base);
  // Without selfCollision parts of the robot touch the ground, of kind 1, and no other part, of kind 2.
  if (robot.flag("selfCollision", false)) return;
  for (robot_formats::BodyDescription& body : description_.bodies) {
    for (robot_formats::ShapeDescription& shape : body.shapes) {
      if (shape.placed.collides) shape.placed.contact_type = 2;
    }
  }
}

void ProtoWalk::add_children(const Node& parent, const Spot& spot) {
  for (const NodePtr& child : parent.children("children")) add_child(*child, spot);
}

void ProtoWalk::add_child(const Node& child, const Spot& spot) {
  geometry_.count(child);
  if (is_group(child.type)) {
    log_.check_fields(child);
    return add_children(child, {spot.body, placed_in(spot.at, child)});
  }
  if (is_joint(child.type)) return add_joint(child, spot);
  if (is_solid(child.type)) return add_device(child, spot);
  if (child.type == "Shape") return geometry_.add_visual(child, spot.at, description_.bodies[spot.body]);
  if (child.type == "Slot") {
    if (const NodePtr end = child.child("endPoint")) add_child(*end, spot);
    return;
  }
  if (is_scenery(child.type)) return log_.unused(child.where, child.type, fmt::format("{} is not used", child.type));
  log_.refuse(child, is_base_node(child.type)
                         ? fmt::format("{} is not supported", child.type)
                         : fmt::format("there is no node {}, and no file {}.proto beside", child.type, child.type));
}

void ProtoWalk::add_device(const Node& device, const Spot& spot) {
  const auto sensor = read_sensor(device, "", old_, log_);
  const bool plain = device.type == "Solid" || device.type == "Robot";
  if (!plain && !sensor) log_.unused(device.where, device.type, fmt::format("{} is not simulated", device.type));
  if (!plain && !sensor && is_bodiless(device)) return;
  add_fixed(device, spot);
}

void ProtoWalk::add_fixed(const Node& solid, const Spot& spot) {
  check_scale(solid, spot);
  const int number = begin_body(solid);
  robot_formats::BodyDescription& body = description_.bodies[number];
  MUROSIMF_ASSERT(spot.body < number);
  body.parent = spot.body;
  body.place = placed_in(spot.at, solid).place;
  if (auto sensor = read_sensor(solid, body.name, old_, log_)) description_.sensors.push_back(*std::move(sensor));
  fill_body(solid, number);  // last: it appends bodies, which invalidates `body`
}

void ProtoWalk::add_joint(const Node& joint, const Spot& spot) {
  const NodePtr end = joint.child("endPoint");
  if (!end)
    return log_.unused(joint.where, joint.type + " without endPoint", fmt::format("{} moves nothing", joint.type));
  if (end->type == "SolidReference") {
    return log_.refuse(*end, fmt::format("{} to a SolidReference, which closes a loop, is not supported", joint.type));
  }
  if (!is_solid(end->type)) {
    return log_.refuse(*end, fmt::format("{} as endPoint is no Solid{}", end->type,
                                         is_base_node(end->type) ? "" : ", and there is no file of it beside"));
  }
  check_scale(*end, spot);
  const int number = begin_body(*end);
  robot_formats::BodyDescription& body = description_.bodies[number];
  MUROSIMF_ASSERT(spot.body < number);
  body.parent = spot.body;
  const Transformd pose = placed_in({{}, spot.at.scale}, *end).place;
  body.place = spot.at.place * pose;
  body.joints = read_joints(joint, {body.name, pose}, log_);
  for (robot_formats::JointDescription& one : body.joints) {
    const std::string name = free_name(joints_, one.name);
    if (name != one.name) log_.warn(one.where, fmt::format("a second joint '{}' is called '{}' here", one.name, name));
    one.name = name;
  }
  if (auto sensor = read_sensor(*end, body.name, old_, log_)) description_.sensors.push_back(*std::move(sensor));
  add_joint_devices(joint, number);
  if (!joint.child("endPoint")->child("physics")) {
    log_.note(end->where, fmt::format("Solids that joints move without Physics have no mass: '{}'", name_of(*end)));
  }
  fill_body(*end, number);
}

void ProtoWalk::add_joint_devices(const Node& joint, int body) {
  const auto& joints = description_.bodies[body].joints;
  constexpr const char* fields[] = {"device", "device2"};
  MUROSIMF_ASSERT(joints.size() <= 2);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    for (const NodePtr& device : joint.children(fields[i])) {
      if (device->type == "PositionSensor")
        description_.sensors.push_back(read_position_sensor(*device, joints[i].name));
      if (device->type == "Brake") log_.unused(device->where, "Brake", "brakes are not simulated: they are open");
    }
  }
  if (joint.number("backlash", 0) > 0) {
    log_.unused(joint.where, joint.type + ".backlash", "backlash of joints is not used; a servo's table can have it");
  }
}

}  // namespace murosimf::robot_formats::proto
