/// compare_thresholds.h - which deviations count, and from which size on (docs/compare.md gives the reasons).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/studies/compare_metrics.h"

namespace murosimf::studies {

/// What a deviation is one of.
enum class Concern { robot, others, sensors };

/// One deviation that has a threshold.
struct ComparedQuantity {
  std::string_view name;   ///< for --threshold
  std::string_view words;  ///< in sentences
  std::string_view unit;   ///< of the threshold and of what is printed
  double scale;            ///< from SI to that unit
  int decimals;            ///< that are worth printing
  double threshold;        ///< default, in that unit
  double Deviations::*deviation = nullptr;
  OfAnother Deviations::*of_another = nullptr;  ///< instead, if it is one of others or of sensors
  Concern concern = Concern::robot;

  [[nodiscard]] double of(const Deviations& deviations) const {
    return scale * (of_another ? (deviations.*of_another).value : deviations.*deviation);
  }
  /// Name of the other entity or the sensor that deviates; empty: the robot itself.
  [[nodiscard]] const std::string& owner(const Deviations& deviations) const;
};

[[nodiscard]] std::span<const ComparedQuantity> quantities();

/// "12.9 %"
[[nodiscard]] std::string number_of(const ComparedQuantity& quantity, double value);

/// Limits up to which deviations count as none.
struct Thresholds {
  Thresholds();
  /// "NAME=VALUE", in the unit of the quantity. Throws SetupError with the nearest name.
  void set(const std::string& text);

  std::vector<double> values;  ///< as quantities(), in their units
  double fall_time = 0.25;     ///< [s] between the falls of two levels
  double contact_duty =
      20;  ///< [%] of the time around touches in which servos ask for all that they have: more is a diagnostic
};

}  // namespace murosimf::studies
