/// compare_verdict.h - which level is adequate: the cheapest one that deviates by less than the thresholds.
#pragma once

#include <string>
#include <vector>

#include "murosimf/studies/compare_runs.h"
#include "murosimf/studies/compare_thresholds.h"

namespace murosimf::studies {

/// [1] A level costs less than another if it costs less than this share of it: repeated timings of one level differ by a tenth.
inline constexpr double clearly_cheaper = 0.8;

struct LevelVerdict {
  bool adequate = false;
  std::vector<std::string> reasons;      ///< why not
  std::vector<std::string> diagnostics;  ///< what is worth knowing, and refuses nothing
};

/// Adequate is what ran to its end, fell and got up when the reference did, touched and threw over the same entities, and deviates
/// by less than the thresholds, also those of others. Runs after a fall drift apart at any level: deviations are those of the
/// part before it (CompareEntry::compared_until), and of what the robot had touched by then.
/// If `outcomes` are named, they alone decide, over the whole run.
[[nodiscard]] LevelVerdict judge(const CompareEntry& entry, const CompareEntry& reference, const Thresholds& thresholds,
                                 const std::vector<NamedOutcome>& outcomes = {});

/// The same for software that reads the accelerometer or the gyroscope: the robot falls and gets up when the reference does, and what they
/// show deviates by less than the thresholds.
[[nodiscard]] LevelVerdict judge_sensors(const CompareEntry& entry, const CompareEntry& reference,
                                         const Thresholds& thresholds);

struct Recommendation {
  std::string verdict;             ///< which level is adequate, and how close it is; or why nothing can be said
  std::vector<std::string> needs;  ///< "full_dynamics and up are needed for joint torques"
  std::string sensors;   ///< for which level inertial sensors are right; empty: there are none, or nothing can be said
  std::string sentence;  ///< the verdict, why others are not adequate, and the needs
  std::string level, contact;          ///< adequate at the lowest cost; empty if nothing can be said
  std::vector<LevelVerdict> verdicts;  ///< as the entries
  std::vector<LevelVerdict> of_sensors;
};

/// Costs that differ by less than a fifth count as equal: then the simpler level is recommended.
[[nodiscard]] Recommendation recommend(const Comparison& comparison, const Thresholds& thresholds);

}  // namespace murosimf::studies
