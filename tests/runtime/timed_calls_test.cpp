// Calls at simulated times: their order, what a reset does, and what a state knows of them.
#include "murosimf/runtime/timed_calls.h"

#include <string>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "murosimf/world/state_archive.h"

namespace murosimf {
namespace {

using namespace std::chrono_literals;

struct TimedCallsTest : testing::Test {
  void make_until(Duration time) {
    now = time;
    calls.make_due([this] { return now; }, [](const std::function<void()>& call) { call(); });
  }
  std::function<void()> note(std::string text) {
    return [this, text = std::move(text)] { made += text; };
  }

  TimedCalls calls;
  Duration now{};
  std::string made;
};

TEST_F(TimedCallsTest, TheEarliestFirstAndThoseOfOneTimeAsAskedFor) {
  calls.schedule(3ms, note("c"));
  calls.schedule(1ms, note("a"));
  calls.schedule(3ms, note("d"));
  calls.add_later(2ms, note("b"));
  calls.add_later(3ms, note("e"));
  make_until(0ms);
  EXPECT_EQ(made, "");
  make_until(1ms);
  EXPECT_EQ(made, "a");
  make_until(5ms);
  EXPECT_EQ(made, "abcde") << "the schedule comes before later calls of its time";
  make_until(9ms);
  EXPECT_EQ(made, "abcde") << "once";
}

TEST_F(TimedCallsTest, ACallMayAskForOthersAndGoToAnotherTime) {
  calls.add_later(1ms, [this] {
    made += "a";
    calls.add_later(2ms, note("b"));  // due at once
    calls.add_later(4ms, note("c"));
  });
  make_until(2ms);
  EXPECT_EQ(made, "ab");
  calls.add_later(3ms, [this] { now = 0ms; });
  make_until(5ms);
  EXPECT_EQ(made, "ab") << "time has gone back before the next one was due";
  make_until(4ms);
  EXPECT_EQ(made, "abc");
}

TEST_F(TimedCallsTest, AResetMakesTheScheduleAgainAndForgetsTheRest) {
  calls.schedule(1ms, note("a"));
  calls.add_later(2ms, note("b"));
  make_until(1ms);
  calls.go_back_to_start();
  make_until(5ms);
  EXPECT_EQ(made, "aa");
}

TEST_F(TimedCallsTest, AStateSaysHowFarTheScheduleHasCome) {
  calls.schedule(1ms, note("a"));
  calls.schedule(2ms, note("b"));
  make_until(1ms);
  std::vector<std::byte> bytes;
  StateArchive saving(bytes);
  calls.state(saving);
  make_until(5ms);
  calls.add_later(6ms, note("x"));
  StateArchive loading{std::span<const std::byte>(bytes)};
  calls.state(loading);
  EXPECT_EQ(loading.left(), 0U);
  make_until(9ms);
  EXPECT_EQ(made, "abbx") << "later calls are their caller's";

  TimedCalls others;
  others.schedule(1ms, note("y"));
  StateArchive again{std::span<const std::byte>(bytes)};
  EXPECT_THROW(others.state(again), SetupError);
}

TEST_F(TimedCallsTest, MoreCallsThanThereAreIsNoState) {
  calls.schedule(1ms, note("a"));
  std::size_t scheduled = 1, done = 2;
  std::vector<std::byte> bytes;
  StateArchive saving(bytes);
  saving(scheduled, done);
  StateArchive loading{std::span<const std::byte>(bytes)};
  EXPECT_THROW(calls.state(loading), SetupError);
}

}  // namespace
}  // namespace murosimf
