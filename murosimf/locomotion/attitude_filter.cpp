#include "murosimf/locomotion/attitude_filter.h"

#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::locomotion {

void AttitudeFilter::follow(double dt, const Vec3d& gyroscope, const Vec3d& force, double gravity,
                            const AttitudeTrust& trust, bool still) noexcept {
  MUROSIMF_ASSERT(dt > 0 && gravity > 0);
  MUROSIMF_ASSERT(trust.accelerometer > 0 && trust.bias > 0 && trust.still > 0);
  const Vec3d error = cross((1 / gravity) * force, up);
  up += dt * cross(up, gyroscope - bias + (1 / (still ? trust.still : trust.accelerometer)) * error);
  up = (1 / norm(up)) * up;
  bias += still ? (dt / (dt + trust.still)) * (gyroscope - bias) : (-dt / (trust.bias * trust.bias)) * error;
}

void AttitudeFilter::start(const Vec3d& force) noexcept {
  const double length = norm(force);
  up = length > 0 ? (1 / length) * force : Vec3d{0, 0, 1};
  bias = {};
}

double AttitudeFilter::pitch() const noexcept { return std::atan2(-up.x, std::hypot(up.y, up.z)); }
double AttitudeFilter::roll() const noexcept { return std::atan2(up.y, up.z); }

}  // namespace murosimf::locomotion
