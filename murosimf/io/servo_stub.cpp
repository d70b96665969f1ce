#include "murosimf/io/servo_stub.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/io/xml_element.h"

namespace murosimf::io {
namespace {

constexpr std::size_t line_length = 100;

/// What tells drives apart: gains, limits and losses of a joint. Zero gains and limits: not in the file.
struct Drive {
  bool has_servo = false;
  double stall_torque = 0, no_load_rate = 0, position_gain = 0, velocity_gain = 0;
  double armature = 0, friction = 0, damping = 0;
  bool operator==(const Drive&) const = default;
};

struct Group {
  Drive drive;
  std::vector<std::string> joints;
};

Drive drive_of(const DraftJoint& joint) {
  Drive drive{joint.servo.has_value()};
  drive.armature = joint.armature;
  drive.friction = joint.friction;
  drive.damping = joint.damping;
  if (joint.servo) {
    drive.stall_torque = joint.servo->stall_torque;
    drive.position_gain = joint.servo->position_gain;
    drive.velocity_gain = joint.servo->velocity_gain;
  } else {
    drive.stall_torque = joint.effort_limit;
    drive.no_load_rate = joint.rate_limit;
  }
  return drive;
}

bool is_passive(const Drive& drive) { return !drive.has_servo && drive.stall_torque == 0 && drive.no_load_rate == 0; }

std::vector<Group> groups_of(const RobotDraft& draft) {
  std::set<std::string> followers;
  for (const DraftMimic& mimic : draft.mimics) followers.insert(mimic.joint);
  std::vector<Group> groups;
  for (const DraftBody& body : draft.bodies) {
    for (const DraftJoint& joint : body.joints) {
      const Drive drive = drive_of(joint);
      if (is_passive(drive) || followers.contains(joint.name)) continue;
      auto group = std::ranges::find(groups, drive, &Group::drive);
      if (group == groups.end()) group = groups.insert(groups.end(), {drive, {}});
      group->joints.push_back(joint.name);
    }
  }
  return groups;
}

std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : one_line(name)) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + "\"";
}

std::string line(std::string_view key, double value, std::string_view meaning) {
  return fmt::format("{:<40}# {}\n", fmt::format("{} = {}", key, value), meaning);
}

std::string unless_zero(std::string_view key, double value, std::string_view meaning) {
  return value == 0 ? "" : line(key, value, meaning);
}

/// A number, or dots where the file has none.
std::string known_or_dots(std::string_view key, double value, std::string_view meaning) {
  if (value != 0) return line(key, value, meaning);
  return fmt::format("{:<40}# {}: not in the file\n", fmt::format("{} = ...", key), meaning);
}

std::string joint_list(const std::vector<std::string>& joints) {
  std::string text = "joints = [\n", row = " ";
  for (const std::string& joint : joints) {
    const std::string item = " " + quoted(joint) + ",";
    if (row.size() + item.size() > line_length && row.size() > 1) {
      text += row + "\n";
      row = " ";
    }
    row += item;
  }
  return text + row + "\n]\n";
}

std::string complete_section(const Drive& drive) {
  return "law = \"ideal_pd\"\n" + unless_zero("stall_torque", drive.stall_torque, "[N m] largest torque") +
         line("position_gain", drive.position_gain, "[N m/rad]") +
         unless_zero("velocity_gain", drive.velocity_gain, "[N m s/rad]") +
         line("rotor_inertia", drive.armature, "[kg m^2] armature of the joint") +
         unless_zero("coulomb_friction", drive.friction, "[N m] frictionloss of the joint") +
         unless_zero("viscous_friction", drive.damping, "[N m s/rad] damping of the joint");
}

std::string open_section(const Drive& drive) {
  return known_or_dots("stall_torque", drive.stall_torque, "[N m] limit of the effort") +
         known_or_dots("no_load_rate", drive.no_load_rate, "[rad/s] limit of the rate") +
         known_or_dots("position_gain", 0, "[N m/rad] torque at rest per angle between target and position") +
         known_or_dots("rotor_inertia", drive.armature, "[kg m^2]") +
         known_or_dots("coulomb_friction", drive.friction, "[N m]") +
         unless_zero("viscous_friction", drive.damping, "[N m s/rad]");
}

std::string commented_out(const std::string& text) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin) + 1;
    result += "# " + text.substr(begin, end - begin);
    begin = end;
  }
  return result;
}

std::string soles(const RobotDraft& draft) {
  std::vector<std::string> boxes;
  for (const DraftBody& body : draft.bodies) {
    for (const DraftFrame& frame : body.frames) {
      if (frame.box) boxes.push_back(quoted(frame.name));
    }
  }
  if (boxes.empty()) return "";
  return fmt::format(
      "# [soles]  # without this, box sites whose names end in \"sole\"; box sites: {}\n"
      "# left = {}\n# right = {}\n\n",
      fmt::join(boxes, ", "), boxes.front(), boxes.back());
}

}  // namespace

std::string servo_stub(const RobotDraft& draft) {
  std::string text = fmt::format(
      "# What the file of {} cannot say (docs/robots.md). Servos on the output side of the gear, SI units.\n"
      "# A section that is commented out lacks numbers: fill in the dots, and remove the # from all of its lines.\n"
      "# Or write the type of a ready-made servo instead of the numbers: type = \"mx64\".\n\n",
      one_line(draft.name));
  text += soles(draft);
  int number = 0;
  for (const Group& group : groups_of(draft)) {
    const std::string head = fmt::format("[servos.servo_{}]\n", ++number);
    const std::string joints = joint_list(group.joints);
    text += group.drive.has_servo ? head + complete_section(group.drive) + joints
                                  : commented_out(head + open_section(group.drive) + joints);
    text += "\n";
  }
  text.pop_back();
  return text;
}

}  // namespace murosimf::io
