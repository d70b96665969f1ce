/// gait_properties.h - properties of controllers that walk, drive and balance.
#pragma once

#include <span>

#include "murosimf/locomotion/gait_state.h"
#include "murosimf/locomotion/motion_state.h"
#include "murosimf/locomotion/named_motions.h"
#include "murosimf/model/option.h"
#include "murosimf/model/property.h"
#include "murosimf/model/value.h"

namespace murosimf::properties {

// clang-format off

// ---- constant: of the base ----
inline constexpr Property<OptionValues> given_walk   {{"given_walk", "-", "-", "numbers of the walk that the robot's file gives, by their names", Scope::base}};
inline constexpr Property<locomotion::NamedMotions> given_motions {{"given_motions", "-", "-", "key-frame motions that the robot's file names, by what they are for", Scope::base}};
inline constexpr Property<OptionValues> given_balance {{"given_balance", "-", "-", "numbers of the walk with feedback that the robot's file gives, by their names", Scope::base}};
inline constexpr Property<locomotion::StepTablePtr> given_steps {{"given_steps", "-", "-", "how its steady walk looks to its own sensors", Scope::base}};
// ---- constant: of joints ----
inline constexpr Property<double> rest_position {{"rest_position", "rad | m", "joint", "where walks and motions hold it if they do not move it"}};

// ---- variable: one for the whole entity ----
inline constexpr Property<Vec3d>  walk_command       {{"walk_command", "m/s, m/s, rad/s", "robot, x forward", "desired walking velocity", Scope::base}};
inline constexpr Property<double> halted             {{"halted", "1", "-", "1: stands, whatever walk_command says, because a referee wants it so", Scope::base, true}};
inline constexpr Property<Vec3d>  gait_velocity      {{"gait_velocity", "m/s, m/s, rad/s", "robot, x forward", "walking velocity after the slew limits", Scope::base}};
inline constexpr Property<double> path_curvature     {{"path_curvature", "1/m", "-", "of the path that a car drives, positive to the left", Scope::base}};
inline constexpr Property<double> gait_phase         {{"gait_phase", "rad", "-", "0 to pi: left foot stands", Scope::base}};
inline constexpr Property<double> gait_amplitude     {{"gait_amplitude", "1", "-", "0 stands, 1 walks", Scope::base}};
inline constexpr Property<double> motion_time        {{"motion_time", "s", "-", "since the start of the key-frame motion", Scope::base}};
inline constexpr Property<Vec3d>  balance_up         {{"balance_up", "1", "sensor", "unit vector upward, as the controller that balances takes it", Scope::base}};
inline constexpr Property<Vec3d>  balance_upright    {{"balance_upright", "1", "sensor", "mean direction of gravity while the robot settled", Scope::base}};
inline constexpr Property<Vec3d>  balance_bias       {{"balance_bias", "rad/s", "sensor", "mean of the gyroscope while the robot settled", Scope::base}};
inline constexpr Property<double> balance_capture    {{"balance_capture", "rad", "-", "lean forward at which the robot would come to rest, smoothed", Scope::base}};

inline constexpr Property<locomotion::GaitState> gait_state {{"gait_state", "-", "-", "what a walk with feedback remembers: attitude, center of mass, offsets of feet", Scope::base}};
inline constexpr Property<locomotion::MotionRequests> motion_request {{"motion_request", "1", "-", "one number for each motion of the robot, by their names; a change to another than 0 asks for it", Scope::base}};
inline constexpr Property<locomotion::KickRequest> kick_request {{"kick_request", "1, rad, 1, m, m", "robot, x forward", "number, direction, side, ball: a change of the number to another than 0 asks for a kick", Scope::base}};
inline constexpr Property<locomotion::MotionState> motion_state {{"motion_state", "-", "-", "what the motion engine does, and since when", Scope::base}};
inline constexpr Property<double> motion_start       {{"motion_start", "rad | m", "joint", "targets from which the present motion began"}};
inline constexpr Property<double> motion_joints      {{"motion_joints", "1", "joint", "1: the motion engine moves it; 0: control software that asks for this does"}};
inline constexpr Property<Vec3d>  odometry           {{"odometry", "m, m, rad", "where the robot started", "how far the robot thinks that it has walked, and turned", Scope::base}};

// clang-format on

/// Every property of this header, constant ones first.
[[nodiscard]] std::span<const CatalogEntry> gait_list();

}  // namespace murosimf::properties
