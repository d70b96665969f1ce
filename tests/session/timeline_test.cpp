#include "murosimf/session/timeline.h"

#include <gtest/gtest.h>

#include "murosimf/model/error.h"

namespace murosimf::session {
namespace {

using namespace std::chrono_literals;

/// A state of so many bytes that says when it was.
Timeline::State state_of(Duration time, std::size_t bytes = 8) {
  Timeline::State state(bytes);
  state[0] = static_cast<std::byte>(time / 100ms);
  return state;
}

void go_on(Timeline& timeline, Duration from, Duration to) {
  for (Duration now = from + 100ms; now <= to; now += 100ms) {
    timeline.advance(now);
    if (timeline.wants_state(now)) timeline.keep(now, state_of(now));
  }
}

std::vector<std::string> texts(const std::vector<Command>& commands) {
  std::vector<std::string> all;
  for (const Command& command : commands) all.push_back(command.text);
  return all;
}

TEST(Timeline, GoesToTheNearestStateAndSaysWhatCameThen) {
  Timeline timeline({.period = 500ms});
  timeline.begin(0ms, state_of(0ms));
  go_on(timeline, 0ms, 700ms);
  timeline.note(std::vector<Command>{{700ms, "a"}});
  go_on(timeline, 700ms, 1300ms);
  timeline.note(std::vector<Command>{{1300ms, "b"}});
  go_on(timeline, 1300ms, 2000ms);
  const Timeline::Way way = timeline.way_to(0, 1400ms);
  EXPECT_EQ(way.from, 1000ms);
  EXPECT_EQ((*way.state)[0], std::byte{10});
  EXPECT_EQ(texts(way.before), std::vector<std::string>{"a"});
  EXPECT_EQ(texts(way.then), std::vector<std::string>{"b"});
  // a state is that before the commands of its instant
  EXPECT_EQ(texts(timeline.way_to(0, 1300ms).then), std::vector<std::string>{});
}

TEST(Timeline, LooksBackWithoutABranchAndBranchesWhereItGoesOn) {
  Timeline timeline({.period = 500ms});
  timeline.begin(0ms, state_of(0ms));
  go_on(timeline, 0ms, 2000ms);
  timeline.go_back(0, 700ms);
  EXPECT_EQ(timeline.branches().size(), 1U);
  timeline.note(std::vector<Command>{{700ms, "other"}});
  go_on(timeline, 700ms, 1500ms);
  const auto branches = timeline.branches();
  ASSERT_EQ(branches.size(), 2U);
  EXPECT_EQ(branches[0].end, 2000ms);
  EXPECT_EQ(branches[1].parent, 0);
  EXPECT_EQ(branches[1].begin, 700ms);
  EXPECT_EQ(branches[1].end, 1500ms);
  EXPECT_EQ(timeline.present(), 1);
  // before its first own state the branch begins with one of its parent, which has come before they parted
  EXPECT_EQ(timeline.way_to(1, 1100ms).from, 500ms);
  EXPECT_EQ(texts(timeline.way_to(1, 1100ms).then), std::vector<std::string>{"other"});
  EXPECT_EQ(texts(timeline.way_to(0, 1100ms).then), std::vector<std::string>{});
  EXPECT_EQ(timeline.way_to(0, 1900ms).from, 1500ms);
  EXPECT_EQ(timeline.first(), 0ms);
}

TEST(Timeline, GoesOnAtItsEndWithoutABranchAndForgetsWhatWasDoneThere) {
  Timeline timeline({.period = 500ms});
  timeline.begin(0ms, state_of(0ms));
  go_on(timeline, 0ms, 1000ms);
  timeline.note(std::vector<Command>{{1000ms, "dragged"}});
  timeline.go_back(0, 1000ms);  // as it was before that
  go_on(timeline, 1000ms, 1500ms);
  EXPECT_EQ(timeline.branches().size(), 1U);
  EXPECT_EQ(texts(timeline.branches()[0].commands), std::vector<std::string>{});
}

TEST(Timeline, KeepsManyStatesOfTheLastSecondsAndFewOfLongAgo) {
  Timeline timeline({.period = 100ms, .most_bytes = 100 * 8});
  timeline.begin(0ms, state_of(0ms));
  go_on(timeline, 0ms, 600s);
  EXPECT_LE(timeline.bytes(), 100U * 8U);
  const auto states = timeline.branches()[0].states;
  ASSERT_GT(states.size(), 90U);
  EXPECT_EQ(states.front(), 0ms);
  EXPECT_EQ(states.back(), 600s);
  EXPECT_LE(states[states.size() - 1] - states[states.size() - 2], 300ms);
  for (std::size_t i = 1; i < states.size(); ++i) {  // gaps are in proportion to their age
    EXPECT_LT(seconds(states[i] - states[i - 1]), 0.3 + 0.3 * seconds(600s - states[i - 1])) << i;
  }
}

TEST(Timeline, ForgetsTheOldestOfManyStarts) {
  Timeline timeline({.period = 100ms, .most_branches = 5});
  for (int start = 0; start < 20; ++start) {
    timeline.begin(0ms, state_of(0ms));
    go_on(timeline, 0ms, 500ms);
  }
  EXPECT_EQ(timeline.branches().size(), 5U);
  EXPECT_EQ(timeline.branches().front().number, 15);
  EXPECT_EQ(timeline.bytes(), 5U * 5U * 8U);
  EXPECT_THROW((void)timeline.way_to(3, 200ms), SetupError);
  EXPECT_EQ(timeline.way_to(19, 200ms).from, 200ms);
}

TEST(Timeline, RefusesBranchesAndTimesThatThereAreNot) {
  Timeline timeline({});
  timeline.begin(1s, state_of(0ms));
  go_on(timeline, 1s, 2s);
  EXPECT_THROW((void)timeline.way_to(1, 1s), SetupError);
  EXPECT_THROW((void)timeline.way_to(-1, 1s), SetupError);
  EXPECT_THROW((void)timeline.way_to(0, 3s), SetupError);
  EXPECT_THROW((void)timeline.way_to(0, 500ms), SetupError);
}

}  // namespace
}  // namespace murosimf::session
