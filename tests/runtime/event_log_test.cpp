// Events and warnings go back in time with the state.
#include "murosimf/runtime/event_log.h"

#include <array>

#include <gtest/gtest.h>

#include "murosimf/math/assert.h"
#include "murosimf/world/state_archive.h"

namespace murosimf {
namespace {

using namespace std::chrono_literals;

TEST(EventLog, WhatIsBeforeTheStartStays) {
  EventLog log;
  log.record(0ms, "built");
  log.keep_start();
  log.record(2ms, "fell");
  log.warn("frozen");
  log.go_back_to_start();
  ASSERT_EQ(log.events().size(), 1U);
  EXPECT_EQ(log.events()[0].text, "built");
  EXPECT_TRUE(log.warnings().empty());
}

TEST(EventLog, IsSavedAndLoaded) {
  EventLog log, other;
  log.record(1ms, "one");
  log.record(1ms, "two");
  log.warn("careful");
  std::vector<std::byte> bytes;
  StateArchive saving(bytes);
  log.state(saving);
  other.record(7ms, "something else");
  StateArchive loading{std::span<const std::byte>(bytes)};
  other.state(loading);
  ASSERT_EQ(other.events().size(), 2U);
  EXPECT_EQ(other.events()[1].text, "two");
  EXPECT_EQ(other.events()[1].time, Duration(1ms));
  EXPECT_EQ(other.warnings(), log.warnings());
}

TEST(EventLog, IsGivenAPast) {
  EventLog log;
  log.record(9ms, "yet to come");
  const std::array events{Event{1ms, "one"}};
  log.assign(events, {});
  log.record(2ms, "two");
  ASSERT_EQ(log.events().size(), 2U);
  EXPECT_EQ(log.events()[0].text, "one");
}

TEST(EventLogDeathTest, TimeDoesNotRunBackwards) {
  if constexpr (assertions_checked) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EventLog log;
    log.record(2ms, "two");
    EXPECT_DEATH(log.record(1ms, "one"), "events_.back");
  }
}

}  // namespace
}  // namespace murosimf
