/// controller_options.h - which options of the library's controllers a scene may set in [robots.options].
///
/// What else a controller needs (its start, the goal) comes from its robot's place in the scene.
#pragma once

#include "murosimf/behavior/ball_chaser.h"
#include "murosimf/behavior/localize.h"
#include "murosimf/behavior/obstacle_course.h"
#include "murosimf/connect/serial/serial_software.h"
#include "murosimf/connect/tcp_server.h"
#include "murosimf/connect/trajectory_player.h"
#include "murosimf/locomotion/ankle_strategy.h"
#include "murosimf/locomotion/drive.h"
#include "murosimf/model/option.h"

namespace murosimf::catalog {

[[nodiscard]] const OptionTable<locomotion::AnkleStrategyOptions>& balance_options();
[[nodiscard]] const OptionTable<connect::TrajectoryOptions>& trajectory_options();
[[nodiscard]] const OptionTable<connect::TcpOptions>& tcp_options();
[[nodiscard]] const OptionTable<connect::serial::SerialOptions>& serial_options();
[[nodiscard]] const OptionTable<locomotion::DriveOptions>& drive_options();
[[nodiscard]] const OptionTable<behavior::BallChaserOptions>& ball_chaser_options();
[[nodiscard]] const OptionTable<behavior::LocalizeOptions>& localize_options();
[[nodiscard]] const OptionTable<behavior::ObstacleCourseOptions>& obstacle_course_options();

}  // namespace murosimf::catalog
