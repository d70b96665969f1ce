#include "murosimf/robot_formats/proto/proto_joint.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/robot_formats/proto/proto_schema.h"

namespace murosimf::robot_formats::proto {
namespace {

constexpr double usual_effort = 10;  // [N m | N]
constexpr double usual_rate = 10;    // [rad/s | m/s]

bool is_motor(const Node& node) { return node.type == "RotationalMotor" || node.type == "LinearMotor"; }

NodePtr motor_of(const Node& joint, const char* devices) {
  for (const NodePtr& device : joint.children(devices)) {
    // Of several motors the first one drives the joint, as in Webots.
    if (is_motor(*device)) return device;
  }
  return nullptr;
}

/// Lowest, highest, 0; nothing if both are 0, which stands for no limits.
std::optional<Vec3d> read_range(const Node& node, const char* least, const char* most) {
  const double lower = node.number(least, 0), upper = node.number(most, 0);
  if (lower == 0 && upper == 0) return std::nullopt;
  if (!(lower < upper)) {
    node.fail(fmt::format("{} {} of {} is not below {} {}; correct them", least, lower, node.type, most, upper),
              node.find(least) ? node.find(least) : node.find(most));
  }
  return Vec3d{lower, upper, 0};
}

Vec3d read_axis(const Node* parameters, const Vec3d& usual) {
  const Vec3d axis = parameters ? parameters->vector("axis", usual) : usual;
  // Without parameters the axis is the usual one, which has a direction.
  if (!(norm(axis) > 1e-9)) parameters->fail("axis has no direction; write one", parameters->find("axis"));
  return (1 / norm(axis)) * axis;
}

/// Data of one axis of a joint.
struct Axis {
  const Node& joint;
  const Node* parameters;  ///< null: all as usual
  const Node* motor;       ///< null: no motor
  Kind kind;
  Vec3d anchor, axis;  ///< body axes
};

void read_motor(const Node& motor, robot_formats::JointDescription& joint, ProtoLog& log) {
  log.check_fields(motor);
  const bool turns = motor.type == "RotationalMotor";
  if (turns != (joint.kind == Kind::revolute)) motor.fail(fmt::format("{} at a joint of the other kind", motor.type));
  joint.effort_limit = motor.at_least_zero(turns ? "maxTorque" : "maxForce", usual_effort);
  joint.rate_limit = motor.at_least_zero("maxVelocity", usual_rate);
  // Stops are hard; the motor's bounds only limit targets, but are the best range where there are no stops.
  const auto soft = read_range(motor, "minPosition", "maxPosition");
  if (!joint.range) joint.range = soft;
  joint.target_range = soft;
  if (motor.find("controlPID")) {
    log.unused(motor.where, "Motor.controlPID", "controlPID of motors is not used; servos are guessed or in the table");
  }
  if (motor.number("multiplier", 1) != 1) log.refuse(motor, "multiplier of coupled motors is not supported");
}

robot_formats::JointDescription read_axis_joint(const Axis& axis, const std::string& other_name, ProtoLog& log) {
  robot_formats::JointDescription joint;
  MUROSIMF_ASSERT(std::abs(norm(axis.axis) - 1) < 1e-6);
  joint.name = axis.motor ? axis.motor->text("name", "") : "";
  // Controllers address joints by their motors.
  if (joint.name.empty()) joint.name = other_name;
  joint.where = axis.parameters ? axis.parameters->where : axis.joint.where;
  joint.kind = axis.kind;
  joint.anchor = axis.anchor;
  joint.axis = axis.axis;
  if (const Node* numbers = axis.parameters) {
    log.check_fields(*numbers);
    joint.reference = numbers->number("position", 0);
    joint.range = read_range(*numbers, "minStop", "maxStop");
    joint.damping = numbers->at_least_zero("dampingConstant", 0);
    joint.friction = numbers->at_least_zero("staticFriction", 0);
    joint.stiffness = numbers->at_least_zero("springConstant", 0);
    if (numbers->number("suspensionSpringConstant", 0) != 0)
      log.refuse(*numbers, "suspension of joints is not supported");
  }
  if (axis.motor) read_motor(*axis.motor, joint, log);
  return joint;
}

/// The parameters of an axis. Throws SetupError for nodes of another type.
NodePtr parameters_of(const Node& joint, const char* field) {
  const NodePtr parameters = joint.child(field);
  if (!parameters || parameters->type == "HingeJointParameters" || parameters->type == "JointParameters")
    return parameters;
  parameters->fail(fmt::format("{} as {} of {} is not supported; write HingeJointParameters or JointParameters",
                               parameters->type, field, joint.type));
}

/// In body axes; `vector` is given in the frame of the joint.
Vec3d seen_from(const Transformd& body, const Vec3d& vector) { return transposed_times(body.orientation, vector); }

}  // namespace

std::vector<robot_formats::JointDescription> read_joints(const Node& joint, const JointPlace& place, ProtoLog& log) {
  if (joint.type == "BallJoint")
    joint.fail("BallJoint is not supported; write three HingeJoints with light Solids between");
  log.check_fields(joint);
  const bool slides = joint.type == "SliderJoint", two = joint.type.starts_with("Hinge2Joint");
  const NodePtr first = parameters_of(joint, "jointParameters"), motor = motor_of(joint, "device");
  const Vec3d axis = read_axis(first.get(), slides ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0});
  const Vec3d anchor = first ? first->vector("anchor", {}) : Vec3d{};
  const Vec3d at = slides ? Vec3d{} : seen_from(place.body, anchor - place.body.position);
  const std::string name = joint.def.empty() ? place.solid + "_joint" : joint.def;
  std::vector<robot_formats::JointDescription> joints;
  MUROSIMF_ASSERT(!slides || !two);
  joints.push_back(read_axis_joint({joint, first.get(), motor.get(), slides ? Kind::prismatic : Kind::revolute, at,
                                    seen_from(place.body, axis)},
                                   name, log));
  if (!two) return joints;
  const NodePtr second = parameters_of(joint, "jointParameters2"), motor2 = motor_of(joint, "device2");
  // The second axis is written for position 0 of the first, and moves with it.
  const Vec3d axis2 = rotation(axis, joints[0].reference) * read_axis(second.get(), {0, 0, 1});
  joints.push_back(
      read_axis_joint({joint, second.get(), motor2.get(), Kind::revolute, at, seen_from(place.body, axis2)}, name + "2",
                      log));
  MUROSIMF_ASSERT(joints.size() == 2);
  return joints;
}

}  // namespace murosimf::robot_formats::proto
