// What if: continuations of one moment.
#include "murosimf/studies/branches.h"

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "tests/recording/repeatable_run.h"

namespace murosimf {
namespace {

using namespace std::chrono_literals;
using studies::Branches;

TEST(Branches, FirstOneIsTheRunItself) {
  const recording::RecordedRun run(fixtures::record("whole.mcap", {.scene = "walk", .time = 2s}));
  const Branches result =
      studies::branch(run, {.time = 500ms,
                            .duration = 1500ms,
                            .changes = {"walker.command=[0,0,0]", "walker.command=[0.3,0,0];walker.command=[0,0,0]"},
                            .results = {"walker.distance"},
                            .repeat = {.threads = 2}});
  ASSERT_EQ(result.branches.size(), 3U);
  EXPECT_EQ(result.from, 500ms);
  EXPECT_EQ(result.to, 2s);
  EXPECT_EQ(result.branches[0].state_hash, run.states().all().back().hash);
  EXPECT_NE(result.branches[1].state_hash, result.branches[0].state_hash);
  EXPECT_LT(result.branches[1].values[0], result.branches[0].values[0]) << "a robot that stops does not come as far";
  EXPECT_EQ(result.branches[2].state_hash, result.branches[1].state_hash) << "the last change counts";
  EXPECT_NE(to_text(result).find("as it was"), std::string::npos);
}

TEST(Branches, RefusesWhatCannotBe) {
  const recording::RecordedRun run(fixtures::record("short.mcap", {.scene = "walk", .time = 1s}));
  EXPECT_THROW((void)studies::branch(run, {.time = 3s}), SetupError);
  EXPECT_THROW((void)studies::branch(run, {.duration = 1s, .changes = {"walker.levl=kinematic_walking"}}), SetupError);
  EXPECT_THROW((void)studies::branch(run, {.duration = 1s, .results = {"walker.speeed"}}), SetupError);
  EXPECT_THROW((void)studies::branch(run, {.duration = 0s, .changes = {"walker.command=[0,0,0]"}}), SetupError);
}

}  // namespace
}  // namespace murosimf
