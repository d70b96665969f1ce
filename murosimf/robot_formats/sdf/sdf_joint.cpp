#include "murosimf/robot_formats/sdf/sdf_joint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/sdf/sdf_value.h"
#include "murosimf/robot_formats/urdf/urdf_value.h"

namespace murosimf::robot_formats::sdf {
namespace {

constexpr double far = 1e6;  // [rad | m] the other end of a range with one end

std::string type_of(const files::XmlElement& joint) { return joint.attribute("type").value_or(""); }

void read_range(const files::XmlElement& limit, robot_formats::JointDescription& joint) {
  const double infinity = HUGE_VAL, lower = number(limit, "lower", -infinity), upper = number(limit, "upper", infinity);
  if (lower > upper) {
    limit.fail(fmt::format("limits of joint '{}' are upside down: lower {} is above upper {}; swap them", joint.name,
                           lower, upper));
  }
  if (std::isinf(lower) && std::isinf(upper)) return;
  MUROSIMF_ASSERT(lower <= upper);
  joint.range = Vec3d{std::max(lower, -far), std::min(upper, far), 0};
}

/// A limit; -1 and infinity stand for none, which is 0 here.
double limit_of(const files::XmlElement& limit, const char* tag) {
  const double value = number(limit, tag, HUGE_VAL);
  return value < 0 || std::isinf(value) ? 0 : value;
}

void read_axis(const files::XmlElement& axis, bool endless, robot_formats::JointDescription& joint,
               urdf::UrdfLog& log) {
  if (const auto limit = urdf::only_child(axis, "limit")) {
    if (!endless) read_range(*limit, joint);
    joint.effort_limit = limit_of(*limit, "effort");
    joint.rate_limit = limit_of(*limit, "velocity");
    if (number(*limit, "effort", 1) == 0) {
      // Old exporters write effort 0 for "not known": a joint without any effort would make the robot fall.
      log.warn(*limit, fmt::format("joint '{}' has an effort limit of 0; it is read as none", joint.name));
    }
  }
  if (const auto dynamics = urdf::only_child(axis, "dynamics")) {
    joint.damping = at_least_zero(*dynamics, "damping", 0);
    joint.friction = at_least_zero(*dynamics, "friction", 0);
    joint.stiffness = at_least_zero(*dynamics, "spring_stiffness", 0);
    joint.spring_reference = number(*dynamics, "spring_reference", 0);
    if (!std::isfinite(joint.spring_reference)) dynamics->fail("spring_reference is not finite");
  }
}

/// The axis in body axes. A joint that is reversed keeps its positions if its axis points the other way.
Vec3d axis_in(const SdfJointSpot& spot, const Vec3d& axis) {
  MUROSIMF_ASSERT(is_zero(axis) || std::abs(norm(axis) - 1) < 1e-6);
  const Vec3d seen = transposed_times(spot.body.orientation, axis);
  return spot.reversed ? -1.0 * seen : seen;
}

/// Whether its limits hold the joint at one position.
bool is_held(const robot_formats::JointDescription& joint) { return joint.range && joint.range->x == joint.range->y; }

void hold(const robot_formats::JointDescription& joint, SdfJointSpot& spot, urdf::UrdfLog& log,
          const files::XmlElement& element) {
  MUROSIMF_ASSERT(is_held(joint));
  const double at = joint.range->x;
  log.warn(element, fmt::format("joint '{}' cannot move: lower and upper limit are both {}; it is read as fixed",
                                joint.name, at));
  if (joint.kind == Kind::prismatic) {
    spot.body = spot.body * Transformd{at * joint.axis, {}};
  } else {
    const Mat3d turn = rotation(joint.axis, at);
    // Turned about the anchor, which stays in its place.
    spot.body = spot.body * Transformd{joint.anchor - turn * joint.anchor, turn};
  }
}

robot_formats::JointDescription hinge(const SdfPart& part, const SdfJointPose& pose, const SdfJointSpot& spot,
                                      const Vec3d& axis) {
  robot_formats::JointDescription joint;
  joint.name = part.name;
  joint.where = part.element.where();
  joint.anchor = seen_from(spot.body, pose.place).position;
  joint.axis = axis;
  if (is_zero(axis)) {
    part.element.fail(
        fmt::format("axis of joint '{}' has no direction; write one, or make the joint fixed", part.name));
  }
  return joint;
}

std::vector<robot_formats::JointDescription> read_ball(const SdfPart& part, const SdfJointPose& pose,
                                                       const SdfJointSpot& spot, urdf::UrdfLog& log) {
  log.note(part.element,
           fmt::format("ball joint '{0}' is read as three hinges, {0}.x, .y and .z; with .y at 90 degrees the other "
                       "two are one",
                       part.name));
  std::vector<robot_formats::JointDescription> joints;
  // In this order as MuJoCo's ball joints are read, so that a converted robot keeps its joints.
  constexpr std::array axes{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
  constexpr std::array endings{".x", ".y", ".z"};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    joints.push_back(hinge(part, pose, spot, axes[i]));
    joints.back().name += endings[i];
  }
  return joints;
}

/// Reads a joint with two axes: the first is fixed to the parent, the second to the child.
std::vector<robot_formats::JointDescription> read_two_axes(const SdfPart& part, const SdfJointPose& pose,
                                                           const SdfJointSpot& spot, urdf::UrdfLog& log) {
  if (pose.axes.size() != 2)
    part.element.fail(fmt::format("{} joint '{}' needs two axes", type_of(part.element), part.name));
  std::vector<robot_formats::JointDescription> joints;
  for (std::size_t i = 0; i < 2; ++i) {
    joints.push_back(hinge(part, pose, spot, axis_in(spot, pose.axes[i])));
    joints.back().name += i == 0 ? ".1" : ".2";
    const auto axis = urdf::only_child(part.element, i == 0 ? "axis" : "axis2");
    if (axis) read_axis(*axis, false, joints.back(), log);
  }
  if (spot.reversed)
    std::swap(joints[0], joints[1]);  // the body is the joint's parent: its first axis is the inner one
  MUROSIMF_ASSERT(joints.size() == 2);
  return joints;
}

/// Names and places of all joints of the bodies.
std::map<std::string, std::string> moving_joints(const robot_formats::RobotDescription& description) {
  std::map<std::string, std::string> all;
  for (const robot_formats::BodyDescription& body : description.bodies) {
    for (const robot_formats::JointDescription& joint : body.joints) all.emplace(joint.name, joint.where);
  }
  return all;
}

/// The name of a follower or leader with several axes: its axis is called "axis" or "axis2".
std::string hinge_name(const std::map<std::string, std::string>& joints, const std::string& name, bool second) {
  if (joints.contains(name)) return name;
  return name + (second ? ".2" : ".1");
}

/// The scope of a name: names of leaders are relative to the model that contains the follower.
std::string scope_of(const std::string& name) {
  const std::size_t end = name.rfind("::");
  return end == std::string::npos ? "" : name.substr(0, end + 2);
}

void read_mimic(const SdfPart& part, const files::XmlElement& axis, const std::map<std::string, std::string>& joints,
                robot_formats::RobotDescription& description, urdf::UrdfLog& log) {
  const auto mimic = urdf::only_child(axis, "mimic");
  const std::string follower = hinge_name(joints, part.name, axis.tag() == "axis2");
  if (!mimic || !joints.contains(follower)) return;
  const std::string named = scope_of(part.name) + urdf::needed_text(*mimic, "joint");
  const std::string leader = hinge_name(joints, named, mimic->attribute("axis").value_or("axis") == "axis2");
  if (!joints.contains(leader)) {
    return log.warn(*mimic,
                    fmt::format("joint '{}' moves by itself: it mimics '{}', which does not move", follower, named));
  }
  const double ratio = number(*mimic, "multiplier", 1), offset = number(*mimic, "offset", 0);
  // position = multiplier (leader - reference) + offset, as one offset here.
  const double start = offset - ratio * number(*mimic, "reference", 0);
  if (!std::isfinite(ratio) || !std::isfinite(start)) mimic->fail("numbers of mimic must be finite");
  description.mimics.push_back({follower, leader, mimic->where(), ratio, start});
}

/// Refuses circles: follows the leaders of every joint; more steps than there are joints is a circle.
void check_circles(const std::vector<robot_formats::MimicDescription>& mimics) {
  std::map<std::string, std::string> leaders;
  for (const robot_formats::MimicDescription& mimic : mimics) leaders.emplace(mimic.joint, mimic.leader);
  for (const robot_formats::MimicDescription& mimic : mimics) {
    std::string joint = mimic.joint;
    for (std::size_t steps = 0; leaders.contains(joint); ++steps) {
      joint = leaders.at(joint);
      if (steps < mimics.size()) continue;
      throw SetupError(files::one_line(
          fmt::format("{}: joint '{}' ends up mimicking itself; let one joint of the circle move freely", mimic.where,
                      mimic.joint)));
    }
  }
}

}  // namespace

bool is_known_type(const std::string& type) {
  constexpr std::array known{"fixed", "revolute", "continuous", "prismatic", "ball", "universal", "revolute2"};
  return std::ranges::find(known, type) != known.end();
}

std::vector<robot_formats::JointDescription> read_joints(const SdfPart& part, const SdfJointPose& pose,
                                                         SdfJointSpot& spot, urdf::UrdfLog& log) {
  const std::string type = type_of(part.element);
  if (type == "fixed") return {};
  if (type == "ball") return read_ball(part, pose, spot, log);
  if (type == "universal" || type == "revolute2") return read_two_axes(part, pose, spot, log);
  robot_formats::JointDescription joint =
      hinge(part, pose, spot, axis_in(spot, pose.axes.empty() ? Vec3d{0, 0, 1} : pose.axes[0]));
  if (type == "prismatic") joint.kind = Kind::prismatic;
  if (const auto axis = urdf::only_child(part.element, "axis")) read_axis(*axis, type == "continuous", joint, log);
  // Held at one position: the body gets no joint, and its place is that position.
  if (!is_held(joint)) return {joint};
  /// limits is fixed there. A limit that is infinite, or beyond 1e15, is none. Source: SDFormat specification, "joint".
  /// Whether joints of a type are supported; others are refused. fixed, revolute, continuous, prismatic, ball, universal, revolute2.
  hold(joint, spot, log, part.element);
  return {};
}

void read_mimics(const std::vector<SdfPart>& joints, robot_formats::RobotDescription& description, urdf::UrdfLog& log) {
  const auto moving = moving_joints(description);
  for (const SdfPart& joint : joints) {
    for (const char* tag : {"axis", "axis2"}) {
      if (const auto axis = urdf::only_child(joint.element, tag)) read_mimic(joint, *axis, moving, description, log);
    }
  }
  check_circles(description.mimics);
}

}  // namespace murosimf::robot_formats::sdf
