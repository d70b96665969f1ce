/// compare_seeds.h - the same comparison for several seeds, and for servos that are stronger or weaker: how sure a verdict is.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "murosimf/studies/compare_verdict.h"
#include "murosimf/studies/statistics.h"

namespace murosimf::studies {

enum class Judgement { adequate, not_adequate, undecided };

/// "adequate", "not adequate", "undecided"
[[nodiscard]] std::string_view to_string(Judgement judgement);

/// Of one level, or of the reference with servos as the model has them.
struct SeedsVerdict {
  std::string name;                  ///< label()
  std::vector<bool> adequate;        ///< by seed
  std::vector<std::string> reasons;  ///< by seed, the first one why not; empty: it is adequate
  studies::MeanInterval share;       ///< of seeds for which it is adequate
  Judgement judgement = Judgement::undecided;
};

struct SeedsComparison {
  Comparison first;                     ///< of the first seed, with costs
  Recommendation of_first;              ///< what follows from that alone
  std::uint64_t seed = 0;               ///< the first one
  double servo_tolerance = 0;           ///< [1]
  bool seeds_differ = false;            ///< something in the scene moves otherwise with another seed
  bool stopped = false;                 ///< there are fewer seeds than asked for
  std::vector<SeedsVerdict> levels;     ///< as first.entries; of the reference nothing is said
  std::vector<SeedsVerdict> yardstick;  ///< if servos vary, one: the reference as it is modeled
  std::string verdict;
  [[nodiscard]] std::size_t seeds() const { return levels.empty() ? 0 : levels.front().adequate.size(); }
};

/// Adequate is what is so for more than half of all seeds with a confidence of 95 % (the lower end of Wilson's interval), or for as many as
/// the reference with the model's servos is: that one is off as much as those servos are unknown. Not adequate is what is so for less
/// than half with that confidence, or for less than the yardstick. Seeds without effect count as one.
[[nodiscard]] Judgement judgement(const studies::MeanInterval& share, const studies::MeanInterval* yardstick);

/// Seeds options.seed (or the scene's) and the `seeds` - 1 after it. Throws SetupError as compare().
[[nodiscard]] SeedsComparison compare_seeds(const CompareOptions& options, int seeds, const Thresholds& thresholds);

/// As summary(), over all seeds.
[[nodiscard]] std::string summary(const SeedsComparison& comparison);

/// As to_json() of the first seed, with `seeds`.
[[nodiscard]] std::string to_json(const SeedsComparison& comparison, const Thresholds& thresholds);

}  // namespace murosimf::studies
