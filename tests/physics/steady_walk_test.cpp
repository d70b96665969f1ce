// What a walk must survive: other friction, other servos, pushes.
#include <gtest/gtest.h>

#include "tests/physics/servo_variants.h"
#include "tests/physics/walk.h"

namespace murosimf::test {
namespace {

/// Walks 20 s at 0.2 m/s: it must not fall, and neither stay where it is.
void expect_no_fall(const std::string& what, WalkTask task) {
  task.command = {0.2, 0, 0};
  task.seconds = 20;
  const Walk result = walk(task);
  EXPECT_GT(result.moved.x, 0.5 * 0.2 * task.seconds) << what;
  law::expect_below({.law = "walk forward with 0.2 m/s, " + what + ": largest lean of the pelvis in 20 s",
                     .level = task.dynamics.level,
                     .source = "it does not fall"},
                    result.lean, 20, "deg");
}

class SteadyWalk : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Levels, SteadyWalk, testing::ValuesIn(dynamic_levels()), level_name);

TEST_P(SteadyWalk, OnOtherFriction) {
  for (const double friction : {0.5, 0.8, 1.0}) {
    expect_no_fall(fmt::format("friction {}", friction), {.dynamics = {.level = GetParam()}, .friction = friction});
  }
}

TEST_P(SteadyWalk, WithPushes) {
  expect_no_fall("random pushes of 1 N rms every 10 ms", {.dynamics = {.level = GetParam()}, .push = 1});
}

TEST(Servos, SteadyWalkWithOtherGains) {
  for (const double factor : {0.6, 0.8, 1.3}) {
    expect_no_fall(fmt::format("servo gain times {}", factor),
                   {.dynamics = {.level = "articulated_dynamics"}, .model = kid21_with("position_gain", factor)});
  }
}

}  // namespace
}  // namespace murosimf::test
