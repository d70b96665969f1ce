/// thread_pool.h - a fixed pool of threads that runs the algorithms of one wave.
///
/// Threads take the items of a wave one by one. Algorithms of a wave never touch what another of them writes, so the
/// result cannot depend on who takes what or on the number of threads. The calling thread takes part and never waits
/// for a thread that has not begun: on a busy machine the pool is no slower than one thread.
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace murosimf {

class ThreadPool {
 public:
  /// `threads` counts the calling thread too; at least 1. Throws SetupError if the system does not give so many.
  explicit ThreadPool(int threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  [[nodiscard]] int threads() const { return static_cast<int>(workers_.size()) + 1; }

  /// Calls `run(i)` for every i in [0, count) and returns when all are done. `run` must not throw.
  template <class Run>
  void for_each(std::size_t count, Run&& run) {
    if (count <= 1 || workers_.empty()) {
      for (std::size_t i = 0; i < count; ++i) run(i);
      return;
    }
    dispatch(
        count, [](void* context, std::size_t i) { (*static_cast<Run*>(context))(i); }, &run);
  }

 private:
  using Call = void (*)(void* context, std::size_t i);

  void dispatch(std::size_t count, Call call, void* context);
  /// Takes one item and runs it; false if none is left.
  bool run_one();
  void work();
  void stop();  ///< ends all threads that have begun

  // Generation of the wave in the upper half, items that nobody has taken in the lower one. Taking an item keeps the
  // wave from ending, so whoever took one may read call_ and context_.
  std::atomic<std::uint64_t> open_{0};
  std::atomic<std::uint64_t> unfinished_{0};
  std::atomic<bool> stop_{false};
  Call call_ = nullptr;
  void* context_ = nullptr;
  std::vector<std::thread> workers_;
};

}  // namespace murosimf
