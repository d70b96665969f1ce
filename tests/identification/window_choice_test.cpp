#include "murosimf/identification/window_choice.h"

#include <gtest/gtest.h>

namespace murosimf::identification {
namespace {

std::size_t choice(const std::vector<double>& whole, const std::vector<double>& half, const std::vector<double>& most,
                   std::size_t usual = 0) {
  const std::vector<WindowTrial> trials{{0, whole}, {0.5, half}, {0.8, most}};
  return best_trial(trials, usual);
}

// Rule: of the shares that predict clearly better than the usual one, the best; their order has no effect.
TEST(WindowChoice, TakesTheBestOfWhatIsClearlyBetter) {
  EXPECT_EQ(choice({0.09, 0.10, 0.11, 0.12}, {0.06, 0.07, 0.08, 0.10}, {0.04, 0.06, 0.05, 0.08}), 2U);
  EXPECT_EQ(choice({0.09, 0.10, 0.11, 0.12}, {0.04, 0.06, 0.05, 0.08}, {0.06, 0.07, 0.08, 0.10}), 1U);
  EXPECT_EQ(choice({0.04, 0.06, 0.05, 0.08}, {0.06, 0.07, 0.08, 0.10}, {0.09, 0.10, 0.11, 0.12}, 2), 0U);
}

// Rule: the result of a single log is chance. Differences 80, -10, -10 and 0 mrad: mean 15, standard error 21.8.
TEST(WindowChoice, StaysWithTheUsualShareWhereTheDifferenceMayBeChance) {
  EXPECT_EQ(choice({0.17, 0.05, 0.06, 0.07}, {0.09, 0.06, 0.07, 0.07}, {0.18, 0.06, 0.06, 0.07}), 0U);
  EXPECT_EQ(choice({0.09, 0.06, 0.07, 0.07}, {0.18, 0.06, 0.06, 0.07}, {0.17, 0.05, 0.06, 0.07}, 2), 2U);
}

// Law: two standard errors. Differences of mean m and of deviations +d and -d in equal numbers, four in all: the standard
// error is d/sqrt(3), so m = 1.15 d is chance (2/sqrt(3) = 1.1547) and m = 1.16 d is not.
TEST(WindowChoice, TheBorderIsTwoStandardErrors) {
  const std::vector<double> whole{0.5, 0.5, 0.5, 0.5};
  const auto better_by = [](double mean) {
    return std::vector<double>{0.5 - mean - 0.1, 0.5 - mean + 0.1, 0.5 - mean - 0.1, 0.5 - mean + 0.1};
  };
  EXPECT_EQ(choice(whole, whole, better_by(0.115)), 0U);
  EXPECT_EQ(choice(whole, whole, better_by(0.116)), 2U);
}

// Rule: one log gives no standard error, and the same errors are no gain.
TEST(WindowChoice, NeedsLogsToTell) {
  EXPECT_EQ(choice({0.1}, {0.05}, {0.01}), 0U);
  EXPECT_EQ(choice({0.1, 0.2}, {0.1, 0.2}, {0.1, 0.2}), 0U);
}

// Rule: models in which friction follows the load have windows, Coulomb's and Stribeck's have not.
TEST(WindowChoice, TheUsualShareFollowsTheModel) {
  for (const char* model : {"m1", "m2"}) EXPECT_EQ(usual_window_share(friction_model(model)), 0) << model;
  for (const char* model : {"m3", "m4", "m5", "m6"}) EXPECT_EQ(usual_window_share(friction_model(model)), 0.8) << model;
}

}  // namespace
}  // namespace murosimf::identification
