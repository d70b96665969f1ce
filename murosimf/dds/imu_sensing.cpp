#include "murosimf/dds/imu_sensing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "murosimf/dds/signal_vector.h"
#include "murosimf/world/world.h"

namespace murosimf::dds {
namespace {

std::array<float, 3> row_of(const Vec3d& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

}  // namespace

ImuSensing::ImuSensing(const Setup& setup, control_software::RobotPort& port, const std::string& name)
    : period_(seconds(setup.period())),
      gravity_(std::max(norm(setup.world().gravity), 0.1)),
      gyroscope_(port.signal(name + ".gyroscope")),
      accelerometer_(port.signal(name + ".accelerometer")) {}

void ImuSensing::restart() {
  attitude_ = {};
  yaw_ = 0;
  started_ = false;
  imu_ = {};
}

void ImuSensing::follow() {
  const Vec3d gyroscope = vector_of(*gyroscope_), force = vector_of(*accelerometer_);
  // Before its first sample the sensor shows what it would at rest (sensors/inertial.h); later ones may be of a robot that sinks into the ground.
  if (!started_) {
    attitude_.start(force);
    started_ = true;
  }
  if (gyroscope_->samples == 0 || accelerometer_->samples == 0) return;
  imu_ = {{}, row_of(gyroscope), row_of(force)};
  attitude_.follow(period_, gyroscope, force, gravity_, {}, false);
  const double roll = attitude_.roll(), pitch = attitude_.pitch();
  constexpr double least_cosine = 0.05;  // straight up or down there is no yaw
  if (std::cos(pitch) > least_cosine) {
    const Vec3d rate = gyroscope - attitude_.bias;
    yaw_ += period_ * (rate.y * std::sin(roll) + rate.z * std::cos(roll)) / std::cos(pitch);
    yaw_ = std::remainder(yaw_, 2 * pi);
  }
  imu_.rpy = row_of({roll, pitch, yaw_});
}

}  // namespace murosimf::dds
