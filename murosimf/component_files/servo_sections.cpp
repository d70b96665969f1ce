#include "murosimf/component_files/servo_sections.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"

namespace murosimf::component_files {
namespace {

constexpr std::size_t line_length = 100;

/// Numbers that distinguish drives: gains, limits and losses of a joint.
struct Drive {
  bool guessed = false;
  double stall_torque = 0, position_gain = 0, velocity_gain = 0;
  double lowest_share = -1, highest_share = 1, command_filter = 0;
  double armature = 0, friction = 0, damping = 0;
  bool operator==(const Drive&) const = default;
};

struct Group {
  Drive drive;
  std::vector<std::string> joints;
};

Drive drive_of(const robot_formats::JointDescription& joint) {
  MUROSIMF_ASSERT(joint.servo.has_value());
  const Servo& servo = *joint.servo;
  return {
      servo.type == guessed_servo, servo.stall_torque,   servo.position_gain, servo.velocity_gain, servo.lowest_share,
      servo.highest_share,         servo.command_filter, joint.armature,      joint.friction,      joint.damping};
}

std::vector<Group> groups_of(const robot_formats::RobotDescription& description) {
  std::set<std::string> followers;
  // Joints that follow others have no servo of their own.
  for (const robot_formats::MimicDescription& mimic : description.mimics) followers.insert(mimic.joint);
  std::vector<Group> groups;
  for (const robot_formats::BodyDescription& body : description.bodies) {
    for (const robot_formats::JointDescription& joint : body.joints) {
      if (!joint.servo || followers.contains(joint.name)) continue;
      const Drive drive = drive_of(joint);
      auto group = std::ranges::find(groups, drive, &Group::drive);
      if (group == groups.end()) group = groups.insert(groups.end(), {drive, {}});
      group->joints.push_back(joint.name);
    }
  }
  return groups;
}

std::string line(std::string_view key, double value, std::string_view meaning) {
  return fmt::format("{:<40}# {}\n", fmt::format("{} = {}", key, value), meaning);
}

std::string unless(double usual, std::string_view key, double value, std::string_view meaning) {
  return value == usual ? "" : line(key, value, meaning);
}

std::string unless_zero(std::string_view key, double value, std::string_view meaning) {
  return unless(0, key, value, meaning);
}

std::string joint_list(const std::vector<std::string>& joints) {
  std::string text = "joints = [\n", row = " ";
  for (const std::string& joint : joints) {
    const std::string item = " " + toml_quoted(joint) + ",";
    // Lines of limited length: a robot may have dozens of joints of one kind.
    if (row.size() + item.size() > line_length && row.size() > 1) {
      text += row + "\n";
      row = " ";
    }
    row += item;
  }
  return text + row + "\n]\n";
}

std::string section(const Drive& drive) {
  const std::string guess = drive.guessed ? " guessed" : "";
  return "law = \"ideal_pd\"\n" + unless_zero("stall_torque", drive.stall_torque, "[N m] largest torque") +
         unless(-1, "lowest_torque_share", drive.lowest_share, "[1] of it: the lowest torque") +
         unless(1, "highest_torque_share", drive.highest_share, "[1] of it: the highest torque") +
         line("position_gain", drive.position_gain, "[N m/rad | N/m]" + guess) +
         unless_zero("velocity_gain", drive.velocity_gain,
                     "[N m s/rad]" + std::string(drive.guessed ? " guessed" : "")) +
         unless_zero("command_filter", drive.command_filter, "[s] time constant of targets") +
         line("rotor_inertia", drive.armature, "[kg m^2] armature of the joint") +
         unless_zero("coulomb_friction", drive.friction, "[N m] frictionloss of the joint") +
         unless_zero("viscous_friction", drive.damping, "[N m s/rad] damping of the joint");
}

}  // namespace

std::string toml_quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : files::one_line(name)) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + "\"";
}

std::string servo_sections(const robot_formats::RobotDescription& description, std::string_view name) {
  std::string text;
  int number = 0;
  for (const Group& group : groups_of(description)) {
    text += fmt::format("[servos.{}_{}]\n{}{}\n", name, ++number, section(group.drive), joint_list(group.joints));
  }
  return text;
}

}  // namespace murosimf::component_files
