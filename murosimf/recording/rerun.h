/// rerun.h - repeats a recorded run and finds the first difference from its record, or from another repetition.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "murosimf/recording/recorded_run.h"
#include "murosimf/recording/state_difference.h"

namespace murosimf::recording {

struct Divergence {
  std::optional<Duration> same;         ///< the last instant at which both were equal; nothing: none was recorded
  Duration differs{};                   ///< the first instant at which they differed
  Duration tick{};                      ///< of the simulation
  Duration looked{};                    ///< instant at which the states were compared number by number
  std::optional<StateDifference> what;  ///< recorded, then repeated value; nothing: no state was recorded from then on
  std::string unlike;                   ///< reason why the recorded state could not be compared; empty: it was
  /// Whether there is no step between `same` and `differs`.
  [[nodiscard]] bool is_one_step() const { return same && differs - *same <= tick; }
};

struct RerunResult {
  std::size_t compared = 0;              ///< instants
  Duration begin{}, end{};               ///< of the repetition
  bool stopped = false;                  ///< early, by RepeatOptions::stop
  std::optional<Divergence> difference;  ///< nothing: none
};

struct RerunOptions {
  RepeatOptions repeat;
  /// Reference of the comparison; null: the records of the run itself.
  const RecordedStates* reference = nullptr;
  /// Called with the scene before it is initialized, and after the last step: for recording the repetition.
  std::function<void(scene::Scene&)> prepare{}, finish{};
  std::function<void(Duration)> progress{};
  bool to_the_end = false;  ///< continue after the first difference
};

/// From the beginning of the run to its end, or to the first difference. Throws SetupError.
[[nodiscard]] RerunResult rerun(const RecordedRun& run, const RerunOptions& options);

/// For people: some lines.
[[nodiscard]] std::string to_text(const RerunResult& result);
/// One JSON object (docs/json.md).
[[nodiscard]] std::string to_json(const RerunResult& result);

}  // namespace murosimf::recording
