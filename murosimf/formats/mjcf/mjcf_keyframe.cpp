#include "murosimf/formats/mjcf/mjcf_keyframe.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "murosimf/math/quaternion.h"

namespace murosimf::formats::mjcf {
namespace {

constexpr std::size_t base_numbers = 7;

/// Names of the joints in the order of qpos.
std::vector<std::string> joint_names(const description::RobotDescription& description) {
  std::vector<std::string> names;
  for (const description::BodyDescription& body : description.bodies) {
    for (const description::JointDescription& joint : body.joints) names.push_back(joint.name);
  }
  return names;
}

/// Exactly so many numbers; none if the attribute is not there.
std::vector<double> row_of(const files::XmlElement& key, const char* name, std::size_t count) {
  MjcfAttributes attributes(key);
  attributes.overlay(key);
  return attributes.numbers(name, count, count);
}

void read_positions(const files::XmlElement& key, const std::vector<std::string>& joints,
                    const description::RobotDescription& description, description::KeyframeDescription& frame) {
  const auto qpos = row_of(key, "qpos", base_numbers + joints.size());
  for (std::size_t i = 0; i < joints.size(); ++i) {
    frame.positions[joints[i]] =
        qpos.empty() ? description::reference_of(description, joints[i]) : qpos[base_numbers + i];
  }
  if (qpos.empty()) {
    frame.base = description.bodies[0].place;
    return;
  }
  const Quaterniond turn{qpos[3], qpos[4], qpos[5], qpos[6]};
  if (!(qpos[3] * qpos[3] + qpos[4] * qpos[4] + qpos[5] * qpos[5] + qpos[6] * qpos[6] > 1e-24)) {
    key.fail("qpos of the key has a quaternion of length zero; write 1 0 0 0 for no turn");
  }
  frame.base = {{qpos[0], qpos[1], qpos[2]}, to_matrix(normalized(turn))};
}

void read_targets(const files::XmlElement& key, const std::vector<MjcfControl>& controls,
                  description::KeyframeDescription& frame) {
  const auto ctrl = row_of(key, "ctrl", controls.size());
  for (std::size_t i = 0; i < ctrl.size(); ++i) {
    const MjcfControl& control = controls[i];
    if (control.is_position) frame.targets[control.joint] = control.offset + control.scale * ctrl[i];
  }
}

}  // namespace

void read_keyframes(const files::XmlElement& root, const MjcfActuators& actuators, bool alone,
                    description::RobotDescription& description) {
  const std::vector<std::string> joints = joint_names(description);
  int number = 0;
  for (const files::XmlElement& section : root.children("keyframe")) {
    for (const files::XmlElement& key : section.children("key")) {
      const std::string name = key.attribute("name").value_or(fmt::format("key{}", ++number));
      if (!alone) {
        const std::string word = files::one_line(fmt::format("key '{}'", name));
        description.unused.push_back(
            {word, fmt::format("{}: {} is not used: it is of several bodies of the world", key.where(), word)});
        continue;
      }
      const auto same = [&](const description::KeyframeDescription& other) { return other.name == name; };
      if (std::ranges::any_of(description.keyframes, same)) {
        key.fail(fmt::format("key '{}' appears twice; rename one", name));
      }
      description::KeyframeDescription frame{name, key.where(), {}, {}, {}};
      read_positions(key, joints, description, frame);
      read_targets(key, actuators.controls, frame);
      description.keyframes.push_back(std::move(frame));
      description.notes.push_back(files::one_line(
          fmt::format("{}: a robot of a scene starts there with keyframe = \"{}\"", key.where(), name)));
    }
  }
}

}  // namespace murosimf::formats::mjcf
