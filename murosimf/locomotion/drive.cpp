#include "murosimf/locomotion/drive.h"

#include <algorithm>
#include <cmath>

#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/locomotion/rest_positions.h"
#include "murosimf/math/assert.h"

namespace murosimf::locomotion {
namespace {

constexpr double standstill = 1e-3;  // [m/s] commands below do not determine a direction to turn in

double approach(double value, double goal, double step) { return value + std::clamp(goal - value, -step, step); }

}  // namespace

Drive::Drive(Setup& setup, const Vec3d& command, const DriveOptions& options)
    : vehicle_(find_vehicle(setup.model())),
      options_(options),
      command_(setup.input(properties::walk_command, command)[0]),
      halted_(setup.input(properties::halted, 0.0)[0]),
      velocity_(setup.write(properties::gait_velocity)[0]),
      curvature_(setup.write(properties::path_curvature)[0]),
      rest_(rest_positions(setup.model())),
      target_(setup.write(properties::joint_target)),
      rate_target_(setup.write(properties::joint_velocity_target)) {}

void Drive::initialize() {
  MUROSIMF_ASSERT(target_.size() == rate_target_.size());
  velocity_ = {};
  curvature_ = 0;
  std::ranges::copy(rest_, target_.begin());
  std::fill(rate_target_.begin(), rate_target_.end(), 0.0);
}

void Drive::step(const Instant& instant) noexcept {
  advance(seconds(instant.period));
  write_targets();
}

void Drive::advance(double dt) noexcept {
  MUROSIMF_ASSERT(dt > 0 && options_.acceleration >= 0 && options_.steering >= 0);
  const double speed = approach(velocity_.x, halted_ != 0 ? 0.0 : command_.x, dt * options_.acceleration);
  if (!(std::abs(command_.x) < standstill)) {
    const double wanted = std::clamp(command_.z / command_.x, vehicle_.least_curvature, vehicle_.greatest_curvature);
    curvature_ = approach(curvature_, wanted, dt * options_.steering);
  }
  velocity_ = {speed, 0, speed * curvature_};
}

void Drive::write_targets() noexcept {
  for (const Wheel& wheel : vehicle_.wheels) {
    MUROSIMF_ASSERT(static_cast<std::size_t>(wheel.joint) < target_.size());
    const double forward = 1 - curvature_ * wheel.y;
    const double left = wheel.steering >= 0 ? curvature_ * wheel.x : 0;
    if (wheel.steering >= 0) target_[wheel.steering] = wheel.steering_sign * std::atan2(left, forward);
    if (!wheel.driven) continue;
    // The radius of the wheel's own path, relative to that of the middle; its sign turns where the center of the path is inside.
    const double way = std::copysign(std::hypot(forward, left), forward) - curvature_ * wheel.outside;
    rate_target_[wheel.joint] = wheel.sign * velocity_.x * way / wheel.radius;
  }
}

}  // namespace murosimf::locomotion
