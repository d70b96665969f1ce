/// servo_inference.h - guesses servos of joints without gains in the robot's file, from their torques and the robot's weight.
///
/// All have the law ideal_pd with the file's largest torque F and rate. On a robot without two soles: gain F / 0.1 rad (a slider
/// F / 0.02 m), damping 0.05 s of it. A robot on two soles falls over its ankles with the stiffness m g z_c (m its mass, z_c the height
/// of its center of mass in the pose of the file), and stands only if its joints are stiffer than that:
///
///     k = min(max(4 F / 0.1 rad, 4 m g z_c in the legs), 40 m g z_c)     damping 0.025 s k
///     F at most 10 m g z_c, which no joint of a robot needs: some files have 50,000 N m for "unlimited"
///     a leg's joint without a torque: F = 0.4 m g z_c, k = 4 m g z_c, rotor 0.005 m z_c^2
///
/// No joint outside the legs has more than k = I / (2 ms)^2, with I the inertia at the joint in the pose of the file while the others are free
/// (robot_formats/joint_inertia.h): a quarter of the stability limit of a step of 2 ms by semi-implicit Euler, k dt^2 < 4 I.
///
/// Source: an inverted pendulum of mass m with its center at z_c topples with m g z_c per radian; the factors are the project's, those
///         with which the humanoids of other people's files stood and walked (docs/robots.md, "Servos that are guessed").
#pragma once

#include "murosimf/robot/robot_config.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// To be called when soles are known: those of `table`, or frames that are soles (robot_soles.h). Joints that follow others, or that
/// have gains or a servo in the table, are not changed, nor are those with a spring and no torque.
void guess_servos(robot_formats::RobotDescription& description, const RobotConfig& table);

}  // namespace murosimf::robot
