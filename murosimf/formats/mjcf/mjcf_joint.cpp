#include "murosimf/formats/mjcf/mjcf_joint.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
namespace murosimf::formats::mjcf {
namespace {

double at_least_zero(const MjcfAttributes& attributes, const char* name) {
  const double number = attributes.number(name, 0);
  if (number < 0) attributes.source(name).fail(fmt::format("{} of joint is negative; it must be at least 0", name));
  return number;
}

Vec3d read_axis(const MjcfAttributes& attributes, const std::string& name) {
  const Vec3d axis = attributes.vector("axis", {0, 0, 1});
  if (!(norm(axis) > 1e-9)) attributes.source("axis").fail(fmt::format("axis of joint '{}' has no direction", name));
  return axis;
}

/// [rad | m] An angle or a length.
double read_coordinate(const MjcfAttributes& attributes, const char* name, Kind kind, const MjcfContext& context) {
  const double unit = kind == Kind::revolute ? context.compiler.units_of(attributes.source(name)).angle_unit : 1.0;
  return unit * attributes.number(name, 0);
}

void read_spring(const MjcfAttributes& attributes, description::JointDescription& joint, const MjcfContext& context) {
  joint.reference = read_coordinate(attributes, "ref", joint.kind, context);
  joint.stiffness = at_least_zero(attributes, "stiffness");
  joint.spring_reference = read_coordinate(attributes, "springref", joint.kind, context);
}

/// What limits the torque of all actuators together.
void limit_effort(const MjcfAttributes& attributes, description::JointDescription& joint, const MjcfContext& context) {
  if (!is_limited(attributes, "actuatorfrclimited", "actuatorfrcrange", context.compiler)) return;
  const auto range = attributes.numbers("actuatorfrcrange", 2, 2);
  joint.effort_limit = std::max(std::abs(range[0]), std::abs(range[1]));
  if (range[0] != -range[1]) joint.effort_range = Vec3d{range[0], range[1], 0};
  if (!joint.servo) return;
  Servo& servo = *joint.servo;
  const bool limited = servo.stall_torque > 0;
  const double lowest = limited ? servo.lowest_share * servo.stall_torque : range[0];
  const double highest = limited ? servo.highest_share * servo.stall_torque : range[1];
  set_torque_range(servo, std::clamp(lowest, range[0], range[1]), std::clamp(highest, range[0], range[1]));
}

/// What holds the joint's targets.
void limit_target(const MjcfActuator& actuator, const files::XmlElement& element,
                  description::JointDescription& joint) {
  joint.target_range = actuator.target_range;
  if (!(actuator.inherited_range > 0)) return;
  if (!joint.range)
    element.fail(fmt::format("joint '{}' needs a range, because of inheritrange of its actuator", joint.name));
  const double middle = 0.5 * (joint.range->x + joint.range->y);
  const double half = 0.5 * actuator.inherited_range * (joint.range->y - joint.range->x);
  const auto [lowest, highest] =
      std::minmax({actuator.per_range * (middle - half), actuator.per_range * (middle + half)});
  joint.target_range = Vec3d{lowest, highest, 0};
}

}  // namespace

description::JointDescription read_joint(const MjcfChild& child, const MjcfContext& context) {
  const files::XmlElement& element = child.element;
  const MjcfAttributes attributes = context.defaults.resolve(element, child.child_class);
  const auto type = attributes.choice("type", {"hinge", "slide", "ball", "free"});
  description::JointDescription joint;
  joint.name = context.names.of(element);
  joint.where = element.where();
  if (type == "ball") element.fail(fmt::format("ball joint '{}' is not supported; use three hinges", joint.name));
  if (type == "free") {
    element.fail(fmt::format("free joint '{}' inside the robot; only its base may be free", joint.name));
  }
  joint.kind = type == "slide" ? Kind::prismatic : Kind::revolute;
  joint.anchor = child.frame.position + child.frame.orientation * attributes.vector("pos", {});
  joint.axis = child.frame.orientation * read_axis(attributes, joint.name);
  joint.armature = at_least_zero(attributes, "armature");
  joint.damping = at_least_zero(attributes, "damping");
  joint.friction = at_least_zero(attributes, "frictionloss");
  if (is_limited(attributes, "limited", "range", context.compiler)) {
    const auto range = attributes.numbers("range", 2, 2);
    const double unit =
        joint.kind == Kind::revolute ? context.compiler.units_of(attributes.source("range")).angle_unit : 1.0;
    joint.range = Vec3d{unit * range[0], unit * range[1], 0};
  }
  read_spring(attributes, joint, context);
  if (const auto found = context.actuators.find(joint.name); found != context.actuators.end()) {
    joint.servo = found->second.servo;
    joint.damping_ratio = found->second.damping_ratio;
    limit_target(found->second, element, joint);
  }
  limit_effort(attributes, joint, context);
  return joint;
}

}  // namespace murosimf::formats::mjcf
