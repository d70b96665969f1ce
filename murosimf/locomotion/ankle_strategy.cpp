#include "murosimf/locomotion/ankle_strategy.h"

#include <algorithm>
#include <cmath>

#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/locomotion/rest_positions.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/sensors/reading.h"

namespace murosimf::locomotion {
namespace {

using sensors::vector_of;

Vec3d unit_of(const Vec3d& v) noexcept { return norm(v) > 0 ? (1 / norm(v)) * v : v; }
double pitch_of(const Vec3d& up) noexcept { return std::atan2(-up.x, up.z); }

/// Rate of the linear inverted pendulum with the height of this stance (as for the sway of gait.h). `gravity` [m/s^2]
double fall_rate(const WalkParameters& stance, const Vec3d& gravity) {
  constexpr double height_above_sole = 1.072, least_gravity = 0.1;
  if (norm(gravity) < least_gravity) return 0;
  return std::sqrt(norm(gravity) / (height_above_sole * stance.hip_height));
}

std::span<const double> inertial(Setup& setup, const char* output) {
  return with_context("a robot that balances needs a sensor 'imu' with gyroscope and accelerometer",
                      [&] { return sensors::read_output(setup, output); });
}

}  // namespace

AnkleStrategy::AnkleStrategy(Setup& setup, const AnkleStrategyOptions& options)
    : options_(options),
      legs_(find_legs(setup.model())),
      stance_(seeded_parameters(setup.model())),
      fall_rate_(fall_rate(stance_, setup.world().gravity)),
      gyroscope_(inertial(setup, "imu.gyroscope")),
      accelerometer_(inertial(setup, "imu.accelerometer")),
      up_(setup.write(properties::balance_up)[0]),
      upright_(setup.write(properties::balance_upright)[0]),
      bias_(setup.write(properties::balance_bias)[0]),
      capture_(setup.write(properties::balance_capture)[0]),
      rest_(rest_positions(setup.model())),
      target_(setup.write(properties::joint_target)) {}

void AnkleStrategy::initialize() {
  up_ = upright_ = {0, 0, 1};
  bias_ = {};
  capture_ = 0;
  std::ranges::copy(rest_, target_.begin());
  write_targets();
}

void AnkleStrategy::step(const Instant& instant) noexcept {
  const double period = seconds(instant.period), now = seconds(instant.now);
  MUROSIMF_ASSERT(period > 0 && now >= 0);
  if (now < options_.settle_time) {
    settle(period / (now + period));
  } else {
    follow_up(period);
    balance(period);
  }
}

/// Running means of the bias and of up; this sample has the weight `share` [1].
void AnkleStrategy::settle(double share) noexcept {
  MUROSIMF_ASSERT(share > 0 && share <= 1);
  bias_ += share * (sensors::vector_of(gyroscope_) - bias_);
  upright_ += share * (unit_of(sensors::vector_of(accelerometer_)) - upright_);
  up_ = unit_of(upright_);
}

void AnkleStrategy::follow_up(double period) noexcept {
  MUROSIMF_ASSERT(period > 0);
  const Vec3d pull = unit_of(sensors::vector_of(accelerometer_)) - up_;
  up_ += period * (cross(up_, sensors::vector_of(gyroscope_) - bias_) + (1 / options_.trust_time) * pull);
  // Explicit steps let the length of up drift: a unit vector is restored in every cycle.
  up_ = unit_of(up_);
}

void AnkleStrategy::balance(double period) noexcept {
  if (fall_rate_ == 0) return;  // the targets of initialize() remain
  const double lean = pitch_of(up_) - pitch_of(upright_), rate = gyroscope_[1] - bias_.y;
  capture_ += period / options_.smooth_time * (lean + rate / fall_rate_ - capture_);
  write_targets();
}

/// Targets from the stance of the walk engine, with the soles turned about the ankles.
void AnkleStrategy::write_targets() noexcept {
  MUROSIMF_ASSERT(options_.limit >= 0);
  const double sole = std::clamp(options_.gain * capture_, -options_.limit, options_.limit);
  const Mat3d level_to_pelvis = rotation_y(-stance_.pitch);
  GaitPose pose = home_pose(legs_);
  for (std::size_t side = 0; side < 2; ++side) {
    const Leg& leg = legs_[side];
    const double outward = side == 0 ? 1 : -1;
    const Vec3d ankle{-stance_.setback, outward * stance_.half_width - leg.hip.y,
                      leg.ankle_height - stance_.hip_height};
    const FootTarget target{.ankle = level_to_pelvis * ankle, .sole = level_to_pelvis * rotation_y(sole)};
    bend(leg, target, std::span(pose.q[side]).first(leg.joints.size()));
  }
  write_pose(legs_, pose, target_);
}

}  // namespace murosimf::locomotion
