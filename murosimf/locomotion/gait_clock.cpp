#include "murosimf/locomotion/gait_clock.h"

#include <algorithm>
#include <cmath>

#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/math/assert.h"

namespace murosimf::locomotion {
namespace {

constexpr double ramp = 0.6;  // [periods] from standing to full sway and lift

double approach(double value, double goal, double step) { return value + std::clamp(goal - value, -step, step); }

Vec3d clipped(const Vec3d& v, const Vec3d& limit) {
  return {std::clamp(v.x, -limit.x, limit.x), std::clamp(v.y, -limit.y, limit.y), std::clamp(v.z, -limit.z, limit.z)};
}

}  // namespace

GaitClock::GaitClock(Setup& setup, const Vec3d& command)
    : command_(setup.input(properties::walk_command, command)[0]),
      halted_(setup.input(properties::halted, 0.0)[0]),
      velocity_(setup.write(properties::gait_velocity)[0]),
      phase_(setup.write(properties::gait_phase)[0]),
      amplitude_(setup.write(properties::gait_amplitude)[0]) {}

void GaitClock::initialize() noexcept {
  velocity_ = {};
  phase_ = amplitude_ = 0;
}

void GaitClock::advance(double dt, const GaitLimits& limits, double rate, bool steps) noexcept {
  MUROSIMF_ASSERT(dt > 0 && limits.period > 0);
  MUROSIMF_ASSERT(limits.fastest.x >= 0 && limits.fastest.y >= 0 && limits.fastest.z >= 0);
  const Vec3d plain = wanted(limits);
  const Vec3d aim = is_zero(plain) ? plain : clipped(plain + limits.trim, limits.fastest);
  const Vec3d& slew = limits.slew;
  velocity_ = {approach(velocity_.x, aim.x, dt * slew.x), approach(velocity_.y, aim.y, dt * slew.y),
               approach(velocity_.z, aim.z, dt * slew.z)};
  const bool walking = steps || !is_idle(limits);
  amplitude_ = approach(amplitude_, walking ? 1 : 0, dt / (ramp * limits.period));
  phase_ = amplitude_ > 0 ? std::fmod(phase_ + rate * 2 * pi * dt / limits.period, 2 * pi) : 0.0;
}

Vec3d GaitClock::wanted(const GaitLimits& limits) const noexcept {
  return halted_ != 0 ? Vec3d{} : clipped(limits.velocity.value_or(command_), limits.fastest);
}

bool GaitClock::is_idle(const GaitLimits& limits) const noexcept {
  return is_zero(wanted(limits)) && is_zero(velocity_);
}

void GaitClock::start_at(double phase, double amplitude) noexcept {
  MUROSIMF_ASSERT(phase >= 0 && phase < 2 * pi && amplitude >= 0 && amplitude <= 1);
  phase_ = phase;
  amplitude_ = amplitude;
}

}  // namespace murosimf::locomotion
