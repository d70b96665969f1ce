/// mjcf_joint.h - joints of an MJCF file: kind, axis, range, spring, and the constants of friction and drive.
///
/// A ball joint becomes three hinges at its anchor, `<name>.x`, `.y`, `.z` about the body's axes, the first outermost: R = Rx Ry Rz. Each
/// has the ball's stiffness, damping, friction and rotor, and its largest angle both ways.
/// Limits: with .y at 90 degrees the other two have one axis; angles of three hinges are not the angle of a ball, so springs and ends
/// are alike for small angles only.
#pragma once

#include <vector>

#include "murosimf/robot_formats/mjcf/mjcf_children.h"
#include "murosimf/robot_formats/mjcf/mjcf_context.h"

namespace murosimf::robot_formats::mjcf {

/// Appends the hinge, slide or three hinges of an element `joint`. Throws SetupError for free joints.
void read_joints(const MjcfChild& child, const MjcfContext& context,
                 std::vector<robot_formats::JointDescription>& joints);

/// Limits the forces of all actuators of a joint or tendon together: its servo gives no more (actuatorfrcrange).
void limit_effort(const MjcfAttributes& attributes, const MjcfCompiler& compiler,
                  robot_formats::JointDescription& joint);

/// The three angles [rad] of the hinges of a ball joint for an orientation; the third is 0 where they are not unique.
[[nodiscard]] Vec3d ball_angles(const Mat3d& turn);

/// Sets stiffness and damping of joints with a `springdamper`, a time constant T [s] and a damping ratio z, for the inertia I [kg m^2 | kg]
/// that they move in the pose of the file while the other joints are free (joint_inertia.h):
///
///     stiffness = I / (T z)^2       damping = 2 I / T
///
/// Source: MuJoCo documentation, XML reference, "joint", attribute springdamper; the inertia as in MuJoCo 4.0.
void resolve_spring_dampers(const std::vector<MjcfSpringDamper>& springs, robot_formats::RobotDescription& description);

}  // namespace murosimf::robot_formats::mjcf
