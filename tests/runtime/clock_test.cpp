// Pacing against a wall clock that the test owns.
#include "murosimf/runtime/clock.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

#include "murosimf/model/error.h"

namespace murosimf {
namespace {

using namespace std::chrono_literals;

/// A wall clock that advances only by explicit calls, or by sleeping.
class FakeTime final : public WallTime {
 public:
  explicit FakeTime(Duration& now) : now_(now) {}
  Duration now() override { return now_; }
  void sleep_until(Duration time) override { now_ = time; }

 private:
  Duration& now_;
};

struct Paced {
  explicit Paced(std::optional<double> speed) : clock(speed, std::make_unique<FakeTime>(wall)) { clock.start(0ms); }
  Duration wall{5s};
  Clock clock;
};

TEST(Clock, RealTimeEndsEveryStepWhenItIsDue) {
  Paced p(1.0);
  for (int i = 1; i <= 100; ++i) {
    p.wall += 300us;  // the step's own work
    p.clock.wait_until(i * 1ms);
    EXPECT_EQ(p.wall, 5s + i * 1ms);
  }
  EXPECT_EQ(p.clock.lateness().late_steps, 0);
}

TEST(Clock, SpeedStretchesTheSchedule) {
  Paced slow(0.5);
  slow.clock.wait_until(10ms);
  EXPECT_EQ(slow.wall, 5s + 20ms);
  Paced fast(4.0);
  fast.clock.wait_until(10ms);
  EXPECT_EQ(fast.wall, 5s + 2500us);
}

TEST(Clock, AsFastAsPossibleNeverWaits) {
  Paced p(std::nullopt);
  p.clock.wait_until(10s);
  EXPECT_EQ(p.wall, 5s);
}

TEST(Clock, LateStepsAreCountedAndMeasured) {
  Paced p(1.0);
  p.wall += 9ms;  // the first step took 9 ms
  p.clock.wait_until(1ms);
  EXPECT_EQ(p.wall, 5s + 9ms);
  EXPECT_EQ(p.clock.lateness().late_steps, 1);
  EXPECT_EQ(p.clock.lateness().worst, 8ms);
  for (int i = 2; i <= 20; ++i) p.clock.wait_until(i * 1ms);  // quick steps catch up
  EXPECT_EQ(p.wall, 5s + 20ms);
}

TEST(Clock, LongDelaysMoveTheScheduleInsteadOfRacing) {
  Paced p(1.0);
  p.wall += 2s;  // the machine slept
  p.clock.wait_until(1ms);
  p.clock.wait_until(2ms);
  EXPECT_EQ(p.wall, 7s + 1ms);
  EXPECT_EQ(p.clock.lateness().late_steps, 1);
}

// Ten seconds in which every tenth step takes 3 ms too long: told after the first second, and then after 2 and 4 more.
TEST(Clock, TellsOfOverrunsWhileItRunsMoreAndMoreRarely) {
  Paced p(1.0);
  std::vector<Overrun> told;
  p.clock.publish_overruns([&](const Overrun& overrun) { told.push_back(overrun); });
  for (int i = 1; i <= 10000; ++i) {
    if (i % 10 == 0) p.wall += 4ms;
    p.clock.wait_until(i * 1ms);
  }
  ASSERT_EQ(told.size(), 3U);
  EXPECT_EQ(told[0].simulated, 1s);
  EXPECT_EQ(told[1].simulated, 3s);
  EXPECT_EQ(told[2].simulated, 7s);
  std::int64_t steps = 0;
  for (const Overrun& overrun : told) {
    EXPECT_EQ(overrun.lateness.late_steps, overrun.lateness.steps / 10);
    EXPECT_EQ(overrun.lateness.worst, 3ms);
    steps += overrun.lateness.steps;
  }
  EXPECT_EQ(steps, 7000) << "each step is told of once";
  EXPECT_EQ(p.clock.lateness().late_steps, 1000);
}

TEST(Clock, SaysNothingWhileNobodyIsLate) {
  Paced p(1.0);
  bool told = false;
  p.clock.publish_overruns([&](const Overrun&) { told = true; });
  for (int i = 1; i <= 5000; ++i) p.clock.wait_until(i * 1ms);
  EXPECT_FALSE(told);
}

// A step that takes a thousand seconds of wall time ends soon after a request to stop.
TEST(Clock, StopsWaitingWhenAsked) {
  Paced p(1e-6);
  p.clock.wait_until(1ms, [&] { return p.wall >= 7s; });
  EXPECT_GE(p.wall, 7s);
  EXPECT_LE(p.wall, 7s + 20ms);
}

TEST(Clock, ImpossibleSpeedsAreRefused) {
  for (const double speed :
       {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(Clock{speed}, SetupError) << speed;
  }
}

}  // namespace
}  // namespace murosimf
