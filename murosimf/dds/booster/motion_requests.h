/// motion_requests.h - what a Booster's high-level requests ask the motion engine for: walk, motions, kicks.
#pragma once

#include <string_view>
#include <vector>

#include "murosimf/control_software/robot_port.h"
#include "murosimf/dds/booster/messages.h"
#include "murosimf/math/vec3.h"

namespace murosimf::dds::booster {

class MotionRequests {
 public:
  /// Throws SetupError: the robot cannot walk.
  MotionRequests(const Setup& setup, control_software::RobotPort& port);

  /// [m/s, m/s, rad/s]
  void walk(const Vec3d& velocity);
  /// False: the robot's file has no such motion.
  [[nodiscard]] bool play(std::string_view motion);
  /// The ball of `target`, to which it walks; without one ahead, where the robot stands. False: its file has no kick.
  [[nodiscard]] bool kick(const KickTarget& target = {});
  void drop_kick();
  [[nodiscard]] bool can_kick() const { return kick_ != nullptr; }

 private:
  murosimf_command *velocity_, *play_ = nullptr, *kick_ = nullptr;  // null: it has none
  std::vector<std::string> names_;                                  // of motions
};

}  // namespace murosimf::dds::booster
