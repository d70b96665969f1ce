/// servo_inference.h - servos of joints for which a robot's file has no gains, guessed from their torques and the robot's weight.
///
/// All have the law ideal_pd with the file's largest torque F and rate. Of a robot that has not two soles: gain F / 0.1 rad (a slider
/// F / 0.02 m), damping 0.05 s of it. A robot on two soles falls over its ankles with the stiffness m g z_c (m its mass, z_c the height
/// of its center of mass in the pose of the file), and stands only if its joints are stiffer than that:
///
///     k = min(max(4 F / 0.1 rad, 4 m g z_c in the legs), 40 m g z_c)     damping 0.025 s k
///     F at most 10 m g z_c, which no joint of a robot needs: some files have 50,000 N m for "unlimited"
///     a leg's joint without a torque: F = 0.4 m g z_c, k = 4 m g z_c, rotor 0.005 m z_c^2
///
/// No joint outside the legs has more than k = I / (2 ms)^2, with I what it moves in the pose of the file while nothing holds the others
/// (robot_formats/joint_inertia.h): a quarter of what a step of 2 ms by semi-implicit Euler can bear, k dt^2 < 4 I.
///
/// Source: an inverted pendulum of mass m with its center at z_c topples with m g z_c per radian; the factors are the project's, those
///         with which the humanoids of other people's files stood and walked (docs/robots.md, "Servos that are guessed").
#pragma once

#include "murosimf/robot/robot_config.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// To be called when soles are known: those of `table`, or frames that are soles (robot_soles.h). Joints that follow others, or that
/// have gains or a servo in the table, stay as they are, and so do those with a spring and no torque.
void guess_servos(robot_formats::RobotDescription& description, const RobotConfig& table);

}  // namespace murosimf::robot
