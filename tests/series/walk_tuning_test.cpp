// The search for a walk: all of its trials are there, the best is first, and what it writes is read again.
#include "murosimf/series/walk_tuning.h"

#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/locomotion/gait_seed.h"
#include "murosimf/model/error.h"
#include "murosimf/robot/robot_config.h"
#include "tests/temp_folder.h"

namespace murosimf::series {
namespace {

WalkTuningOptions short_walks(int threads) {
  WalkTuningOptions options{.model = "kid21", .levels = {"kinematic_walking", "full_dynamics"}, .duration = 2};
  options.common.threads = threads;
  return options;
}

TEST(WalkTuning, SortsTrialsAndWritesTheBest) {
  const WalkTuning tuning = tune_walk(short_walks(2));
  ASSERT_EQ(tuning.trials.size(), 27u);
  for (std::size_t i = 1; i < tuning.trials.size(); ++i) {
    const WalkTrial &a = tuning.trials[i - 1], &b = tuning.trials[i];
    EXPECT_TRUE(a.failed < b.failed || (a.failed == b.failed && a.miss <= b.miss)) << i;
  }
  const WalkTrial& best = tuning.trials.front();
  EXPECT_EQ(best.failed, 0);
  ASSERT_EQ(best.forward.size(), 2u);
  const double miss = (std::abs(best.forward[0] / 0.2 - 1) + std::abs(best.sideways[0]) / 0.2 +
                       std::abs(best.forward[1] / 0.2 - 1) + std::abs(best.sideways[1]) / 0.2) /
                      2;
  EXPECT_NEAR(best.miss, miss, 1e-12);
  const auto file = fixtures::temp_folder() / "tuned.toml";
  std::ofstream(file) << to_toml(tuning);
  const robot::RobotConfig table = robot::read_robot_config(file);
  EXPECT_EQ(std::get<double>(table.walk.at("lift")), best.lift);
  EXPECT_EQ(std::get<double>(table.walk.at("hip_roll")), best.hip_roll);
  EXPECT_EQ(std::get<double>(table.walk.at("period")), best.period);
}

TEST(WalkTuning, ThreadsDoNotMatter) {
  EXPECT_EQ(to_text(tune_walk(short_walks(1))), to_text(tune_walk(short_walks(3))));
}

TEST(WalkTuning, NamesWhatIsWrong) {
  EXPECT_THROW((void)tune_walk({.model = "car"}), SetupError);
  EXPECT_THROW((void)tune_walk({.model = "kid21", .levels = {"some_dynamics"}}), SetupError);
  EXPECT_THROW((void)tune_walk({.model = "kid21", .levels = {}}), SetupError);
  EXPECT_THROW((void)tune_walk({.model = "kid21", .speed = 0}), SetupError);
}

}  // namespace
}  // namespace murosimf::series
