// Every item of a wave is run exactly once, and all are done when the call returns.
#include "murosimf/runtime/thread_pool.h"

#include <gtest/gtest.h>

#include <thread>

namespace murosimf {
namespace {

TEST(ThreadPool, RunsEveryItemOnce) {
  for (const int threads : {1, 2, 4}) {
    ThreadPool pool(threads);
    EXPECT_EQ(pool.threads(), threads);
    for (std::size_t round = 0; round < 2000; ++round) {
      std::vector<int> runs(round % 9, 0);  // plain ints: two threads on one item are a race that TSan sees
      pool.for_each(runs.size(), [&](std::size_t i) { ++runs[i]; });
      for (const int n : runs) ASSERT_EQ(n, 1);
    }
  }
}

TEST(ThreadPool, WakesThreadsThatSleep) {
  ThreadPool pool(3);
  std::atomic<int> sum{0};
  for (int round = 0; round < 5; ++round) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    pool.for_each(10, [&](std::size_t i) { sum += static_cast<int>(i); });
  }
  EXPECT_EQ(sum.load(), 5 * 45);
}

TEST(ThreadPool, StopsWithoutWork) { const ThreadPool pool(4); }

}  // namespace
}  // namespace murosimf
