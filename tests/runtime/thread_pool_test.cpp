// Every item of a wave is run exactly once, and all are done when the call returns.
#include "murosimf/runtime/thread_pool.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>

namespace murosimf {
namespace {

TEST(ThreadPool, RunsEveryItemOnce) {
  for (const int threads : {1, 2, 4}) {
    ThreadPool pool(threads, Sharing::always);
    EXPECT_EQ(pool.threads(), threads);
    for (std::size_t round = 0; round < 2000; ++round) {
      std::vector<int> runs(round % 9, 0);  // plain ints: two threads on one item are a race that TSan sees
      pool.for_each(runs.size(), [&](std::size_t i) { ++runs[i]; });
      for (const int n : runs) ASSERT_EQ(n, 1);
    }
  }
}

TEST(ThreadPool, SharesMayBeAnything) {
  ThreadPool pool(3, Sharing::always);
  const std::vector<std::vector<std::size_t>> all_ends{{0, 0, 0}, {1, 1, 1}, {0, 0, 1}, {5, 5, 5},
                                                       {0, 7, 7}, {0, 0, 7}, {2, 3, 9}};
  for (int round = 0; round < 500; ++round) {
    for (const auto& ends : all_ends) {
      std::vector<int> runs(ends.back(), 0);
      pool.for_each(std::span<const std::size_t>(ends), 0, [&](std::size_t i) { ++runs[i]; });
      for (const int n : runs) ASSERT_EQ(n, 1);
    }
  }
}

// The caller's two items wait for each other: the other thread must take one of them when it has done its own.
TEST(ThreadPool, WhoHasDoneItsShareHelps) {
  ThreadPool pool(2, Sharing::always);
  const std::vector<std::size_t> ends{2, 3};
  std::atomic<int> here = 0, met = 0;
  pool.for_each(std::span<const std::size_t>(ends), 0, [&](std::size_t i) {
    if (i == 2) return;
    ++here;
    for (int wait = 0; here < 2 && wait < 10'000; ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (here == 2) ++met;
  });
  EXPECT_EQ(met, 2);
}

/// How many threads take part in a wave whose items wait for all of them, at most ten seconds.
std::size_t threads_in_a_wave(ThreadPool& pool) {
  std::mutex mutex;
  std::condition_variable came;
  std::set<std::thread::id> here;
  const auto count = static_cast<std::size_t>(pool.threads());
  pool.for_each(count, [&](std::size_t) {
    std::unique_lock lock(mutex);
    here.insert(std::this_thread::get_id());
    came.notify_all();
    came.wait_for(lock, std::chrono::seconds(10), [&] { return here.size() == count; });
  });
  return here.size();
}

// The caller alone could do all the work; items that wait for company show whether the others come, awake or asleep.
TEST(ThreadPool, WakesThreadsThatSleep) {
  ThreadPool pool(3, Sharing::always);
  EXPECT_EQ(threads_in_a_wave(pool), 3U);
  for (int round = 0; round < 5; ++round) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ASSERT_EQ(threads_in_a_wave(pool), 3U) << "round " << round;
  }
}

/// A machine whose time passes only in waves: alone one takes 10 us, and shared out `together`.
std::atomic<std::int64_t> wall_ns{0};
class Waves {
 public:
  /// Makes `count` waves; which part of them was shared out.
  double shared(int count, std::int64_t together_ns) {
    const std::uint64_t before = pool_.waves_shared();
    for (int n = 0; n < count; ++n) wave(together_ns);
    return static_cast<double>(pool_.waves_shared() - before) / count;
  }

 private:
  void wave(std::int64_t together_ns) {
    const std::uint64_t before = pool_.waves_shared();
    std::array<int, 4> runs{};
    pool_.for_each(runs.size(), [&](std::size_t i) {
      ++runs[i];
      if (i == 0) wall_ns += pool_.waves_shared() == before ? 10'000 : together_ns;
    });
    for (const int n : runs) EXPECT_EQ(n, 1);
  }

  ThreadPool pool_{2, Sharing::if_it_pays, WorthSharing([] { return WorthSharing::Time(wall_ns.load()); })};
};

TEST(ThreadPool, FallsBackToOneThreadAndComesBack) {
  Waves waves;
  const int second = 100'000;  // waves of one thread
  EXPECT_EQ(waves.shared(400, 6'000), 0);
  EXPECT_GT(waves.shared(second, 6'000), 0.95);
  EXPECT_LT(waves.shared(second, 30'000), 0.02);
  EXPECT_LT(waves.shared(second, 30'000), 0.01);
  waves.shared(second, 6'000);
  EXPECT_GT(waves.shared(second, 6'000), 0.95);
}

// Callers that cut waves differently for one thread test shares(); those waves are timed as the others.
TEST(ThreadPool, AsksForWavesOfOneThreadWhileItDoesNotShare) {
  ThreadPool pool(2, Sharing::if_it_pays, WorthSharing([] { return WorthSharing::Time(wall_ns.load()); }));
  const std::vector<std::size_t> ends{1, 2};
  const std::span<const std::size_t> both(ends);
  std::uint64_t alone = 0, shared = 0;
  for (int n = 0; n < 20'000; ++n) {
    if (pool.shares()) {
      pool.for_each(both, 5, [&](std::size_t i) { wall_ns += i == 0 ? 6'000 : 0; });
      ++shared;
    } else {
      pool.alone(both, 5, [] { wall_ns += 10'000; });
      ++alone;
    }
  }
  EXPECT_GT(alone, 400U);
  EXPECT_GT(shared, 19'000U);
  EXPECT_EQ(pool.waves(), 20'000U);
  EXPECT_EQ(pool.waves_shared(), shared);
  EXPECT_FALSE(ThreadPool(1, Sharing::always).shares());
  EXPECT_TRUE(ThreadPool(2, Sharing::always).shares());
}

TEST(ThreadPool, StopsWithoutWork) { const ThreadPool pool(4); }

}  // namespace
}  // namespace murosimf
