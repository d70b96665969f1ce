/// lock_step.h - pacer: the simulation goes on as far as another thread allows, which waits until it is there.
///
///     LockStep pacer;
///     std::thread run([&] { simulation.run(60s, pacer); pacer.finish(); });
///     while (pacer.advance(20ms)) answer(simulation);        // the simulation stands still between two calls
///
/// For servers that step several programs together, and for control software that thinks longer than a cycle.
#pragma once

#include <condition_variable>
#include <mutex>

#include "murosimf/runtime/pacer.h"

namespace murosimf {

class LockStep final : public Pacer {
 public:
  /// Lets the simulation go on for `by` of simulated time, and returns when it is there: between two steps, where it stays. The
  /// first step that ends at or after that time is the last one. False if the run has ended before.
  bool advance(Duration by);
  /// Ends all waiting: the run continues alone, advance() returns false. To be called at the end of a run, from either
  /// side.
  void finish();

  void start(Duration now) override;
  void before_step(Duration now, const StopRequest& stop) override;
  void after_step(Duration now, const StopRequest& stop) override;

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  Duration now_{}, allowed_{};
  bool started_ = false, finished_ = false;
};

}  // namespace murosimf
