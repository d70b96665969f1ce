// The search for a walk with feedback: trials see pushes and falls, what it writes is read again, and threads do not matter.
#include "murosimf/studies/balance_tuning.h"

#include <fstream>
#include <numeric>

#include <gtest/gtest.h>

#include "murosimf/locomotion/gait_feedback.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/model/error.h"
#include "murosimf/robot/robot_config.h"
#include "murosimf/robot/step_table_file.h"
#include "murosimf/studies/balance_trials.h"
#include "murosimf/studies/tuned_numbers.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::studies {
namespace {

std::size_t stood(const VariedRobot& robot, double impulse, const OptionValues& numbers = {}) {
  const auto cases = tuning_cases({"full_dynamics"}, 1, 1, "tuning");
  const BalanceTask task{.impulse = impulse, .duration = 5, .learning = {2.5, 1}, .threads = 2};
  const std::vector<BalanceOutcome> outcomes = balance_trials(robot, task, {numbers}, cases);
  EXPECT_EQ(outcomes.size(), 1u);
  return std::accumulate(outcomes[0].stood.begin(), outcomes[0].stood.end(), std::size_t{0});
}

TEST(BalanceTrials, SeePushesAndFeedback) {
  const VariedRobot robot("kid21", false);
  EXPECT_EQ(stood(robot, 0.1), 12u) << "nothing falls by a breeze";
  EXPECT_EQ(stood(robot, 30), 4u) << "those that are not pushed stand, no other one";
  // without steps, ankles and timing, pushes that the feedback answers make it fall
  const OptionValues none{{"step_forward", 0.0},   {"step_sideways", 0.0},  {"ankle_forward", 0.0},
                          {"ankle_sideways", 0.0}, {"timing_forward", 0.0}, {"timing_sideways", 0.0}};
  EXPECT_LT(stood(robot, 2.5, none), stood(robot, 2.5));
}

TEST(BalanceTrials, RefuseAGaitThatFallsBeforeItIsPushed) {
  const VariedRobot robot("kid21", false);
  const auto cases = tuning_cases({"full_dynamics"}, 1, 1, "tuning");
  const BalanceOutcome outcome = balance_trials(robot, {.threads = 2}, {{{"setback", 0.12}}}, cases).at(0);
  EXPECT_GT(outcome.costs.at(0), 2);
  EXPECT_LE(outcome.costs.at(0), 3);
  EXPECT_EQ(outcome.stood.at(0), 0u);
}

BalanceTuningOptions short_search(int threads) {
  BalanceTuningOptions options{.model = "kid21",
                               .levels = {"simplified_dynamics"},
                               .impulse = 3,
                               .duration = 4.5,
                               .learning = {2.5, 1},
                               .cases = 1,
                               .checks = 1};
  options.budget.evaluations = 18;
  options.common.threads = threads;
  return options;
}

TEST(BalanceTuning, WritesWhatItHasFound) {
  const BalanceTuning tuning = tune_balance(short_search(2));
  EXPECT_EQ(tuning.search.evaluations, 1 + 16 + 1u) << "the robot's own, a generation and its middle";
  EXPECT_LE(tuning.search.best_cost, tuning.search.start_cost);
  EXPECT_EQ(tuning.checks.size(), 1u);
  EXPECT_EQ(tuning.checks.at(0).runs, 12u);
  EXPECT_EQ(tuning.before.size(), 10 + locomotion::feedback_options().size());
  const auto folder = fixtures::temp_folder();
  ASSERT_TRUE(tuning.steps);
  std::ofstream(folder / "tuned_steps.csv") << robot::to_csv(*tuning.steps);
  std::ofstream(folder / "tuned.toml") << to_toml(tuning, "found by a test", "tuned_steps.csv");
  const robot::RobotConfig table = robot::read_robot_config(folder / "tuned.toml");
  ASSERT_TRUE(table.steps);
  for (const auto& [name, value] : tuning.after)
    EXPECT_NEAR(std::get<double>(table.balance.at(name)), std::get<double>(value),
                1e-4 * std::abs(std::get<double>(value)))
        << name;
  EXPECT_EQ(std::get<double>(table.balance.at("speed")), 0.45) << "what is not searched stays";
}

TEST(BalanceTuning, ThreadsDoNotMatter) {
  BalanceTuningOptions one = short_search(1), two = short_search(2);
  one.budget.evaluations = two.budget.evaluations = 1;
  EXPECT_EQ(to_toml(tune_balance(one), "", "s.csv"), to_toml(tune_balance(two), "", "s.csv"));
}

TEST(BalanceTuning, BeginsWithTheNumbersOfTheRobot) {
  const VariedRobot robot("kid21", false);
  const OptionValues& own = *robot.model().find(properties::given_balance, 0);
  for (const TunedNumber& number : walk_numbers(robot.model(), own)) {
    EXPECT_NEAR(number.value, number_in(own, number.name), 1e-12) << number.name;
    EXPECT_LT(number.low, number.high) << number.name;
  }
  for (const TunedNumber& number : feedback_numbers(robot.model())) {
    EXPECT_LE(number.low, number.value) << number.name;
    EXPECT_GE(number.high, number.value) << number.name;
    EXPECT_LT(number.low, number.high) << number.name;
  }
}

TEST(BalanceTuning, NamesWhatIsWrong) {
  EXPECT_THROW((void)tune_balance({.model = "car"}), SetupError);
  EXPECT_THROW((void)tune_balance({.model = "kid21", .speed = 0}), SetupError);
  EXPECT_THROW((void)tune_balance({.model = "kid21", .impulse = -1}), SetupError);
  EXPECT_THROW((void)tune_balance({.model = "kid21", .duration = 3}), SetupError);
  EXPECT_TRUE(fixtures::says(fixtures::error_of(
                                 [] { (void)tune_balance({.model = "kid21", .levels = {"kinematic_walking"}}); }),
                             {"kinematic_walking", "pushes move nothing"}));
}

}  // namespace
}  // namespace murosimf::studies
