#include "murosimf/robot_formats/urdf/urdf_joint.h"

#include <map>
#include <optional>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/urdf/urdf_value.h"

namespace murosimf::robot_formats::urdf {
namespace {

Vec3d read_axis(const UrdfJoint& joint) {
  const auto element = only_child(joint.element, "axis");
  const Vec3d axis = element ? vector_or(*element, "xyz", {1, 0, 0}) : Vec3d{1, 0, 0};
  const double length = norm(axis);
  if (!(length > 1e-9)) {
    element->fail(fmt::format("axis of joint '{}' has no direction; write one, or make the joint fixed", joint.name));
  }
  return (1.0 / length) * axis;
}

void read_range(const UrdfJoint& joint, const files::XmlElement& limit, robot_formats::JointDescription& description,
                UrdfLog& log) {
  // Both ends default to 0 in the format, which would fix the joint: no program reads it so.
  if (!limit.attribute("lower") && !limit.attribute("upper")) {
    log.warn(limit, fmt::format("joint '{}' has no lower and upper limit; here it has no range, write it", joint.name));
    return;
  }
  const double lower = number_or(limit, "lower", 0), upper = number_or(limit, "upper", 0);
  if (lower > upper) {
    limit.fail(fmt::format("limits of joint '{}' are upside down: lower {} is above upper {}; swap them", joint.name,
                           lower, upper));
  }
  MUROSIMF_ASSERT(lower <= upper);
  description.range = {lower, upper, 0};
}

void read_limits(const UrdfJoint& joint, robot_formats::JointDescription& description, UrdfLog& log) {
  const auto limit = only_child(joint.element, "limit");
  const bool bounded = joint.type != "continuous";
  if (!limit) {
    if (!bounded) return;
    joint.element.fail(fmt::format("{} joint '{}' has no limit; add <limit lower upper effort velocity>{}", joint.type,
                                   joint.name, joint.type == "revolute" ? ", or make it continuous" : ""));
  }
  if (bounded) {
    read_range(joint, *limit, description, log);
  } else if (limit->attribute("lower") || limit->attribute("upper")) {
    log.note(*limit, "lower and upper limits of continuous joints are not used");
  }
  description.effort_limit = at_least_zero(*limit, "effort");
  description.rate_limit = at_least_zero(*limit, "velocity");
}

void warn_of_leader(const UrdfTree& tree, const UrdfJoint& follower, const std::string& leader,
                    const files::XmlElement& element, UrdfLog& log) {
  std::vector<std::string_view> names;
  for (const UrdfJoint& joint : tree.joints) names.push_back(joint.name);
  log.warn(element, fmt::format("joint '{}' moves by itself: it mimics an {}", follower.name,
                                unknown_name("joint", leader, names)));
}

/// Reads a coupling; nothing if there is no such leader: other programs let the joint move by itself as well.
std::optional<robot_formats::MimicDescription> read_mimic(const UrdfTree& tree, const UrdfJoint& follower,
                                                          const files::XmlElement& element, UrdfLog& log) {
  robot_formats::MimicDescription mimic{follower.name, needed_text(element, "joint"), element.where(),
                                        number_or(element, "multiplier", 1), number_or(element, "offset", 0)};
  const int leader = tree.find_joint(mimic.leader);
  if (leader < 0) {
    warn_of_leader(tree, follower, mimic.leader, element, log);
    return std::nullopt;
  }
  if (tree.joints[leader].type == "floating") {
    log.refuse(element,
               fmt::format("joint '{}' mimics '{}', which is floating; name one that moves along or about an axis",
                           follower.name, mimic.leader));
    return std::nullopt;
  }
  return mimic;
}

/// Refuses circles: follows the leaders of every joint; more steps than there are joints is a circle.
void check_circles(const UrdfTree& tree, const std::vector<robot_formats::MimicDescription>& mimics) {
  std::map<std::string, std::string> leaders;
  for (const robot_formats::MimicDescription& mimic : mimics) leaders.emplace(mimic.joint, mimic.leader);
  for (const robot_formats::MimicDescription& mimic : mimics) {
    std::string joint = mimic.joint;
    for (std::size_t steps = 0; leaders.contains(joint); ++steps) {
      joint = leaders.at(joint);
      if (steps < mimics.size()) continue;
      const files::XmlElement element = needed_child(tree.joints[tree.find_joint(mimic.joint)].element, "mimic");
      element.fail(
          fmt::format("joint '{}' ends up mimicking itself; let one joint of the circle move freely", mimic.joint));
    }
  }
}

}  // namespace

Transformd read_place(const UrdfJoint& joint) {
  const Transformd origin = read_origin(joint.element);
  if (joint.held_at == 0) return origin;
  const Vec3d axis = read_axis(joint);
  // The type is `fixed` for a joint that is held: the element has the original one.
  if (joint.element.attribute("type") == "prismatic") return origin * Transformd{joint.held_at * axis, {}};
  return origin * Transformd{{}, rotation(axis, joint.held_at)};
}

robot_formats::JointDescription read_joint(const UrdfJoint& joint, UrdfLog& log) {
  robot_formats::JointDescription description;
  description.name = joint.name;
  description.where = joint.element.where();
  description.kind = joint.type == "prismatic" ? Kind::prismatic : Kind::revolute;
  description.axis = read_axis(joint);
  read_limits(joint, description, log);
  if (const auto dynamics = only_child(joint.element, "dynamics")) {
    description.damping = at_least_zero(*dynamics, "damping");
    description.friction = at_least_zero(*dynamics, "friction");
  }
  return description;
}

std::vector<robot_formats::MimicDescription> read_mimics(const UrdfTree& tree, UrdfLog& log) {
  std::vector<robot_formats::MimicDescription> mimics;
  for (const UrdfJoint& joint : tree.joints) {
    const auto element = only_child(joint.element, "mimic");
    if (!element) continue;
    if (joint.type == "fixed" || joint.type == "floating") {
      log.note(*element, fmt::format("mimic of {} joints is not used", joint.type));
    } else {
      if (auto mimic = read_mimic(tree, joint, *element, log)) mimics.push_back(*std::move(mimic));
    }
  }
  check_circles(tree, mimics);
  return mimics;
}

}  // namespace murosimf::robot_formats::urdf
