// The search for a walk: it gets better, what it writes is read again, and threads do not matter.
#include "murosimf/studies/walk_tuning.h"

#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/locomotion/gait_seed.h"
#include "murosimf/locomotion/walk_options.h"
#include "murosimf/model/error.h"
#include "murosimf/robot/robot_config.h"
#include "murosimf/studies/walk_trials.h"
#include "tests/temp_folder.h"

namespace murosimf::studies {
namespace {

WalkTuningOptions short_walks(int threads) {
  WalkTuningOptions options{.model = "kid21", .levels = {"kinematic_walking", "full_dynamics"}, .duration = 2};
  options.budget.evaluations = 46;
  options.common.threads = threads;
  return options;
}

TEST(WalkTuning, GetsBetterAndWritesTheBest) {
  const WalkTuning tuning = tune_walk(short_walks(2));
  EXPECT_EQ(tuning.search.evaluations, 28 + 16 + 1u) << "the walk itself, the grid, a generation and its middle";
  EXPECT_LT(tuning.search.best_cost, tuning.search.start_cost);
  EXPECT_EQ(tuning.checks.size(), 2u);
  const auto file = fixtures::temp_folder() / "tuned.toml";
  std::ofstream(file) << to_toml(tuning, "found by a test");
  const robot::RobotConfig table = robot::read_robot_config(file);
  EXPECT_EQ(table.walk.size(), 10u);
  for (const auto& [name, value] : table.walk)
    EXPECT_NEAR(std::get<double>(value), std::get<double>(tuning.after.at(name)), 1e-9) << name;
}

TEST(WalkTuning, BeginsWithTheWalkThatIsWorkedOut) {
  WalkTuningOptions options = short_walks(2);
  options.budget.evaluations = 1;
  const WalkTuning tuning = tune_walk(options);
  const VariedRobot robot("kid21", false);
  const OptionValues seed = locomotion::walk_option_values(locomotion::seeded_parameters(robot.model()));
  for (const auto& [name, value] : tuning.before)
    EXPECT_NEAR(std::get<double>(value), std::get<double>(seed.at(name)), 1e-5) << name;
}

TEST(WalkTrials, SeeFallsAndSpeeds) {
  const VariedRobot robot("kid21", false);
  const auto cases = tuning_cases({"kinematic_walking", "full_dynamics"}, 4, 1, "tuning");
  WalkTask task{.duration = 4, .threads = 2};
  task.commands.fill({0.1, 0, 0});
  const auto outcomes = walk_trials(robot, task, {{}, {{"setback", 0.12}}}, cases);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_FALSE(outcomes[0][i].fell);
    EXPECT_LT(outcomes[0][i].cost, 0.1) << "kinematic_walking goes where it is told to";
    EXPECT_TRUE(outcomes[1][4 + i].fell) << "its weight 12 cm before its feet";
    EXPECT_GT(outcomes[1][4 + i].cost, 1);
    EXPECT_LE(outcomes[1][4 + i].cost, 2);
  }
}

TEST(WalkTuning, ThreadsDoNotMatter) {
  WalkTuningOptions one = short_walks(1), three = short_walks(3);
  one.budget.evaluations = three.budget.evaluations = 1;  // the grid is tried in any case
  EXPECT_EQ(to_toml(tune_walk(one), ""), to_toml(tune_walk(three), ""));
}

TEST(WalkTuning, NamesWhatIsWrong) {
  EXPECT_THROW((void)tune_walk({.model = "car"}), SetupError);
  EXPECT_THROW((void)tune_walk({.model = "kid21", .levels = {"some_dynamics"}}), SetupError);
  EXPECT_THROW((void)tune_walk({.model = "kid21", .levels = {}}), SetupError);
  EXPECT_THROW((void)tune_walk({.model = "kid21", .speed = 0}), SetupError);
}

}  // namespace
}  // namespace murosimf::studies
