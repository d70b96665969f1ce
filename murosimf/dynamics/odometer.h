/// odometer.h - algorithm: distance and number of falls of an entity, for reports.
///
/// Distance: length of the base's horizontal path, sampled twice a second so that the swaying of a walk does not count.
/// A fall: the base leans more than 60 degrees away from its attitude at the start; counted again only after it came
/// back under 30 degrees.
#pragma once

#include "murosimf/model/properties.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/entity.h"
#include "murosimf/world/setup.h"

namespace murosimf::dynamics {

class Odometer final : public Algorithm {
 public:
  explicit Odometer(Setup& setup);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::observe; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;

  static constexpr double rate_hz = 10;

 private:
  void measure_distance() noexcept;
  void watch_falls() noexcept;

  const bool can_fall_;  // objects without joints (balls) roll, they do not fall
  std::span<const Vec3d> r_;
  std::span<const Mat3d> R_;
  double& distance_;    // [m]
  Vec3d& sample_;       // [m] place of the last distance sample
  double& falls_;       // [1]
  double& lying_;       // 0 or 1
  Vec3d& up_at_start_;  // [1] the base's axis that pointed up
};

/// Result of an entity's odometer; 0 before its first step, and without one.
struct WayAndFalls {
  double walked = 0;  ///< [m] horizontal path of the base, to where it is
  int falls = 0;
};
[[nodiscard]] WayAndFalls way_and_falls(const Entity& entity);

}  // namespace murosimf::dynamics
