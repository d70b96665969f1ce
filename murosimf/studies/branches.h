/// branches.h - several continuations of one moment of a recorded run, each with other changes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "murosimf/recording/recorded_run.h"

namespace murosimf::studies {

struct BranchOptions {
  std::optional<Duration> time{};      ///< from where; nothing: the last whole state
  std::optional<Duration> duration{};  ///< of each; nothing: to the end of the recording, or as long as the scene lasts
  /// One branch each: changes as of --at without the time, separated by ';'. The first branch, which is always there, has none.
  std::vector<std::string> changes{};
  std::vector<std::string> results{};  ///< patterns (chosen_results.h); none: usual_results()
  recording::RepeatOptions repeat{};   ///< `threads`: branches at a time, each is stepped by one
};

struct Branch {
  std::string change;  ///< empty: as it was
  std::uint64_t state_hash = 0;
  std::vector<double> values;  ///< of the results; empty: it was stopped
};

struct Branches {
  std::string file;
  Duration from{}, to{};
  std::vector<std::string> results;  ///< names, with unit
  std::vector<Branch> branches;
  bool stopped = false;  ///< by repeat.stop
};

/// Commands that are recorded after that moment come in every branch. Throws SetupError: a change that cannot be made.
[[nodiscard]] Branches branch(const recording::RecordedRun& run, const BranchOptions& options);

[[nodiscard]] std::string to_text(const Branches& branches);
[[nodiscard]] std::string to_csv(const Branches& branches);
/// docs/json.md
[[nodiscard]] std::string to_json(const Branches& branches);

}  // namespace murosimf::studies
