#include "murosimf/dds/booster/robot_sensing.h"

#include <algorithm>
#include <cmath>

#include "murosimf/locomotion/motion_report.h"
#include "murosimf/math/assert.h"
#include "murosimf/world/world.h"

namespace murosimf::dds::booster {
namespace {

const double cos_falling = std::cos(35 * pi / 180);  // as of the motion engine

float single(double value) { return static_cast<float>(value); }
/// Levels without torques have none: NaN.
float single_or_zero(double value) { return std::isfinite(value) ? single(value) : 0.0F; }

Vec3d vector_of(const murosimf_signal& signal) {
  MUROSIMF_ASSERT(signal.count >= 3);
  return {signal.values[0], signal.values[1], signal.values[2]};
}

std::array<float, 3> row_of(const Vec3d& v) { return {single(v.x), single(v.y), single(v.z)}; }

Vec3d turned(const Vec3d& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y, 0};
}

}  // namespace

RobotSensing::RobotSensing(const Setup& setup, control_software::RobotPort& port, std::vector<std::size_t> places)
    : period_(seconds(setup.period())),
      gravity_(std::max(norm(setup.world().gravity), 0.1)),
      places_(std::move(places)),
      position_(port.signal("joint.position")),
      velocity_(port.signal("joint.velocity")),
      torque_(port.signal("joint.torque")),
      gyroscope_(port.signal("imu.gyroscope")),
      accelerometer_(port.signal("imu.accelerometer")),
      mode_(port.signal("motion.mode")),
      odometry_(port.signal("motion.odometry")),
      motors_(places_.size()),
      rates_(places_.size()) {}

void RobotSensing::restart() {
  attitude_ = {};
  yaw_ = 0;
  started_ = false;
  std::ranges::fill(rates_, 0.0);
  origin_ = shown_ = {};
}

void RobotSensing::follow() {
  constexpr std::uint8_t cool = 25;  // [C] of servos whose heat is not simulated
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const std::size_t place = places_[i];
    const double rate = velocity_->values[place];
    motors_[i] = {.q = single(position_->values[place]),
                  .dq = single(rate),
                  .ddq = single((rate - rates_[i]) / period_),
                  .tau = single_or_zero(torque_->values[place]),
                  .temperature = cool};
    rates_[i] = rate;
  }
  follow_imu();
}

/// Rates of roll, pitch and yaw by the body's: psi' = (w_y sin(roll) + w_z cos(roll)) / cos(pitch).
void RobotSensing::follow_imu() {
  const Vec3d gyroscope = vector_of(*gyroscope_), force = vector_of(*accelerometer_);
  if (gyroscope_->samples == 0 || accelerometer_->samples == 0) return;
  if (!started_) attitude_.start(force);
  started_ = true;
  attitude_.follow(period_, gyroscope, force, gravity_, {}, false);
  const double roll = attitude_.roll(), pitch = attitude_.pitch();
  constexpr double least_cosine = 0.05;  // straight up or down there is no yaw
  if (std::cos(pitch) > least_cosine) {
    const Vec3d rate = gyroscope - attitude_.bias;
    yaw_ += period_ * (rate.y * std::sin(roll) + rate.z * std::cos(roll)) / std::cos(pitch);
    yaw_ = std::remainder(yaw_, 2 * pi);
  }
  imu_ = {row_of({roll, pitch, yaw_}), row_of(gyroscope), row_of(force)};
}

Posture RobotSensing::posture() const {
  using locomotion::Activity;
  const auto activity = static_cast<Activity>(static_cast<int>(mode_->values[0]));
  const double up = attitude_.up.z;
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
