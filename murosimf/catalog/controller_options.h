/// controller_options.h - options of the library's controllers that a scene may set in [robots.options].
///
/// Other inputs of a controller (its start, the goal) follow from its robot's place in the scene.
#pragma once

#include "murosimf/control_software/tcp/tcp_server.h"
#include "murosimf/control_software/trajectory_player.h"
#include "murosimf/dds/booster/booster_options.h"
#include "murosimf/dds/ros2/ros_options.h"
#include "murosimf/dds/unitree/unitree_options.h"
#include "murosimf/locomotion/ankle_strategy.h"
#include "murosimf/locomotion/drive.h"
#include "murosimf/model/option.h"
#include "murosimf/serial/serial_software.h"
#include "murosimf/soccer/ball_chaser.h"
#include "murosimf/soccer/localize.h"
#include "murosimf/soccer/obstacle_course.h"

namespace murosimf::catalog {

[[nodiscard]] const OptionTable<locomotion::AnkleStrategyOptions>& balance_options();
[[nodiscard]] const OptionTable<control_software::TrajectoryOptions>& trajectory_options();
[[nodiscard]] const OptionTable<control_software::TcpOptions>& tcp_options();
[[nodiscard]] const OptionTable<serial::SerialOptions>& serial_options();
[[nodiscard]] const OptionTable<dds::booster::BoosterOptions>& booster_options();
[[nodiscard]] const OptionTable<dds::unitree::UnitreeOptions>& unitree_options();
[[nodiscard]] const OptionTable<dds::ros2::RosOptions>& ros2_options();
[[nodiscard]] const OptionTable<locomotion::DriveOptions>& drive_options();
[[nodiscard]] const OptionTable<soccer::BallChaserOptions>& ball_chaser_options();
[[nodiscard]] const OptionTable<soccer::LocalizeOptions>& localize_options();
[[nodiscard]] const OptionTable<soccer::ObstacleCourseOptions>& obstacle_course_options();

}  // namespace murosimf::catalog
