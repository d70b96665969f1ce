/// compare_verdict.h - which level is adequate: the cheapest one that deviates by less than the thresholds.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/io/compare_runs.h"

namespace murosimf::io {

/// One deviation that has a threshold. docs/compare.md gives the reason of every default.
struct Quantity {
  std::string_view name;          ///< for --threshold
  std::string_view words;         ///< in sentences
  std::string_view unit;          ///< of the threshold and of what is printed
  double scale;                   ///< from SI to that unit
  double threshold;               ///< default, in that unit
  double Deviations::*deviation;  ///< SI
};

[[nodiscard]] std::span<const Quantity> quantities();

/// What still counts as the same.
struct Thresholds {
  Thresholds();
  /// "NAME=VALUE", in the unit of the quantity. Throws SetupError with the nearest name.
  void set(const std::string& text);

  std::vector<double> values;  ///< as quantities(), in their units
  double fall_time = 0.25;     ///< [s] between the falls of two levels
};

struct LevelVerdict {
  bool adequate = false;
  std::vector<std::string> reasons;  ///< why not
};

struct Recommendation {
  std::string sentence;
  std::string level, contact;          ///< adequate at the lowest cost; empty if nothing can be said
  std::vector<LevelVerdict> verdicts;  ///< as the entries
};

[[nodiscard]] Recommendation recommend(const Comparison& comparison, const Thresholds& thresholds);

}  // namespace murosimf::io
