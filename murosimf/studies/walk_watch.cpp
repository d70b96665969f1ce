#include "murosimf/studies/walk_watch.h"

#include <algorithm>

#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::studies {
namespace {

constexpr double fallen = 0.5;                   // [1] cosine of the lean
constexpr double start_up = 2, start_share = 4;  // [s], [1] of the duration

double heading_of(Entity& robot) {
  const Mat3d R = robot.base().get(properties::orientation);
  return std::atan2(R.x.y, R.x.x);
}

double wrapped(double angle) { return std::remainder(angle, 2 * pi); }

}  // namespace

WalkWatch::WalkWatch(Entity& robot, const Vec3d& command, double duration)
    : robot_(robot), command_(command), duration_(duration), from_(std::min(start_up, duration / start_share)) {
  MUROSIMF_ASSERT(duration > 0);
}

void WalkWatch::look(double now) {
  const Vec3d place = robot_.base().get(properties::position);
  const double cosine = robot_.base().get(properties::orientation).z.z, heading = heading_of(robot_);
  // Numbers that broke down count as a fall.
  if (robot_.frozen() || !std::isfinite(place.x + place.y + cosine) || cosine < fallen)
    fell_at_ = std::min(fell_at_, now);
  if (now > from_ + 1e-9) {
    // Turned by the heading in the middle of the interval, along which the robot went on average.
    const double turned = wrapped(heading - heading_), middle = heading_ + 0.5 * turned;
    way_ += rotation_z(-middle) * (place - place_);
    turned_ += turned;
  }
  place_ = place;
  heading_ = heading;
}

/// The time before `from_` is left out: the robot is still speeding up.
WalkOutcome WalkWatch::outcome() const {
  if (fell_at_ <= duration_) return {.fell = true, .cost = 2 - fell_at_ / duration_};
  const double time = duration_ - from_;
  const double along = std::hypot(way_.x / time - command_.x, way_.y / time - command_.y);
  const double s = std::max(std::hypot(command_.x, command_.y), 0.1), u = std::max(std::abs(command_.z), 0.5);
  return {.fell = false, .cost = std::min(1.0, std::hypot(along / s, (turned_ / time - command_.z) / u))};
}

}  // namespace murosimf::studies
