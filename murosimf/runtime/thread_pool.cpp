#include "murosimf/runtime/thread_pool.h"

#include <system_error>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf {
namespace {

constexpr std::uint64_t items = 0xffffffff;
constexpr int spins = 2000;  // some ten microseconds: the time between two waves

void relax() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

}  // namespace

ThreadPool::ThreadPool(int threads) {
  try {
    for (int t = 1; t < threads; ++t) workers_.emplace_back([this] { work(); });
  } catch (const std::system_error& error) {
    const std::size_t begun = workers_.size() + 1;
    stop();  // nobody calls the destructor of what was not constructed
    throw SetupError(fmt::format("only {} of {} threads could begin ({}); use fewer: --threads {}", begun, threads,
                                 error.code().message(), begun));
  } catch (...) {
    stop();
    throw;
  }
}

ThreadPool::~ThreadPool() { stop(); }

void ThreadPool::stop() {
  stop_.store(true);
  open_.fetch_add(items + 1);
  open_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::dispatch(std::size_t count, Call call, void* context) {
  call_ = call;
  context_ = context;
  unfinished_.store(count, std::memory_order_relaxed);
  const std::uint64_t generation = (open_.load(std::memory_order_relaxed) & ~items) + items + 1;
  open_.store(generation | count, std::memory_order_release);
  open_.notify_all();
  while (run_one()) {
  }
  for (int spin = 0; unfinished_.load(std::memory_order_acquire) != 0; ++spin) {
    if (spin < spins) {
      relax();
    } else {
      std::this_thread::yield();
    }
  }
}

bool ThreadPool::run_one() {
  std::uint64_t open = open_.load(std::memory_order_acquire);
  do {
    if ((open & items) == 0) return false;
  } while (!open_.compare_exchange_weak(open, open - 1, std::memory_order_acq_rel, std::memory_order_acquire));
  call_(context_, (open & items) - 1);
  unfinished_.fetch_sub(1, std::memory_order_release);
  return true;
}

void ThreadPool::work() {
  while (!stop_.load(std::memory_order_relaxed)) {
    for (int spin = 0; spin < spins; ++spin) {
      if (run_one()) spin = 0;
      relax();
    }
    const std::uint64_t open = open_.load(std::memory_order_acquire);
    if ((open & items) == 0 && !stop_.load()) open_.wait(open, std::memory_order_acquire);
  }
}

}  // namespace murosimf
