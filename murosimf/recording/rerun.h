/// rerun.h - repeats a recorded run and finds where it first differs from what is recorded of it, or of another repetition.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "murosimf/recording/recorded_run.h"
#include "murosimf/recording/state_difference.h"

namespace murosimf::recording {

struct Divergence {
  std::optional<Duration> same;  ///< the last instant before at which both were the same; nothing: none was recorded
  Duration differs{};            ///< the first one at which they were not
  Duration tick{};               ///< of the simulation
  Duration looked{};             ///< when the states of both were compared number by number
  std::optional<StateDifference> what;  ///< first recorded, then repeated; nothing: no state was recorded from then on
  std::string unlike;                   ///< why the recorded state could not be compared; empty: it could
  /// Whether no step is between `same` and `differs`.
  [[nodiscard]] bool is_one_step() const { return same && differs - *same <= tick; }
};

struct RerunResult {
  std::size_t compared = 0;              ///< instants
  Duration begin{}, end{};               ///< of the repetition
  bool stopped = false;                  ///< early, by RepeatOptions::stop
  std::optional<Divergence> difference;  ///< nothing: there is none
};

struct RerunOptions {
  RepeatOptions repeat;
  /// What the repetition is compared with; null: what is recorded of the run itself.
  const RecordedStates* reference = nullptr;
  /// Called with the scene before it is initialized, and after the last step: for who records the repetition.
  std::function<void(scene::Scene&)> prepare{}, finish{};
  std::function<void(Duration)> progress{};
  bool to_the_end = false;  ///< also after the first difference
};

/// From where the run began to its end, or to the first difference. Throws SetupError.
[[nodiscard]] RerunResult rerun(const RecordedRun& run, const RerunOptions& options);

/// For people: some lines.
[[nodiscard]] std::string to_text(const RerunResult& result);
/// One JSON object (docs/json.md).
[[nodiscard]] std::string to_json(const RerunResult& result);

}  // namespace murosimf::recording
