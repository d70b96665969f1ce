#include "murosimf/runtime/thread_pool.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/math/floating_point.h"
#include "murosimf/model/error.h"

namespace murosimf {
namespace {

constexpr std::uint64_t items = 0xffffffff;
constexpr int spins = 2000;  // some ten to hundred microseconds: the time between two waves
constexpr int spins_per_look =
    200;  // a microsecond: less is not worth having another thread fetch an entity into its caches

void relax() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

}  // namespace

Sharing usual_sharing() {
  const char* const variable = std::getenv("MUROSIMF_SHARE_WAVES");
  return variable && std::string_view(variable) == "always" ? Sharing::always : Sharing::if_it_pays;
}

ThreadPool::ThreadPool(int threads, Sharing sharing, WorthSharing worth)
    : sharing_(sharing), worth_(worth), shares_(static_cast<std::size_t>(threads)) {
  MUROSIMF_ASSERT(threads >= 1);
  try {
    for (std::size_t t = 1; t < shares_.size(); ++t) workers_.emplace_back([this, t] { work(shares_[t]); });
  } catch (const std::system_error& error) {
    const std::size_t begun = workers_.size() + 1;
    stop();  // the destructor of an object that was not constructed is not called
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
  waves_.fetch_add(1);
  waves_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::share_out(std::span<const std::size_t> ends, Call call, void* context) {
  MUROSIMF_ASSERT(ends.size() == shares_.size() && std::is_sorted(ends.begin(), ends.end()));
  MUROSIMF_ASSERT(unfinished_.load(std::memory_order_relaxed) == 0 && "the wave before has ended");
  ++waves_shared_;
  unfinished_.store(ends.back(), std::memory_order_relaxed);
  std::size_t first = 0;
  for (std::size_t t = 0; t < shares_.size(); ++t) {
    Share& share = shares_[t];
    MUROSIMF_ASSERT(ends[t] >= first && ends[t] - first < items);
    share.first = first;
    share.call = call;
    share.context = context;
    // the generation in the upper half: a thread that is late with an exchange cannot take an item of the next wave
    const std::uint64_t generation = (share.open.load(std::memory_order_relaxed) & ~items) + items + 1;
    share.open.store(generation | (ends[t] - first), std::memory_order_release);
    first = ends[t];
  }
  waves_.fetch_add(1);
  waves_.notify_all();
  run_share(shares_.front());
  for (int spin = 1; unfinished_.load(std::memory_order_acquire) != 0; ++spin) {
    if (spin % spins_per_look == 0) help();
    if (spin > spins) std::this_thread::yield();
    relax();
  }
}

bool ThreadPool::run_share(Share& share) {
  // counted once per share: the counter is in a cache line that all threads write
  std::uint64_t done = 0;
  while (run_one(share)) ++done;
  if (done > 0) unfinished_.fetch_sub(done, std::memory_order_release);
  return done > 0;
}

bool ThreadPool::run_one(Share& share) {
  std::uint64_t open = share.open.load(std::memory_order_acquire);
  do {
    if ((open & items) == 0) return false;
  } while (!share.open.compare_exchange_weak(open, open - 1, std::memory_order_acq_rel, std::memory_order_acquire));
  share.call(share.context, share.first + (open & items) - 1);
  return true;
}

void ThreadPool::help() {
  for (Share& share : shares_) run_share(share);
}

void ThreadPool::work(Share& own) {
  const StandardFloatingPoint modes;  // a thread starts with the modes of the thread that created it
  while (!stop_.load(std::memory_order_relaxed)) {
    const std::uint32_t waves = waves_.load(std::memory_order_acquire);
    for (int spin = 1; spin < spins; ++spin) {
      if (run_share(own)) spin = 1;
      if (spin % spins_per_look == 0 && unfinished_.load(std::memory_order_relaxed) != 0) help();
      relax();
    }
    if (!stop_.load()) waves_.wait(waves, std::memory_order_acquire);
  }
}

}  // namespace murosimf
