#include "murosimf/robot_formats/mjcf/mjcf_joint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/joint_inertia.h"

namespace murosimf::robot_formats::mjcf {
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

/// [rad | m] Reads an angle or a length.
double read_coordinate(const MjcfAttributes& attributes, const char* name, Kind kind, const MjcfContext& context) {
  const double unit = kind == Kind::revolute ? context.compiler.units_of(attributes.source(name)).angle_unit : 1.0;
  return unit * attributes.number(name, 0);
}

void read_spring(const MjcfAttributes& attributes, robot_formats::JointDescription& joint, const MjcfContext& context) {
  joint.reference = read_coordinate(attributes, "ref", joint.kind, context);
  joint.stiffness = at_least_zero(attributes, "stiffness");
  joint.spring_reference = read_coordinate(attributes, "springref", joint.kind, context);
}

}  // namespace

void limit_effort(const MjcfAttributes& attributes, const MjcfCompiler& compiler,
                  robot_formats::JointDescription& joint) {
  if (!is_limited(attributes, "actuatorfrclimited", "actuatorfrcrange", compiler)) return;
  const auto range = attributes.numbers("actuatorfrcrange", 2, 2);
  joint.effort_limit = std::max(std::abs(range[0]), std::abs(range[1]));
  if (range[0] != -range[1]) joint.effort_range = Vec3d{range[0], range[1], 0};
  if (!joint.servo) return;
  Servo& servo = *joint.servo;
  const bool limited = servo.stall_torque > 0;
  const double lowest = limited ? servo.lowest_share * servo.stall_torque : range[0];
  const double highest = limited ? servo.highest_share * servo.stall_torque : range[1];
  // The servo cannot give more than either limit allows.
  set_torque_range(servo, std::clamp(lowest, range[0], range[1]), std::clamp(highest, range[0], range[1]));
}

