// The model of a link against closed forms: a queue with constant service, the mean and range of uniform jitter, a share of losses.
#include "murosimf/control_software/link_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/fixtures.h"

namespace murosimf::control_software {
namespace {

using namespace std::chrono_literals;

std::vector<std::optional<Duration>> arrivals(LinkModel& link, int count, Duration period, std::size_t bytes = 100) {
  std::vector<std::optional<Duration>> all;
  for (int i = 0; i < count; ++i) all.push_back(link.arrival(i * period, bytes));
  return all;
}

TEST(LinkModel, DoesNothingByItself) {
  LinkModel link({}, 1, "any");
  EXPECT_EQ(link.arrival(0ms, 1000), Duration(0ms));
  EXPECT_EQ(link.arrival(3ms, 1'000'000), Duration(3ms));
}

TEST(LinkModel, SendsOneByteAfterTheOther) {
  LinkModel link({.delay = 0.01, .bandwidth = 1000}, 1, "any");
  EXPECT_EQ(link.arrival(0ms, 200), Duration(210ms));
  EXPECT_EQ(link.arrival(50ms, 100), Duration(310ms));  // waits until 200 ms
  EXPECT_EQ(link.arrival(50ms, 100), Duration(410ms));
  EXPECT_EQ(link.arrival(1000ms, 100), Duration(1110ms));  // no message is before it any more
}

TEST(LinkModel, LosesWhatWouldWaitTooLong) {
  LinkModel link({.bandwidth = 1000, .longest_queue = 0.25}, 1, "any");
  EXPECT_EQ(link.arrival(0ms, 100), Duration(100ms));
  EXPECT_EQ(link.arrival(0ms, 200), Duration(300ms));
  EXPECT_EQ(link.arrival(0ms, 100), std::nullopt);      // would wait 300 ms
  EXPECT_EQ(link.arrival(50ms, 100), Duration(400ms));  // 250 ms; the lost one takes no time
}

TEST(LinkModel, HasUniformJitter) {
  LinkModel link({.delay = 0.02, .jitter = 0.01}, 7, "any");
  double sum = 0, squares = 0;
  constexpr int count = 20'000;
  for (int i = 0; i < count; ++i) {
    const Duration sent = i * 1ms;
    const double late = seconds(*link.arrival(sent, 10) - sent) - 0.02;
    EXPECT_GE(late, -1e-9);
    EXPECT_LT(late, 0.01 + 1e-9);
    sum += late;
    squares += late * late;
  }
  const double mean = sum / count, variance = squares / count - mean * mean;
  EXPECT_NEAR(mean, 0.005, 4 * 0.01 / std::sqrt(12.0 * count));  // four deviations of the mean
  EXPECT_NEAR(variance, 0.0001 / 12, 0.03 * 0.0001 / 12);
}

TEST(LinkModel, LosesItsShare) {
  LinkModel link({.loss = 0.2}, 3, "any");
  int lost = 0;
  constexpr int count = 20'000;
  for (const auto& arrival : arrivals(link, count, 1ms)) lost += arrival ? 0 : 1;
  EXPECT_NEAR(lost, 0.2 * count, 4 * std::sqrt(0.2 * 0.8 * count));
  LinkModel none({.loss = 1}, 3, "any");
  EXPECT_EQ(none.arrival(0ms, 1), std::nullopt);
}

TEST(LinkModel, KeepsTheOrderOfAStreamOnly) {
  LinkModel radio({.jitter = 0.1}, 5, "any"), stream({.jitter = 0.1, .in_order = true}, 5, "any");
  const auto loose = arrivals(radio, 200, 1ms), tight = arrivals(stream, 200, 1ms);
  EXPECT_FALSE(std::ranges::is_sorted(loose));
  EXPECT_TRUE(std::ranges::is_sorted(tight));
  Duration latest{};
  for (std::size_t i = 0; i < loose.size(); ++i) {
    latest = std::max(latest, *loose[i]);
    EXPECT_EQ(tight[i], latest);
  }
}

TEST(LinkModel, HangsOnSeedAndNameAlone) {
  const LinkOptions options{.jitter = 0.1, .loss = 0.3};
  LinkModel link(options, 1, "a"), same(options, 1, "a"), other_name(options, 1, "b"), other_seed(options, 2, "a");
  const auto first = arrivals(link, 50, 1ms);
  EXPECT_EQ(arrivals(same, 50, 1ms), first);
  EXPECT_NE(arrivals(other_name, 50, 1ms), first);
  EXPECT_NE(arrivals(other_seed, 50, 1ms), first);
  link.restart();
  EXPECT_EQ(arrivals(link, 50, 1ms), first);
  other_seed.reseed(1);
  other_seed.restart();
  EXPECT_EQ(arrivals(other_seed, 50, 1ms), first);
}

TEST(LinkModel, GoesOnFromItsState) {
  const LinkOptions options{.delay = 0.01, .jitter = 0.1, .bandwidth = 50'000, .loss = 0.3, .in_order = true};
  LinkModel link(options, 1, "a"), other(options, 1, "a");
  (void)arrivals(link, 20, 1ms);
  std::vector<std::byte> bytes;
  StateArchive save(bytes);
  link.state(save);
  StateArchive load{std::span<const std::byte>(bytes)};
  other.state(load);
  for (int i = 20; i < 60; ++i) EXPECT_EQ(other.arrival(i * 1ms, 100), link.arrival(i * 1ms, 100)) << i;
}

TEST(LinkModel, RefusesWhatNoLinkCanBe) {
  const double nan = std::nan("");
  const std::pair<LinkOptions, const char*> wrong[] = {{{.delay = -1}, "the delay of a link is -1"},
                                                       {{.jitter = nan}, "the jitter of a link is nan"},
                                                       {{.bandwidth = -1}, "the bandwidth of a link is -1"},
                                                       {{.bandwidth = 0.5}, "below 1 byte/s"},
                                                       {{.loss = 1.5}, "the loss of a link is 1.5"},
                                                       {{.loss = nan}, "the loss of a link is nan"},
                                                       {{.longest_queue = -1}, "the longest queue of a link is -1"}};
  for (const auto& [options, message] : wrong) {
    EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { LinkModel(options, 1, "a"); }), {message}));
  }
}

}  // namespace
}  // namespace murosimf::control_software
