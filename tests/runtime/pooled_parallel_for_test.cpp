// The threads of a simulation help with entities, each of which is done once.
#include "murosimf/runtime/pooled_parallel_for.h"

#include <deque>
#include <thread>

#include <gtest/gtest.h>

#include "murosimf/world/entity.h"
#include "tests/fixtures.h"

namespace murosimf {
namespace {

TEST(PooledParallelFor, EveryEntityIsDoneOnce) {
  const ModelPtr model = std::make_shared<const Model>(fixtures::two_legged());
  std::deque<Entity> entities;
  std::vector<const Entity*> all;
  for (int i = 0; i < 9; ++i) all.push_back(&entities.emplace_back("robot", model));
  for (const int threads : {1, 2, 4}) {
    ThreadPool pool(threads, Sharing::always);
    PooledParallelFor parallel_for(pool);
    for (const bool at_home : {false, true}) {
      if (at_home) {
        ThreadAffinity thread_affinity(static_cast<std::size_t>(threads));
        thread_affinity.share_out(all);
        parallel_for.use(thread_affinity);
      }
      for (const std::size_t count : {0U, 1U, 2U, 9U}) {
        std::vector<int> runs(9, 0);  // plain ints: two threads on one item are a race that TSan sees
        parallel_for.for_each(std::span(all).first(count), [&](std::size_t i) { ++runs[i]; });
        for (std::size_t i = 0; i < runs.size(); ++i) EXPECT_EQ(runs[i], i < count ? 1 : 0);
      }
    }
  }
}

// Two that wait for each other must be done at the same time.
TEST(PooledParallelFor, EntitiesAreDoneWhereTheyAreAtHome) {
  const ModelPtr model = std::make_shared<const Model>(fixtures::two_legged());
  const Entity first("first", model), second("second", model);
  const std::vector<const Entity*> all{&first, &second};
  ThreadPool pool(2, Sharing::always);
  PooledParallelFor parallel_for(pool);
  ThreadAffinity thread_affinity(2);
  thread_affinity.share_out(all);
  parallel_for.use(thread_affinity);
  std::atomic<int> here = 0;
  std::array<std::thread::id, 2> threads;
  parallel_for.for_each(all, [&](std::size_t i) {
    threads[i] = std::this_thread::get_id();
    ++here;
    for (int wait = 0; here < 2 && wait < 10'000; ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  });
  EXPECT_NE(threads[0], threads[1]);
}

}  // namespace
}  // namespace murosimf
