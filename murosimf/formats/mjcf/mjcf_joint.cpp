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

/// [rad | m] of one unit of the file.
double unit_of(const description::JointDescription& joint, const MjcfContext& context) {
  return joint.kind == Kind::revolute ? context.compiler.angle_unit : 1.0;
}

void read_spring(const MjcfAttributes& attributes, description::JointDescription& joint, double unit) {
  joint.reference = unit * attributes.number("ref", 0);
  joint.stiffness = at_least_zero(attributes, "stiffness");
  joint.spring_reference = unit * attributes.number("springref", 0);
}

/// What limits the torque of all actuators together.
void limit_effort(const MjcfAttributes& attributes, description::JointDescription& joint, const MjcfContext& context) {
  if (!is_limited(attributes, "actuatorfrclimited", "actuatorfrcrange", context.compiler)) return;
  const auto range = attributes.numbers("actuatorfrcrange", 2, 2);
  joint.effort_limit = std::max(std::abs(range[0]), std::abs(range[1]));
  if (!joint.servo) return;
  double& stall = joint.servo->stall_torque;
  stall = stall > 0 ? std::min(stall, joint.effort_limit) : joint.effort_limit;
}

}  // namespace

description::JointDescription read_joint(const files::XmlElement& element, const std::string& child_class,
                                         const MjcfContext& context) {
  const MjcfAttributes attributes = context.defaults.resolve(element, child_class);
  const auto type = attributes.choice("type", {"hinge", "slide", "ball", "free"});
  description::JointDescription joint;
  joint.name = context.names.of(element);
  joint.where = element.where();
  if (type == "ball") element.fail(fmt::format("ball joint '{}' is not supported; use three hinges", joint.name));
  if (type == "free") {
    element.fail(fmt::format("free joint '{}' inside the robot; only its base may be free", joint.name));
  }
  joint.kind = type == "slide" ? Kind::prismatic : Kind::revolute;
  joint.anchor = attributes.vector("pos", {});
  joint.axis = read_axis(attributes, joint.name);
  joint.armature = at_least_zero(attributes, "armature");
  joint.damping = at_least_zero(attributes, "damping");
  joint.friction = at_least_zero(attributes, "frictionloss");
  const double unit = unit_of(joint, context);
  if (is_limited(attributes, "limited", "range", context.compiler)) {
    const auto range = attributes.numbers("range", 2, 2);
    joint.range = Vec3d{unit * range[0], unit * range[1], 0};
  }
  read_spring(attributes, joint, unit);
  if (const auto found = context.actuators.find(joint.name); found != context.actuators.end()) {
    joint.servo = found->second.servo;
    joint.damping_ratio = found->second.damping_ratio;
  }
  limit_effort(attributes, joint, context);
  return joint;
}

}  // namespace murosimf::formats::mjcf
