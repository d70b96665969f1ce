#include "murosimf/recording/rerun.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/runtime/clock.h"

namespace murosimf::recording {
namespace {

/// A repetition with comparisons.
class Repetition {
 public:
  Repetition(const RecordedRun& run, const RerunOptions& options)
      : run_(run), reference_(options.reference ? *options.reference : run.states()), options_(options) {}

  RerunResult run() {
    const std::shared_ptr<scene::Scene> scene = run_.build(options_.repeat);
    scene_ = scene.get();
    if (options_.prepare) options_.prepare(*scene);
    run_.begin(*scene, run_.description().start);
    Simulation& simulation = scene->simulation();
    simulation.stop_if([&] { return ends_ || (options_.repeat.stop && options_.repeat.stop()); });
    result_.begin = simulation.now();
    // a complete recording has a final check after the last step; one that was cut off has none
    const bool has_end = !attached_text(reference_.file(), "report.json").empty();
    const Duration end = has_end ? run_.end() : run_.end() + simulation.tick();
    // at the same point of a step as in the recorder: after the scene's own events of that time, before the commands
    for (const RecordedState& state : reference_.all()) {
      if (state.time < end && state.time >= simulation.now())
        simulation.at(state.time, [this, &state] { compare(state); });
    }
    Clock clock(std::nullopt);
    simulation.run(std::max(Duration{}, end - simulation.now()), clock, options_.progress);
    if (has_end && simulation.now() == end) compare_at_end();
    if (options_.finish) options_.finish(*scene);
    result_.end = simulation.now();
    result_.stopped = options_.repeat.stop && options_.repeat.stop();
    return std::move(result_);
  }

 private:
  /// Changes after the last step precede the final check.
  void compare_at_end() {
    const Duration end = scene_->simulation().now();
    const auto& commands = run_.states().commands();
    const auto& additions = run_.additions();
    if (std::ranges::find(commands, end, &Command::time) != commands.end() ||
        std::ranges::find(additions, end, &RecordedAddition::time) != additions.end()) {
      scene_->simulation().carry_out_commands();
    }
    for (const RecordedState& state : reference_.all()) {
      if (state.time == end) compare(state);
    }
  }

  void compare(const RecordedState& state) {
    MUROSIMF_ASSERT(scene_ != nullptr);
    if (result_.difference) return compare_numbers(state);
    ++result_.compared;
    if (scene_->simulation().state_hash() == state.hash) {
      same_ = state.time;
      return;
    }
    result_.difference = Divergence{.same = same_,
                                    .differs = state.time,
                                    .tick = scene_->simulation().tick(),
                                    .looked = state.time,
                                    .what = {},
                                    .unlike = {}};
    compare_numbers(state);
  }

  /// Compares the numbers, at the first whole state from the difference on.
  void compare_numbers(const RecordedState& state) {
    Divergence& difference = *result_.difference;
    if (!state.chunk || difference.what || !difference.unlike.empty()) return;
    difference.looked = state.time;
    try {
      const std::shared_ptr<scene::Scene> recorded = run_.build(options_.repeat);
      run_.initialize(*recorded);
      run_.add_until(*recorded, state.time);
      reference_.load(*recorded, state);
      difference.what = state_difference(recorded->simulation().world(), scene_->simulation().world());
      if (!difference.what) difference.unlike = "every number is the same, only the hash differs";
    } catch (const SetupError& error) {
      difference.unlike = error.what();
    }
    ends_ = !options_.to_the_end;
  }

  const RecordedRun& run_;
  const RecordedStates& reference_;
  const RerunOptions& options_;
  scene::Scene* scene_ = nullptr;
  std::optional<Duration> same_;
  bool ends_ = false;
  RerunResult result_;
};

}  // namespace

/// Without hashes there is nothing to compare with.
RerunResult rerun(const RecordedRun& run, const RerunOptions& options) {
  const RecordedStates& reference = options.reference ? *options.reference : run.states();
  if (reference.all().empty()) {
    throw SetupError(fmt::format("{}: no state hashes are recorded (--record-what hashes): there is nothing to compare",
                                 reference.file().file().string()));
  }
  return Repetition(run, options).run();
}

}  // namespace murosimf::recording
