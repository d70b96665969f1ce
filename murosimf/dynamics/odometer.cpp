#include "murosimf/dynamics/odometer.h"

#include <cmath>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/math/assert.h"

namespace murosimf::dynamics {
namespace {

constexpr Duration sample_period = std::chrono::milliseconds(500);  // swaying with the steps of a walk averages out
const double cos_fallen = std::cos(pi / 3);  // two thresholds: a robot that rocks on its edge falls once
const double cos_upright = std::cos(pi / 6);

}  // namespace

Odometer::Odometer(Setup& setup)
    : can_fall_(!setup.model().joints().empty()),
      r_(setup.read(properties::position)),
      R_(setup.read(properties::orientation)),
      distance_(setup.write(properties::distance_walked)[0]),
      sample_(setup.write(properties::distance_sample)[0]),
      falls_(setup.write(properties::falls)[0]),
      lying_(setup.write(properties::lying)[0]),
      up_at_start_(setup.write(properties::up_at_start)[0]) {}

void Odometer::initialize() {
  distance_ = falls_ = lying_ = 0;
  sample_ = r_[0];
  up_at_start_ = transposed_times(R_[0], Vec3d{0, 0, 1});
}

void Odometer::step(const Instant& instant) noexcept {
  if (instant.now % sample_period == Duration{}) measure_distance();
  MUROSIMF_ASSERT(instant.now >= Duration{});
  if (can_fall_) watch_falls();
}

WayAndFalls way_and_falls(const Entity& entity) {
  const Column<double>* falls = entity.find(properties::falls);
  if (!falls || std::isnan(falls->values[0])) return {};
  const auto base = [&](const auto& property) { return entity.find(property)->values[0]; };
  const Vec3d since_sample = base(properties::position) - base(properties::distance_sample);
  return {base(properties::distance_walked) + std::hypot(since_sample.x, since_sample.y),
          static_cast<int>(falls->values[0])};
}

void Odometer::measure_distance() noexcept {
  const Vec3d moved = r_[0] - sample_;
  distance_ += std::hypot(moved.x, moved.y);
  sample_ = r_[0];
}

void Odometer::watch_falls() noexcept {
  const double cos_lean = (R_[0] * up_at_start_).z;
  // hysteresis between 60 and 30 degrees: a rocking robot counts once
  if (lying_ == 0 && cos_lean < cos_fallen) {
    lying_ = 1;
    falls_ += 1;
  } else if (lying_ == 1 && cos_lean > cos_upright) {
    lying_ = 0;
  }
}

}  // namespace murosimf::dynamics
