#include "murosimf/sensors/inertial.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "murosimf/math/assert.h"

namespace murosimf::sensors {
namespace {

Output gyroscope() { return {"gyroscope", "rad/s", xyz()}; }
Output accelerometer() { return {"accelerometer", "m/s^2", xyz()}; }
Output orientation() { return {"orientation", "1", {"w", "x", "y", "z"}}; }

/// Replaces the errors e, which follow a place for w, by the true orientation with these errors.
void turn_by_errors(const Mat3d& orientation, std::span<double> values) noexcept {
  MUROSIMF_ASSERT(values.size() >= 4);
  const Quaterniond q = from_matrix(orientation) * exponential(Vec3d{values[1], values[2], values[3]});
  values[0] = q.w;
  values[1] = q.x;
  values[2] = q.y;
  values[3] = q.z;
}

}  // namespace

Gyroscope::Gyroscope(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : Sensor(setup, spec, surroundings, {gyroscope()}), mounting_(setup, spec) {}

void Gyroscope::measure(std::span<double> values) noexcept {
  write(transpose(mounting_.orientation()) * mounting_.angular_velocity(), values);
}

SpecificForce::SpecificForce(Setup& setup, const SensorSpec& spec, Duration window)
    : mounting_(setup, spec),
      gravity_(setup.world().gravity),
      period_(seconds(setup.period())),
      window_(static_cast<std::size_t>(std::max<Duration::rep>(1, window / setup.period()))) {}

void SpecificForce::state(StateArchive& archive) {
  archive(last_velocity_, last_orientation_);
  archive.elements(std::span(window_));
  archive(sum_, calls_);
}

/// Specific force, averaged over the step that has just ended.
Vec3d SpecificForce::of_step() noexcept {
  const Mat3d R = mounting_.orientation();
  MUROSIMF_ASSERT(period_ > 0);
  const Vec3d v = mounting_.velocity();
  const Vec3d force = (1 / period_) * (v - last_velocity_) - gravity_;
  // the mean of both attitudes: second order in the turn of one step
  const Vec3d felt = 0.5 * (transpose(R) * force + transpose(last_orientation_) * force);
  last_orientation_ = R;
  last_velocity_ = v;
  return felt;
}

/// Adds a force to the window. The sum is computed anew once per window, so that rounding errors do not accumulate.
void SpecificForce::put_in(const Vec3d& force) noexcept {
  MUROSIMF_ASSERT(!window_.empty());
  const std::size_t place = calls_ % window_.size();
  // without the oldest one, which is replaced
  if (place == 0) sum_ = std::accumulate(window_.begin() + 1, window_.end(), Vec3d{});
  if (place != 0) sum_ -= window_[place];
  sum_ += force;
  window_[place] = force;
}

Vec3d SpecificForce::next() noexcept {
  const Vec3d force = of_step();
  if (calls_++ == 0) {  // the first call has no preceding velocity
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    std::fill(window_.begin(), window_.end(), Vec3d{});
    sum_ = {};
    return {nothing, nothing, nothing};
  }
  put_in(force);
  // the window may not be full yet
  return (1 / static_cast<double>(std::min<std::size_t>(calls_ - 1, window_.size()))) * sum_;
}

Accelerometer::Accelerometer(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : Sensor(setup, spec, surroundings, {accelerometer()}, Watch::always),
      force_(setup, spec, reading().info->period) {}

void Accelerometer::measure(std::span<double> values) noexcept { write(force_.next(), values); }

void Accelerometer::expect(std::span<double> values) const noexcept { write(force_.at_rest(), values); }

Orientation::Orientation(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : Sensor(setup, spec, surroundings, {orientation()}), mounting_(setup, spec) {}

void Orientation::measure(std::span<double> values) noexcept {
  // only errors pass through the signal: a quaternion with added noise would not be one
  std::fill(values.begin(), values.end(), 0.0);
}

void Orientation::present(std::span<double> values) noexcept { turn_by_errors(mounting_.orientation(), values); }

Imu::Imu(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : Sensor(setup, spec, surroundings, {gyroscope(), accelerometer(), orientation()}, Watch::always),
      mounting_(setup, spec),
      force_(setup, spec, reading().info->period) {}

void Imu::measure(std::span<double> values) noexcept {
  MUROSIMF_ASSERT(values.size() == 10);
  write(force_.next(), values.subspan(3));
  write(transpose(force_.orientation()) * mounting_.angular_velocity(), values);
  std::fill_n(values.begin() + 6, 4, 0.0);  // as in Orientation::measure
}

void Imu::expect(std::span<double> values) const noexcept { write(force_.at_rest(), values.subspan(3)); }

void Imu::present(std::span<double> values) noexcept { turn_by_errors(force_.orientation(), values.subspan(6)); }

}  // namespace murosimf::sensors