namespace {

/// Sets the range of the joint's targets.
void limit_target(const MjcfActuator& actuator, const files::XmlElement& element,
                  robot_formats::JointDescription& joint) {
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

/// Reads the numbers that a hinge, a slide and a ball have in common.
void read_constants(const MjcfChild& child, const MjcfAttributes& attributes, const MjcfContext& context,
                    robot_formats::JointDescription& joint) {
  joint.name = context.names.of(child.element);
  joint.where = child.element.where();
  joint.anchor = child.frame.position + child.frame.orientation * attributes.vector("pos", {});
  joint.armature = at_least_zero(attributes, "armature");
  joint.damping = at_least_zero(attributes, "damping");
  joint.friction = at_least_zero(attributes, "frictionloss");
}

/// Stores time constant and ratio for later: the stiffness depends on the inertia of the whole robot.
void store_spring(const MjcfAttributes& attributes, const std::string& joint, const MjcfContext& context) {
  const auto pair = attributes.numbers("springdamper", 2, 2);
  if (!pair.empty() && pair[0] > 0 && pair[1] > 0) context.springs.push_back({joint, pair[0], pair[1]});
}

robot_formats::JointDescription read_single(const MjcfChild& child, const MjcfAttributes& attributes, Kind kind,
                                            const MjcfContext& context) {
  robot_formats::JointDescription joint;
  joint.kind = kind;
  read_constants(child, attributes, context, joint);
  joint.axis = child.frame.orientation * read_axis(attributes, joint.name);
  if (is_limited(attributes, "limited", "range", context.compiler)) {
    const auto range = attributes.numbers("range", 2, 2);
    const double unit = kind == Kind::revolute ? context.compiler.units_of(attributes.source("range")).angle_unit : 1.0;
    joint.range = Vec3d{unit * range[0], unit * range[1], 0};
  }
  read_spring(attributes, joint, context);
  store_spring(attributes, joint.name, context);
  // Limits last: they depend on the servo and the joint's range.
  if (const auto found = context.actuators.find(joint.name); found != context.actuators.end()) {
    joint.servo = found->second.servo;
    joint.damping_ratio = found->second.damping_ratio;
    limit_target(found->second, child.element, joint);
  }
  limit_effort(attributes, context.compiler, joint);
  return joint;
}

void read_ball(const MjcfChild& child, const MjcfAttributes& attributes, const MjcfContext& context,
               std::vector<robot_formats::JointDescription>& joints) {
  robot_formats::JointDescription joint;
  read_constants(child, attributes, context, joint);
  joint.stiffness = at_least_zero(attributes, "stiffness");
  if (is_limited(attributes, "limited", "range", context.compiler)) {
    const double largest =
        // MJCF bounds the angle of a ball, from 0 to the second number.
        context.compiler.units_of(attributes.source("range")).angle_unit * attributes.numbers("range", 2, 2)[1];
    joint.range = Vec3d{-largest, largest, 0};
  }
  context.notes.push_back(files::one_line(fmt::format(
      "{}: ball joint '{}' is read as three hinges, {}.x, .y and .z; with .y at 90 degrees the other two are one",
      joint.where, joint.name, joint.name)));
  // Outermost first: R = Rx Ry Rz.
  constexpr std::array axes{std::pair{".x", Vec3d{1, 0, 0}}, std::pair{".y", Vec3d{0, 1, 0}},
                            std::pair{".z", Vec3d{0, 0, 1}}};
  for (const auto& [ending, axis] : axes) {
    joints.push_back(joint);
    joints.back().name += ending;
    joints.back().axis = axis;
    store_spring(attributes, joints.back().name, context);
  }
}

}  // namespace

void read_joints(const MjcfChild& child, const MjcfContext& context,
                 std::vector<robot_formats::JointDescription>& joints) {
  const files::XmlElement& element = child.element;
  const MjcfAttributes attributes = context.defaults.resolve(element, child.child_class);
  const auto type = attributes.choice("type", {"hinge", "slide", "ball", "free"});
  if (type == "free") {
    element.fail(fmt::format("free joint '{}' inside the robot; only its base may be free", context.names.of(element)));
  }
  if (type == "ball") return read_ball(child, attributes, context, joints);
  joints.push_back(read_single(child, attributes, type == "slide" ? Kind::prismatic : Kind::revolute, context));
}

Vec3d ball_angles(const Mat3d& turn) {
  // Columns of Rx(a) Ry(b) Rz(c): the third is (sin b, -sin a cos b, cos a cos b), the first row (cos b cos c, -cos b sin c, sin b).
  const double sine = std::clamp(turn.z.x, -1.0, 1.0), cosine = std::hypot(turn.x.x, turn.y.x);
  // At 90 degrees only the sum of the outer angles is determined: the third is chosen as 0.
  if (cosine < 1e-9) return {std::atan2(turn.y.z, turn.y.y), std::copysign(0.5 * pi, sine), 0};
  return {std::atan2(-turn.z.y, turn.z.z), std::atan2(sine, cosine), std::atan2(-turn.y.x, turn.x.x)};
}

void resolve_spring_dampers(const std::vector<MjcfSpringDamper>& springs,
                            robot_formats::RobotDescription& description) {
  if (springs.empty()) return;
  const std::vector<double> inertias = robot_formats::free_inertias(description);
  std::size_t number = 0;
  for (robot_formats::BodyDescription& body : description.bodies) {
    for (robot_formats::JointDescription& joint : body.joints) {
      const std::size_t mine = number++;
      const auto spring = std::ranges::find(springs, joint.name, &MjcfSpringDamper::joint);
      if (spring == springs.end()) continue;
      if (inertias.empty()) {
        throw SetupError(joint.where + ": springdamper needs a robot of which everything that moves has a mass");
      }
      MUROSIMF_ASSERT(mine < inertias.size() && spring->time > 0 && spring->ratio > 0);
      joint.stiffness = inertias[mine] / (spring->time * spring->time * spring->ratio * spring->ratio);
      joint.damping = 2 * inertias[mine] / spring->time;
    }
  }
}

}  // namespace murosimf::robot_formats::mjcf
