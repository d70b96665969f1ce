#include "murosimf/robot_formats/mjcf/mjcf_keyframe.h"

#include <algorithm>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/math/quaternion.h"
#include "murosimf/robot_formats/mjcf/mjcf_children.h"
#include "murosimf/robot_formats/mjcf/mjcf_joint.h"

namespace murosimf::robot_formats::mjcf {
namespace {

/// A joint of the file in qpos.
struct Slot {
  std::string type, name;
  bool of_robot = false;

  [[nodiscard]] std::size_t numbers() const { return type == "free" ? 7 : type == "ball" ? 4 : 1; }
};

void add_slots(const files::XmlElement& body, const std::string& outer_class, bool of_robot, const MjcfContext& context,
               std::vector<Slot>& slots) {
  const std::string child_class = context.defaults.child_class(body, outer_class);
  const auto children = children_in(body, child_class, context.defaults, context.compiler);
  for (const MjcfChild& child : children) {
    const std::string tag = child.element.tag();
    if (tag != "joint" && tag != "freejoint") continue;
    const auto attributes = context.defaults.resolve(child.element, child.child_class);
    Slot& slot = slots.emplace_back(Slot{tag == "freejoint" ? "free" : attributes.text("type", "hinge"), {}, of_robot});
    if (of_robot && slot.type != "free") slot.name = context.names.of(child.element);
  }
  // Depth first, as MuJoCo orders qpos: all joints of a body, then its child bodies.
  for (const MjcfChild& child : children) {
    if (child.element.tag() == "body") add_slots(child.element, child.child_class, of_robot, context, slots);
  }
}

/// All joints in the order of qpos.
std::vector<Slot> slots_of(const MjcfTrees& trees, const MjcfContext& context) {
  std::vector<Slot> slots;
  for (const MjcfTree& tree : trees.all) add_slots(tree.body, tree.child_class, tree.of_robot, context, slots);
  return slots;
}

/// Exactly `count` numbers; none if the attribute is missing.
std::vector<double> row_of(const files::XmlElement& key, const char* name, std::size_t count) {
  MjcfAttributes attributes(key);
  attributes.overlay(key);
  return attributes.numbers(name, count, count);
}

Mat3d read_turn(const files::XmlElement& key, std::span<const double> q) {
  MUROSIMF_ASSERT(q.size() >= 4);
  if (!(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] > 1e-24)) {
    key.fail("qpos of the key has a quaternion of length zero; write 1 0 0 0 for no turn");
  }
  return to_matrix(normalized(Quaterniond{q[0], q[1], q[2], q[3]}));
}

void set_slot(const files::XmlElement& key, const Slot& slot, std::span<const double> q,
              robot_formats::KeyframeDescription& frame) {
  MUROSIMF_ASSERT(q.size() >= slot.numbers());
  if (slot.type == "free") {
    frame.base = {{q[0], q[1], q[2]}, read_turn(key, q.subspan(3))};
  } else if (slot.type == "ball") {
    const Vec3d angles = ball_angles(read_turn(key, q));
    frame.positions[slot.name + ".x"] = angles.x;
    frame.positions[slot.name + ".y"] = angles.y;
    frame.positions[slot.name + ".z"] = angles.z;
  } else {
    frame.positions[slot.name] = q[0];
  }
}

void read_positions(const files::XmlElement& key, const std::vector<Slot>& slots,
                    const robot_formats::RobotDescription& description, robot_formats::KeyframeDescription& frame) {
  MUROSIMF_ASSERT(!description.bodies.empty());
  frame.base = description.bodies[0].place;
  for (const robot_formats::BodyDescription& body : description.bodies) {
    for (const robot_formats::JointDescription& joint : body.joints) frame.positions[joint.name] = joint.reference;
  }
  std::size_t count = 0;
  for (const Slot& slot : slots) count += slot.numbers();
  const auto qpos = row_of(key, "qpos", count);
  if (qpos.empty()) return;
  std::span<const double> rest = qpos;
  for (const Slot& slot : slots) {
    if (slot.of_robot) set_slot(key, slot, rest, frame);
    rest = rest.subspan(slot.numbers());
  }
  MUROSIMF_ASSERT(rest.empty());
}

void read_targets(const files::XmlElement& key, const std::vector<MjcfControl>& controls,
                  robot_formats::KeyframeDescription& frame) {
  const auto ctrl = row_of(key, "ctrl", controls.size());
  for (std::size_t i = 0; i < ctrl.size(); ++i) {
    const MjcfControl& control = controls[i];
    if (control.is_position) frame.targets[control.joint] = control.offset + control.scale * ctrl[i];
  }
}

}  // namespace

void read_keyframes(const files::XmlElement& root, const MjcfTrees& trees, const MjcfContext& context,
                    const MjcfActuators& actuators, robot_formats::RobotDescription& description) {
  const std::vector<Slot> slots = slots_of(trees, context);
  int number = 0;
  for (const files::XmlElement& section : root.children("keyframe")) {
    for (const files::XmlElement& key : section.children("key")) {
      const std::string name = key.attribute("name").value_or(fmt::format("key{}", ++number));
      const auto same = [&](const robot_formats::KeyframeDescription& other) { return other.name == name; };
      if (std::ranges::any_of(description.keyframes, same)) {
        key.fail(fmt::format("key '{}' appears twice; rename one", name));
      }
      robot_formats::KeyframeDescription frame{name, key.where(), {}, {}, {}};
      read_positions(key, slots, description, frame);
      read_targets(key, actuators.controls, frame);
      description.keyframes.push_back(std::move(frame));
      description.notes.push_back(files::one_line(
          fmt::format("{}: a robot of a scene starts there with keyframe = \"{}\"", key.where(), name)));
    }
  }
}

}  // namespace murosimf::robot_formats::mjcf
