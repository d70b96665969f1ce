// What other threads ask for is done between steps, in their order, and can be repeated.
#include "murosimf/runtime/command_queue.h"

#include <thread>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"

namespace murosimf {
namespace {

using namespace std::chrono_literals;

TEST(CommandQueue, KeepsTheOrderOfAsking) {
  CommandQueue queue;
  std::string done;
  for (const char* text : {"a", "b", "c"}) queue.post(text, [&done, text] { done += text; });
  EXPECT_EQ(done, "");
  queue.carry_out(5ms);
  EXPECT_EQ(done, "abc");
  queue.carry_out(6ms);
  EXPECT_EQ(done, "abc") << "once";
  ASSERT_EQ(queue.history().size(), 3u);
  EXPECT_EQ(queue.history()[1].text, "b");
  EXPECT_EQ(queue.history()[1].time, Duration(5ms));
}

TEST(CommandQueue, TellsWhoAskedWhatWentWrong) {
  CommandQueue queue;
  auto good = queue.post("good", [] {});
  auto bad = queue.post("bad", [] { throw SetupError("no such thing"); });
  auto after = queue.post("after", [] {});
  EXPECT_EQ(good.wait_for(0s), std::future_status::timeout);
  queue.carry_out(1ms);
  EXPECT_NO_THROW(good.get());
  EXPECT_THROW(bad.get(), SetupError);
  EXPECT_NO_THROW(after.get());
  ASSERT_EQ(queue.history().size(), 3u) << "what failed may have done a part";
  EXPECT_EQ(queue.history()[1].text, "bad");
}

TEST(CommandQueue, WhatIsRefusedIsNoCommand) {
  CommandQueue queue;
  bool done = false;
  auto refused = queue.post(
      "bad", [&] { done = true; }, [] { throw SetupError("no such thing"); });
  auto accepted = queue.post(
      "good", [] {}, [] {});
  queue.carry_out(1ms);
  EXPECT_THROW(refused.get(), SetupError);
  EXPECT_FALSE(done);
  ASSERT_EQ(queue.history().size(), 1u);
  EXPECT_EQ(queue.history()[0].text, "good");
}

TEST(CommandQueue, WhatACommandAsksForIsDoneNextTime) {
  CommandQueue queue;
  int inner = 0;
  queue.post("outer", [&] { queue.post("inner", [&] { ++inner; }); });
  queue.carry_out(1ms);
  EXPECT_EQ(inner, 0);
  queue.carry_out(2ms);
  EXPECT_EQ(inner, 1);
}

TEST(CommandQueue, LosesNothingOfManyThreads) {
  CommandQueue queue;
  constexpr int each = 500;
  std::vector<int> next(4);  // of every thread: its commands keep their order
  bool in_order = true;
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < next.size(); ++t) {
    threads.emplace_back([&queue, &next, &in_order, t] {
      for (int i = 0; i < each; ++i) {
        queue.post("x", [&next, &in_order, t, i] { in_order = in_order && next[t]++ == i; });
      }
    });
  }
  for (int i = 0; i < 100; ++i) queue.carry_out(i * 1ms);
  for (std::thread& thread : threads) thread.join();
  queue.carry_out(1s);
  EXPECT_EQ(next, std::vector<int>(4, each));
  EXPECT_TRUE(in_order);
  EXPECT_EQ(queue.history().size(), 4u * each);
}

}  // namespace
}  // namespace murosimf
