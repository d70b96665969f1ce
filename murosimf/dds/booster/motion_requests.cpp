#include "murosimf/dds/booster/motion_requests.h"

#include <algorithm>

#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/locomotion/kick_plan.h"
#include "murosimf/math/assert.h"

namespace murosimf::dds::booster {
namespace {

/// A change to another number than 0 is a request (locomotion/motion_state.h).
void change(double& number) {
  constexpr double most = 1e6;
  number = number >= most ? 1 : number + 1;
}

}  // namespace

MotionRequests::MotionRequests(const Setup& setup, control_software::RobotPort& port)
    : velocity_(port.command("motion.velocity")) {
  const locomotion::NamedMotions* motions = setup.model().find(properties::given_motions, 0);
  if (!motions || motions->empty()) return;
  play_ = port.command("motion.play");
  names_ = *port.labels("motion.play");
  if (locomotion::has_kick(*motions)) kick_ = port.command("motion.kick");
}

void MotionRequests::walk(const Vec3d& velocity) {
  velocity_->values[0] = velocity.x;
  velocity_->values[1] = velocity.y;
  velocity_->values[2] = velocity.z;
}

bool MotionRequests::play(std::string_view motion) {
  const auto found = std::ranges::find(names_, motion);
  if (found == names_.end()) return false;
  change(play_->values[found - names_.begin()]);
  return true;
}

/// A ball at (0, 0) is none: the motion decides where it should lie.
bool MotionRequests::kick(const KickTarget& target) {
  if (!kick_) return false;
  change(kick_->values[0]);
  kick_->values[1] = target.direction;
  kick_->values[2] = 0;  // either foot
  kick_->values[3] = target.x;
  kick_->values[4] = target.y;
  return true;
}

void MotionRequests::drop_kick() {
  if (kick_) kick_->values[0] = 0;
}

}  // namespace murosimf::dds::booster
