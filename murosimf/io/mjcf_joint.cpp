#include "murosimf/io/mjcf_joint.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/model/properties.h"

namespace murosimf::io {
namespace {

double at_least_zero(const MjcfAttributes& attributes, const char* name) {
  const double number = attributes.number(name, 0);
  if (number < 0) attributes.source(name).fail(fmt::format("{} of joint is negative; it must be at least 0", name));
  return number;
}

Vec3d read_axis(const MjcfAttributes& attributes, const std::string& name, const MjcfContext& context) {
  if (!attributes.has("axis")) {
    if (!context.lenient) {
      attributes.element().fail(fmt::format("joint '{}' has no axis; add axis=\"x y z\", here or in its class", name));
    }
    context.warnings.push_back(
        one_line(fmt::format("{}: joint '{}' has no axis; z is taken", attributes.element().where(), name)));
  }
  const Vec3d axis = attributes.vector("axis", {0, 0, 1});
  if (!(norm(axis) > 1e-9)) attributes.source("axis").fail(fmt::format("axis of joint '{}' has no direction", name));
  return axis;
}

void add_range(Chain& chain, const MjcfJoint& joint, const MjcfCompiler& compiler) {
  if (!is_limited(joint.attributes, "limited", "range", compiler)) return;
  const auto range = joint.attributes.numbers("range", 2, 2);
  const double unit = joint.kind == Kind::revolute ? compiler.angle_unit : 1.0;
  chain.with(properties::joint_range, {unit * range[0], unit * range[1], 0});
}

/// The servo of the joint's actuators; nothing if there are none.
void add_actuated_servo(Chain& chain, const MjcfJoint& joint, const MjcfContext& context) {
  const auto found = context.servos.find(joint.name);
  if (found == context.servos.end()) return;
  Servo servo = found->second;
  if (is_limited(joint.attributes, "actuatorfrclimited", "actuatorfrcrange", context.compiler)) {
    const auto range = joint.attributes.numbers("actuatorfrcrange", 2, 2);
    const double limit = std::max(std::abs(range[0]), std::abs(range[1]));
    servo.stall_torque = servo.stall_torque > 0 ? std::min(servo.stall_torque, limit) : limit;
  }
  chain.with(properties::servo, servo);
}

}  // namespace

MjcfJoint read_joint(const XmlElement& element, const std::string& child_class, const MjcfContext& context) {
  const MjcfAttributes attributes = context.defaults.resolve(element, child_class);
  const auto type = attributes.choice("type", {"hinge", "slide", "ball", "free"});
  const std::string& name = context.names.of(element);
  if (type == "ball") element.fail(fmt::format("ball joint '{}' is not supported; use three hinges", name));
  if (type == "free") element.fail(fmt::format("free joint '{}' inside the robot; only its base may be free", name));
  const Kind kind = type == "slide" ? Kind::prismatic : Kind::revolute;
  return {name, kind, attributes.vector("pos", {}), read_axis(attributes, name, context), attributes};
}

void add_joint_constants(Chain& chain, const MjcfJoint& joint, const MjcfContext& context) {
  const double armature = at_least_zero(joint.attributes, "armature");
  const double damping = at_least_zero(joint.attributes, "damping");
  const double friction = at_least_zero(joint.attributes, "frictionloss");
  add_range(chain, joint, context.compiler);
  if (const auto found = context.table.servos.find(joint.name); found != context.table.servos.end()) {
    // it has rotor, friction and speed-torque line of its own: the file's describe the same part
    chain.with(properties::servo, found->second.servo);
    return;
  }
  if (armature > 0) chain.with(properties::joint_armature, armature);
  if (damping > 0) chain.with(properties::joint_damping, damping);
  if (friction > 0) chain.with(properties::joint_friction, friction);
  add_actuated_servo(chain, joint, context);
}

}  // namespace murosimf::io
