/// timeline.h - states of a run, kept so that one can go back to any instant and on from there.
///
/// States are bytes of Scene::save(). They are thinned with their age: of the last seconds many are kept, of what is long ago few, so
/// that a whole run fits into a bounded memory. Between two states the run is repeated, with the commands that came then, and with what
/// came from outside (runtime/external_input_history.h). Of these notes, too, only so many are kept: where the oldest have gone, one can go back to
/// kept states alone.
///
/// A run that goes on from an earlier instant is a branch; the rest of its parent stays. A state is that before the commands of its
/// instant: these belong to what comes after it. Of many branches the oldest are forgotten.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "murosimf/model/time.h"
#include "murosimf/runtime/command_queue.h"
#include "murosimf/runtime/external_input_history.h"

namespace murosimf::session {

struct TimelineOptions {
  Duration period =
      std::chrono::milliseconds(500);               ///< [simulated] from one state to the next; 0: only starts are kept
  std::size_t most_bytes = std::size_t{256} << 20;  ///< of all states but those that resets began with
  std::size_t most_branches = 64;
  std::size_t most_note_bytes = std::size_t{128} << 20;  ///< of what has come from outside, of all branches together
};

/// What others see of a branch.
struct BranchView {
  int number = 0;
  std::optional<int> parent;      ///< of which it went on; none: it began with a reset or a loaded state
  Duration begin{}, end{};        ///< begin: where it left its parent
  std::vector<Command> commands;  ///< of its own
  std::vector<Duration> states;   ///< that are kept
};

class Timeline {
 public:
  using State = std::vector<std::byte>;

  explicit Timeline(const TimelineOptions& options) : options_(options) {}

  /// A run begins, at any simulated time: a branch without a parent, which is the present one from now on.
  void begin(Duration now, State state);
  /// Whether it is time for a state.
  [[nodiscard]] bool wants_state(Duration now) const;
  /// The run has come to `now`. The first call after go_back() to before a branch's end begins another branch.
  void advance(Duration now);
  void keep(Duration now, State state);
  /// Commands that have been carried out since the last call, at the time of the present state.
  void note(std::span<const Command> commands);
  /// What has come from outside since the last call, in the step that led to the present state, or before the next one.
  void note(std::vector<RememberedInput> notes);
  /// What is to be said of the run from the present instant of the present branch on.
  void diagnostic(std::string text);

  /// How to come to an instant.
  struct Way {
    std::shared_ptr<const State> state;
    Duration from{};                     ///< of the state
    std::vector<Command> before;         ///< that had led to it, from the start on
    std::vector<Command> then;           ///< from there to the instant (excluded)
    std::vector<RememberedInput> notes;  ///< likewise
    std::vector<Command> diagnostics;    ///< likewise
  };
  /// Throws SetupError for branches and times that there are not.
  [[nodiscard]] Way way_to(int branch, Duration time) const;
  /// The run is at that instant of that branch now.
  void go_back(int branch, Duration time);

  [[nodiscard]] int present() const { return present_; }
  [[nodiscard]] std::vector<BranchView> branches() const;
  /// Of the present branch with its ancestors.
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
    Duration notes_from = Duration::min();  // the first instant of which all notes are there
  };

  [[nodiscard]] const Branch& at(int branch) const;
  [[nodiscard]] bool leads_here(std::size_t branch) const;
  [[nodiscard]] Branch& here() { return branches_[static_cast<std::size_t>(present_)]; }
  void add_branch(Branch branch);
  void settle();
  void thin_out();
  /// Commands, notes and diagnostics of a branch and its ancestors with begin <= time < end. Throws SetupError if notes are gone.
  void collect(int branch, Duration begin, Duration end, Way& way) const;
  [[nodiscard]] std::vector<Command> commands_until(int branch, Duration end) const;
  void forget_oldest_notes();
  void drop_notes(Branch& branch);

  TimelineOptions options_;
  std::vector<Branch> branches_;
  int present_ = 0;
  Duration now_{};
  bool looks_back_ = false;  // since go_back()
  std::size_t bytes_ = 0;    // of what may be thinned out
  std::size_t note_bytes_ = 0;
};

}  // namespace murosimf::session
