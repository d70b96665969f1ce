#include "murosimf/dds/booster/robot_modes.h"

namespace murosimf::dds::booster {

Status RobotModes::change(std::int64_t mode) {
  if (mode < static_cast<std::int64_t>(Mode::damping) || mode > static_cast<std::int64_t>(Mode::soccer))
    return Status::bad_request;
  const Mode wanted{static_cast<std::int32_t>(mode)};
  // a robot on the ground stands up for get_up() alone
  if ((rising_ || lies_) && wanted != Mode::damping && wanted != Mode::custom) return Status::conflict;
  rising_ = lies_ = false;
  velocity_ = {};
  mode_ = wanted;
  return Status::success;
}

Status RobotModes::move(const Vec3d& velocity) {
  if (!walks()) return Status::conflict;
  velocity_ = velocity;
  return Status::success;
}

Status RobotModes::get_up(std::int64_t mode, const Posture& posture) {
  const Mode wanted{static_cast<std::int32_t>(mode)};
  if (wanted != Mode::walking && wanted != Mode::soccer) return Status::bad_request;
  if (!posture.fallen && !lies_) return Status::conflict;
  mode_ = wanted;
  rising_ = true;
  lies_ = false;
  velocity_ = {};
  return Status::success;
}

Status RobotModes::lie_down() {
  if (!uses_motions() || rising_ || lies_) return Status::conflict;
  lies_ = true;
  velocity_ = {};
  return Status::success;
}

void RobotModes::follow(const Posture& posture) {
  if (rising_) {
    rising_ = posture.fallen || posture.gets_up;
    return;
  }
  if (!uses_motions() || !posture.fallen || lies_) return;
  mode_ = Mode::damping;
  velocity_ = {};
}

std::int32_t RobotModes::body_control() const {
  constexpr std::int32_t damping = 1, prepare = 2, humanlike_gait = 3, soccer_gait = 5, custom = 6, get_up = 7;
  if (rising_) return get_up;
  switch (mode_) {
    case Mode::damping: return damping;
    case Mode::prepare: return prepare;
    case Mode::walking: return humanlike_gait;
    case Mode::custom: return custom;
    case Mode::soccer: return soccer_gait;
  }
  return 0;
}

FallDown RobotModes::fall_down(const Posture& posture) const {
  if (rising_) return FallDown::getting_up;
  if (posture.fallen) return FallDown::fallen;
  return posture.falling ? FallDown::falling : FallDown::ready;
}

}  // namespace murosimf::dds::booster
