/// timeline.h - states of a run, kept for going back to any instant and continuing from there.
///
/// States are bytes of Scene::save(). They are thinned with their age: many of the last seconds are kept, few of older ones, so
/// that a whole run fits into a bounded memory. Between two states the run is repeated, with its commands and its
/// external input (runtime/external_input_history.h). The amount of this input is limited, too: before the oldest kept input only
/// kept states can be reached.
///
/// Continuing from an earlier instant starts a branch; the rest of its parent remains. A state precedes the commands of its
/// instant: these belong to the run after it. Of many branches the oldest are forgotten.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "murosimf/runtime/command_queue.h"
#include "murosimf/runtime/external_input_history.h"
#include "murosimf/world/time.h"

namespace murosimf::session {

struct TimelineOptions {
  Duration period =
      std::chrono::milliseconds(500);               ///< [simulated] from one state to the next; 0: only starts are kept
  std::size_t most_bytes = std::size_t{256} << 20;  ///< of all states except the first ones of runs
  std::size_t most_branches = 64;
  std::size_t most_note_bytes = std::size_t{128} << 20;  ///< of external input, of all branches together
};

/// Description of a branch for observers.
struct BranchView {
  int number = 0;
  std::optional<int> parent;      ///< branch that it continues; none: it began with a reset or a loaded state
  Duration begin{}, end{};        ///< begin: where it departs from its parent
  std::vector<Command> commands;  ///< of its own
  std::vector<Duration> states;   ///< of kept states
};

class Timeline {
 public:
  using State = std::vector<std::byte>;

  explicit Timeline(const TimelineOptions& options) : options_(options) {}

  /// A run begins, at any simulated time: a branch without a parent, which becomes the present one.
  void begin(Duration now, State state);
  /// Whether a state is due.
  [[nodiscard]] bool wants_state(Duration now) const;
  /// The run has reached `now`. The first call after go_back() to before a branch's end starts another branch.
  void advance(Duration now);
  void keep(Duration now, State state);
  /// Commands that were executed since the last call, at the time of the present state.
  void note(std::span<const Command> commands);
  /// External input since the last call, in the step that led to the present state, or before the next one.
  void note(std::vector<RememberedInput> notes);
  /// Records a diagnostic of the run from the present instant of the present branch on.
  void diagnostic(std::string text);

  /// The way to reach an instant.
  struct Way {
    std::shared_ptr<const State> state;
    Duration from{};                     ///< of the state
    std::vector<Command> before;         ///< that led to it, from the start on
    std::vector<Command> then;           ///< from there to the instant (excluded)
    std::vector<RememberedInput> notes;  ///< likewise
    std::vector<Command> diagnostics;    ///< likewise
  };
  /// Throws SetupError for unknown branches and times.
  [[nodiscard]] Way way_to(int branch, Duration time) const;
  /// The run has moved to that instant of that branch.
  void go_back(int branch, Duration time);

  [[nodiscard]] int present() const { return present_; }
  [[nodiscard]] std::vector<BranchView> branches() const;
  /// Of the present branch including its ancestors.
  [[nodiscard]] Duration first() const;
  [[nodiscard]] Duration last() const { return branches_[static_cast<std::size_t>(present_)].end; }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] std::size_t note_bytes() const { return note_bytes_; }

 private:
  struct Kept {
    Duration time{};
    std::shared_ptr<const State> state;
  };
  struct Branch {
    std::optional<int> parent;
    Duration begin{}, end{};
    std::vector<Kept> states;       // by time
    std::vector<Command> commands;  // by time
    bool forgotten = false;
    std::deque<RememberedInput> notes{};    // by time
    std::vector<Command> diagnostics{};     // by time
    Duration notes_from = Duration::min();  // the first instant from which all notes are kept
  };

  [[nodiscard]] const Branch& at(int branch) const;
  [[nodiscard]] bool leads_here(std::size_t branch) const;
  [[nodiscard]] Branch& here() { return branches_[static_cast<std::size_t>(present_)]; }
  void add_branch(Branch branch);
  void settle();
  void thin_out();
  /// Commands, notes and diagnostics of a branch and its ancestors with begin <= time < end. Throws SetupError if notes were dropped.
  void collect(int branch, Duration begin, Duration end, Way& way) const;
  [[nodiscard]] std::vector<Command> commands_until(int branch, Duration end) const;
  void forget_oldest_notes();
  void drop_notes(Branch& branch);

  TimelineOptions options_;
  std::vector<Branch> branches_;
  int present_ = 0;
  Duration now_{};
  bool looks_back_ = false;  // since go_back()
  std::size_t bytes_ = 0;    // of states that may be thinned out
  std::size_t note_bytes_ = 0;
};

}  // namespace murosimf::session
