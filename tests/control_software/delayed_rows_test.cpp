// Numbers over a link: the newest that have arrived, by the closed form of the link; late ones that were overtaken do not count.
#include <cmath>

#include "murosimf/control_software/delayed_rows.h"

#include <gtest/gtest.h>

namespace murosimf::control_software {
namespace {

using namespace std::chrono_literals;

std::vector<double> received(DelayedRows& rows, Duration now) {
  const std::vector<double>* const numbers = rows.receive(now);
  return numbers ? *numbers : std::vector<double>{};
}

TEST(DelayedRows, ArriveAfterTheDelay) {
  DelayedRows rows({.delay = 0.005}, 1, "a");
  rows.send(0ms, std::vector{1.0, 2.0});
  EXPECT_TRUE(received(rows, 4ms).empty());
  EXPECT_EQ(received(rows, 5ms), (std::vector{1.0, 2.0}));
  EXPECT_TRUE(received(rows, 6ms).empty()) << "once";
}

TEST(DelayedRows, OnlyTheNewestCounts) {
  DelayedRows rows({.delay = 0.005}, 1, "a");
  for (int i = 0; i < 4; ++i) rows.send(i * 1ms, std::vector{1.0 * i});
  EXPECT_EQ(received(rows, 7ms), std::vector{2.0});
  EXPECT_EQ(received(rows, 8ms), std::vector{3.0});
}

// 100 bytes/s and 16 bytes: 160 ms each, one after the other.
TEST(DelayedRows, TakeTheirTime) {
  DelayedRows rows({.bandwidth = 100}, 1, "a");
  rows.send(0ms, std::vector{1.0, 1.0});
  rows.send(10ms, std::vector{2.0, 2.0});
  EXPECT_TRUE(received(rows, 159ms).empty());
  EXPECT_EQ(received(rows, 160ms)[0], 1.0);
  EXPECT_TRUE(received(rows, 319ms).empty());
  EXPECT_EQ(received(rows, 320ms)[0], 2.0);
}

TEST(DelayedRows, NeverGoBackToWhatWasOvertaken) {
  DelayedRows rows({.jitter = 0.05}, 3, "a");
  double last = -1;
  for (int t = 0; t < 2000; ++t) {
    rows.send(t * 1ms, std::vector{1.0 * t});
    for (const double number : received(rows, t * 1ms)) {
      EXPECT_GT(number, last);
      last = number;
    }
  }
  EXPECT_GT(last, 1900);
}

// The second takes 1 ms, the first 100: it comes when it is no longer needed.
TEST(DelayedRows, AreCounted) {
  DelayedRows rows({.delay = 0.001, .jitter = 0.1}, 3, "a");
  std::uint64_t come = 0;
  for (int t = 0; t < 1000; ++t) {
    if (t < 500) rows.send(t * 1ms, std::vector{1.0 * t});
    come += received(rows, t * 1ms).empty() ? 0U : 1U;
  }
  EXPECT_EQ(rows.counts().sent, 500U);
  EXPECT_EQ(rows.counts().lost, 0U);
  EXPECT_GT(come, 10U);
  EXPECT_GT(rows.counts().overtaken, 100U);
  EXPECT_LE(come + rows.counts().overtaken, 500U) << "those that come at once with newer ones are neither";
  EXPECT_GT(rows.counts().longest, 95ms);
  EXPECT_LE(rows.counts().longest, 101ms);
}

TEST(DelayedRows, AreLostInTheirShare) {
  DelayedRows rows({.loss = 0.25}, 3, "a");
  int come = 0;
  for (int t = 0; t < 10'000; ++t) {
    rows.send(t * 1ms, std::vector{1.0 * t});
    come += received(rows, t * 1ms).empty() ? 0 : 1;
  }
  EXPECT_NEAR(come, 7500, 4 * std::sqrt(10'000 * 0.25 * 0.75));
  EXPECT_EQ(rows.counts().sent, 10'000U);
  EXPECT_EQ(rows.counts().lost, static_cast<std::uint64_t>(10'000 - come));
}

TEST(DelayedRows, GoOnFromTheirState) {
  const LinkOptions options{.delay = 0.01, .jitter = 0.02, .loss = 0.2};
  DelayedRows rows(options, 3, "a"), other(options, 3, "a");
  for (int t = 0; t < 50; ++t) rows.send(t * 1ms, std::vector{1.0 * t}), (void)rows.receive(t * 1ms);
  std::vector<std::byte> bytes;
  StateArchive save(bytes);
  rows.state(save);
  StateArchive load{std::span<const std::byte>(bytes)};
  other.state(load);
  for (int t = 50; t < 200; ++t) {
    rows.send(t * 1ms, std::vector{1.0 * t});
    other.send(t * 1ms, std::vector{1.0 * t});
    EXPECT_EQ(received(rows, t * 1ms), received(other, t * 1ms));
  }
}

}  // namespace
}  // namespace murosimf::control_software
