// Learning how a steady walk looks: what is learned fits what is walked, and threads do not matter.
#include "murosimf/studies/step_learning.h"

#include <gtest/gtest.h>

#include "murosimf/robot/step_table_file.h"
#include "tests/fixtures.h"

namespace murosimf::studies {
namespace {

StepLearning learned(int threads, const std::string& model = "kid21") {
  StepLearningOptions options{.model = model, .rigid = {"full_dynamics"}, .duration = 3, .rounds = 2};
  options.common.threads = threads;
  return learn_steps(options);
}

TEST(StepLearning, FitsWhatIsWalked) {
  const StepLearning learning = learned(2);
  ASSERT_EQ(learning.rounds.size(), 2U);
  for (const StepLearning::Round& round : learning.rounds) {
    EXPECT_EQ(round.walks, 22U) << "eleven commands at two levels";
    EXPECT_EQ(round.fell, 0U);
    EXPECT_GT(round.samples, 1500U) << "a second at 100 Hz of each, less what begins late";
    // xi swings by some 50 mm from side to side; a table that explains nothing would be off by that
    EXPECT_LT(round.error, 0.02);
  }
  EXPECT_FALSE(learning.stopped);
}

TEST(StepLearning, ThreadsDoNotMatter) { EXPECT_EQ(robot::to_csv(learned(1).table), robot::to_csv(learned(2).table)); }

TEST(StepLearning, RefusesWhatCannotWalk) {
  EXPECT_TRUE(fixtures::says(fixtures::error_of([] { (void)learned(1, "car"); }), {"soles"}));
  EXPECT_TRUE(fixtures::says(fixtures::error_of([] { (void)learn_steps({.model = "kid21", .duration = 2}); }),
                             {"more than 2 s"}));
}

}  // namespace
}  // namespace murosimf::studies
