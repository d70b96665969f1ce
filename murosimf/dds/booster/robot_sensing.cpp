#include "murosimf/dds/booster/robot_sensing.h"

#include <cmath>

#include "murosimf/dds/signal_vector.h"
#include "murosimf/locomotion/motion_report.h"
#include "murosimf/world/world.h"

namespace murosimf::dds::booster {
namespace {

const double cos_falling = std::cos(35 * pi / 180);  // as of the motion engine

float single(double value) { return static_cast<float>(value); }

Vec3d turned(const Vec3d& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y, 0};
}

}  // namespace

RobotSensing::RobotSensing(const Setup& setup, control_software::RobotPort& port, std::vector<std::size_t> places)
    : joints_(seconds(setup.period()), port, std::move(places)),
      imu_(setup, port, "imu"),
      mode_(port.signal("motion.mode")),
      odometry_(port.signal("motion.odometry")) {}

void RobotSensing::restart() {
  imu_.restart();
  joints_.restart();
  origin_ = shown_ = {};
}

void RobotSensing::follow() {
  joints_.follow();
  imu_.follow();
}

Posture RobotSensing::posture() const {
  using locomotion::Activity;
  const auto activity = static_cast<Activity>(static_cast<int>(mode_->values[0]));
  const double up = imu_.up().z;
  const bool falls = activity == Activity::fall || activity == Activity::protect;
  return {.fallen = up < locomotion::cos_fallen,
          .falling = falls || up < cos_falling,
          .gets_up = activity == Activity::lie || activity == Activity::get_up};
}

/// The way since the origin, begun at what was shown there.
Odometer RobotSensing::odometer() const {
  const Vec3d now = vector_of(*odometry_);
  const Vec3d way = turned({now.x - origin_.x, now.y - origin_.y, 0}, shown_.z - origin_.z);
  const double heading = std::remainder(shown_.z + now.z - origin_.z, 2 * pi);
  return {single(shown_.x + way.x), single(shown_.y + way.y), single(heading)};
}

void RobotSensing::set_odometer(const PlanarPose& shown) {
  origin_ = vector_of(*odometry_);
  shown_ = shown;
}

}  // namespace murosimf::dds::booster
