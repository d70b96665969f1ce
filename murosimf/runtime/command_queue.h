/// command_queue.h - what other threads want changed, done between two steps in the order in which they asked.
#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <mutex>
#include <string>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/world/time.h"

namespace murosimf {

/// A command that was carried out: with these a run can be repeated.
struct Command {
  Duration time{};   ///< at the beginning of the step from then on
  std::string text;  ///< what was to be done, in words that its sender understands
};

class CommandQueue {
 public:
  /// From any thread. The future is ready when `call` was made, and has what it threw. `check`, if there is one, comes before it: if
  /// that throws, there was no command.
  std::future<void> post(std::string text, std::function<void()> call, std::function<void()> check = {});

  /// Makes all calls that were posted before, in their order; the thread that runs the simulation. Costs a look if there are none, and
  /// says so.
  bool carry_out(Duration now) {
    const bool any = waiting_.load(std::memory_order_acquire);
    if (any) carry_out_all(now);
    return any;
  }

  /// Those that were carried out, also if they threw: they may have done a part.
  [[nodiscard]] const std::vector<Command>& history() const { return history_; }
  void forget_history() { history_.clear(); }
  /// For a caller that executes a command itself, between two steps.
  void note(Duration now, std::string text) { history_.push_back({now, std::move(text)}); }
  /// All but the first ones were undone.
  void forget_from(std::size_t number) {
    MUROSIMF_ASSERT(number <= history_.size());
    history_.resize(number);
  }
  /// For going back to a state: the commands that had been executed until then.
  void set_history(std::vector<Command> commands) { history_ = std::move(commands); }

 private:
  struct Posted {
    std::string text;
    std::function<void()> call, check;
    std::promise<void> done;
  };
  void carry_out_all(Duration now);

  std::mutex mutex_;
  std::vector<Posted> posted_;
  std::atomic<bool> waiting_{false};
  std::vector<Command> history_;
};

}  // namespace murosimf
