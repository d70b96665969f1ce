#include "murosimf/robot_formats/mjcf/mjcf_joint_tendons.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/robot_formats/mjcf/mjcf_joint.h"
#include "murosimf/robot_formats/mjcf/mjcf_spatial_tendons.h"
#include "murosimf/robot_formats/tendon_path.h"

namespace murosimf::robot_formats::mjcf {
namespace {

using robot_formats::JointDescription;
using Parts = std::vector<std::pair<std::string, double>>;

const JointDescription* find_joint(const robot_formats::RobotDescription& description, const std::string& name) {
  for (const robot_formats::BodyDescription& body : description.bodies) {
    const auto joint = std::ranges::find(body.joints, name, &JointDescription::name);
    if (joint != body.joints.end()) return &*joint;
  }
  return nullptr;
}

/// The tendon's length where each joint stands at one of its numbers.
double length_at(double JointDescription::*number, const MjcfTendon& tendon,
                 const robot_formats::RobotDescription& description) {
  if (!tendon.path.empty()) return robot_formats::path_length(description, tendon.path, number);
  double length = 0;
  for (const auto& [joint, coefficient] : tendon.parts)
    length += coefficient * (find_joint(description, joint)->*number);
  return length;
}

void read_spring(const MjcfAttributes& attributes, const MjcfTendon& tendon,
                 robot_formats::RobotDescription& description, JointDescription& joint) {
  joint.stiffness = tendon_number(attributes, "stiffness");
  const auto lengths = attributes.numbers("springlength", 1, 2);
  if (lengths.size() == 2 && !(lengths[0] <= lengths[1])) {
    attributes.source("springlength").fail("springlength of a tendon ends below its beginning; swap both");
  }
  const bool as_built = lengths.empty() || lengths[0] < 0;
  joint.spring_reference = as_built ? length_at(&JointDescription::spring_reference, tendon, description) : lengths[0];
  if (!as_built && lengths.size() == 2) joint.spring_slack = lengths[1] - lengths[0];
}

JointDescription read_slider(const MjcfTendon& tendon, const MjcfAttributes& attributes, const MjcfCompiler& compiler,
                             robot_formats::RobotDescription& description) {
  JointDescription joint;
  joint.name = tendon.joint;
  joint.where = tendon.element.where();
  joint.kind = Kind::prismatic;
  joint.axis = {0, 0, 1};
  joint.reference = length_at(&JointDescription::reference, tendon, description);
  read_spring(attributes, tendon, description, joint);
  joint.damping = tendon_number(attributes, "damping");
  joint.friction = tendon_number(attributes, "frictionloss");
  joint.armature = tendon_number(attributes, "armature");
  if (is_limited(attributes, "limited", "range", compiler)) {
    const auto range = attributes.numbers("range", 2, 2);
    joint.range = Vec3d{range[0], range[1], 0};
  }
  return joint;
}

bool does_something(const JointDescription& joint) {
  return joint.servo || joint.range || joint.stiffness > 0 || joint.damping > 0 || joint.friction > 0 ||
         joint.armature > 0;
}

}  // namespace

Parts joints_of_tendon(const files::XmlElement& tendon, const MjcfNames& names) {
  Parts parts;
  for (const files::XmlElement& element : tendon.children("joint")) {
    MjcfAttributes attributes(element);
    attributes.overlay(element);
    const std::string joint = attributes.text("joint");
    if (!names.is_joint(joint)) return {};
    const double coefficient = attributes.number("coef", 1);
    const auto same = std::ranges::find(parts, joint, &Parts::value_type::first);
    if (same == parts.end()) {
      parts.emplace_back(joint, coefficient);
    } else {
      same->second += coefficient;
    }
  }
  std::erase_if(parts, [](const auto& part) { return part.second == 0; });
  return parts;
}

void add_joint_tendons(std::map<std::string, MjcfTendon>& tendons, const MjcfDefaults& defaults,
                       const MjcfCompiler& compiler, const MjcfActuators& actuators,
                       robot_formats::RobotDescription& description) {
  std::erase_if(tendons, [&](const auto& tendon) {
    return std::ranges::any_of(tendon.second.parts,
                               [&](const auto& part) { return !find_joint(description, part.first); });
  });
  for (const auto& [name, tendon] : tendons) {
    if (!tendon.has_slider()) continue;
    check_path(tendon.element, tendon.path, description);
    const MjcfAttributes attributes = defaults.resolve(tendon.element);
    JointDescription joint = read_slider(tendon, attributes, compiler, description);
    if (const auto found = actuators.by_joint.find(tendon.joint); found != actuators.by_joint.end()) {
      joint.servo = found->second.servo;
      joint.target_range = found->second.target_range;
      limit_effort(attributes, compiler, joint);
    }
    if (tendon.tied || does_something(joint)) description.tendons.push_back({joint, tendon.parts, tendon.path});
  }
}

}  // namespace murosimf::robot_formats::mjcf
