#include <cmath>

#include <gtest/gtest.h>

#include "murosimf/identification/folds.h"
#include "murosimf/identification/search.h"
#include "murosimf/model/error.h"
#include "tests/fixtures.h"
#include "tests/identification/synthetic.h"
#include "tests/law.h"
#include "tests/sanitizer.h"

namespace murosimf::identification {
namespace {

using fixtures::same_bits;
using synthetic::record;

const multibody::BenchServo m1_servo{.torque_constant = 0.40,
                                     .resistance = 3.6,
                                     .rotor_inertia = 0.0025,
                                     .encoder_offset = 0.03,
                                     .friction = {.coulomb = 0.02, .viscous = 0.01}};
const multibody::BenchServo m3_servo{
    .torque_constant = 0.36,
    .resistance = 3.0,
    .rotor_inertia = 0.002,
    .encoder_offset = -0.03,
    .friction = {.coulomb = 0.012, .viscous = 0.006, .motor_load = 0.2, .external_load = 0.2}};

/// Skips where there is no search.
class Fit : public testing::Test {
 protected:
  void SetUp() override {
    try {
      check_search();
    } catch (const SetupError& error) {
      GTEST_SKIP() << error.what();
    }
  }
};

/// Thousands of evaluations; the short fits run the same code under the sanitizers.
class LongFit : public Fit {
 protected:
  void SetUp() override {
    if (fixtures::sanitized) GTEST_SKIP() << "takes half a minute with the address sanitizer";
    Fit::SetUp();
  }
};

const ObjectiveOptions of_xl330{.duty_per_gain = synthetic::duty_per_gain, .window_share = 0.2};
const Prior nothing;

std::vector<ServoLog> recordings(const multibody::BenchServo& servo) {
  return {record(servo, synthetic::drops(), {.gain = 400}), record(servo, synthetic::two_sines(), {.gain = 200}),
          record(servo, synthetic::chirp(), {.gain = 100, .duration = 4})};
}

void expect_recovered(const char* model, const multibody::BenchServo& servo, const multibody::BenchServo& found) {
  for (const Parameter* parameter : friction_model(model).parameters) {
    const double right = parameter->get(servo);
    law::expect_below({"fit to recordings of a servo with known numbers: relative error of " +
                           std::string(parameter->name),
                       std::string("friction ") + model, "the numbers that made them"},
                      std::fabs(parameter->get(found) / right - 1), 0.05, "");
  }
}

Found fit(const char* model, const std::vector<ServoLog>& logs, const SearchOptions& options) {
  return search(Objective(friction_model(model), nothing, logs, of_xl330), options);
}

/// As fit-servo does: the search in steps of 2.5 ms, its end in those of a replay.
Found fit_finely(const char* model, const std::vector<ServoLog>& logs, const SearchOptions& options) {
  ObjectiveOptions finer = of_xl330;
  finer.step = 1e-3;
  return refine(fit(model, logs, options), Objective(friction_model(model), nothing, logs, finer), 600);
}

// Law: recordings with torque off and both directions in them determine all numbers. Without prior, from a neutral
// point. Tolerance: the requirement.
TEST_F(LongFit, FindsTheNumbersOfACoulombServo) {
  expect_recovered("m1", m1_servo, fit_finely("m1", recordings(m1_servo), {.starts = 1, .evaluations = 2000}).servo);
}
TEST_F(LongFit, FindsTheNumbersOfALoadDependentServo) {
  expect_recovered("m3", m3_servo, fit_finely("m3", recordings(m3_servo), {.starts = 1, .evaluations = 2500}).servo);
}

/// [rad] error of `servo` on one recording.
double error_on(const ServoLog& log, const multibody::BenchServo& servo) {
  BenchLogs bench({whole(log)}, synthetic::duty_per_gain, 1e-3);
  std::vector<double> error(1);
  bench.errors(servo, error);
  return error[0];
}

// Law: with a prior near the truth, a fit to two sines and to up and down predicts a chirp, and drops with the torque off,
// which were left out. Tolerance: a tenth of the error of a perfect servo there.
TEST_F(LongFit, ForeseesOtherTrajectories) {
  const Prior prior{{.parameter = "resistance", .value = 3.2, .width = 0.2, .relative = true},
                    {.parameter = "viscous_friction", .value = 0.0045, .width = 0.5, .relative = true},
                    {.parameter = "rotor_inertia", .value = 0.0018, .width = 0.1, .relative = true}};
  const std::vector<ServoLog> logs{record(m3_servo, synthetic::two_sines(), {.gain = 200}),
                                   record(m3_servo, synthetic::up_and_down(), {.gain = 400})};
  const Objective objective(friction_model("m3"), prior, logs, of_xl330);
  const Found found = search(objective, {.starts = 1, .evaluations = 2500});
  for (const auto& course : {synthetic::chirp(), synthetic::drops()}) {
    const ServoLog unseen = record(m3_servo, course);
    double perfect = 0;
    for (const ServoSample& sample : unseen.samples) perfect += std::fabs(sample.goal - sample.position);
    perfect /= static_cast<double>(unseen.samples.size());
    law::expect_below({"fit to recordings of two trajectories: mean error on one that it has not seen", course.name,
                       "the servo that made them"},
                      error_on(unseen, found.servo), 0.1 * perfect, "rad");
  }
}

// Rule: a refinement starts where the search ended, and the objective only falls.
TEST_F(Fit, ARefinementMakesNothingWorse) {
  const std::vector<ServoLog> logs{record(m1_servo, synthetic::two_sines(), {.duration = 2})};
  const Found coarse = fit("m1", logs, {.starts = 1, .evaluations = 300});
  ObjectiveOptions finer = of_xl330;
  finer.step = 1e-3;
  Objective fine(friction_model("m1"), nothing, logs, finer);
  const Found found = refine(coarse, fine, 200);
  EXPECT_LT(found.cost, fine(coarse.places));
  EXPECT_EQ(found.cost, fine(found.places));
  EXPECT_EQ(found.costs, coarse.costs) << "of the starts";
}

// Rule: the same seed finds the same servo, with any number of threads; another seed searches along another path. No tolerance.
TEST_F(Fit, TheSeedDecides) {
  const std::vector<ServoLog> logs{record(m1_servo, synthetic::two_sines(), {.duration = 2})};
  const SearchOptions options{.seed = 5, .starts = 3, .evaluations = 300};
  SearchOptions threads = options, other = options;
  threads.threads = 3;
  other.seed = 6;
  const Found found = fit("m4", logs, options), again = fit("m4", logs, threads), else_where = fit("m4", logs, other);
  EXPECT_EQ(found.costs, again.costs);
  EXPECT_NE(found.costs, else_where.costs);
  for (const Parameter* parameter : friction_model("m4").parameters) {
    EXPECT_TRUE(same_bits(parameter->get(found.servo), parameter->get(again.servo))) << parameter->name;
  }
}

// Rule: the reported progress grows to the whole, and the best cost only falls.
TEST_F(Fit, ProgressGrows) {
  const std::vector<ServoLog> logs{record(m1_servo, synthetic::two_sines(), {.duration = 1})};
  const Objective objective(friction_model("m1"), nothing, logs, of_xl330);
  double done = 0, least = 1e9;
  (void)search(objective, {.starts = 2, .evaluations = 400, .threads = 2}, [&](double share, double best) {
    EXPECT_GT(share, done);
    EXPECT_LE(best, least);
    done = share, least = best;
  });
  EXPECT_GT(done, 0.4);
  EXPECT_LE(done, 1);
}

// Law: where logs have no information, the prior decides: k_t and R alone are undetermined while torque is on (M1). Tolerance:
// the width.
TEST_F(LongFit, ThePriorDecidesWhatLogsDoNot) {
  const std::vector<ServoLog> logs{record(m1_servo, synthetic::two_sines()), record(m1_servo, synthetic::chirp())};
  const Prior prior{{.parameter = "resistance", .value = 3.2, .width = 0.05, .relative = true}};
  const Found found =
      search(Objective(friction_model("m1"), prior, logs, of_xl330), {.starts = 1, .evaluations = 2000});
  EXPECT_NEAR(found.servo.resistance, 3.2, 0.16);
  const double slope = m1_servo.torque_constant / m1_servo.resistance;
  EXPECT_NEAR(found.servo.torque_constant / found.servo.resistance, slope, 0.05 * slope);
}

TEST(Folds, LeaveEachTrajectoryOrGainOutOnce) {
  std::vector<ServoLog> logs(4);
  for (std::size_t i = 0; i < 4; ++i) {
    logs[i].trajectory = i % 2 ? "chirp" : "drop";
    logs[i].firmware_gain = i < 3 ? 100 : 200;
  }
  const auto by_trajectory = folds(logs, "trajectory");
  ASSERT_EQ(by_trajectory.size(), 2U);
  EXPECT_EQ(by_trajectory[0].unseen, "chirp");
  for (const ServoLog& log : by_trajectory[0].left_out) EXPECT_EQ(log.trajectory, "chirp");
  for (const ServoLog& log : by_trajectory[0].fitted) EXPECT_EQ(log.trajectory, "drop");
  const auto by_gain = folds(logs, "gain");
  ASSERT_EQ(by_gain.size(), 2U);
  EXPECT_EQ(by_gain[1].unseen, "200");
  EXPECT_EQ(by_gain[1].left_out.size(), 1U);
  EXPECT_EQ(by_gain[1].fitted.size(), 3U);
  EXPECT_THROW((void)folds(std::span(logs).first(1), "gain"), SetupError);
  EXPECT_THROW((void)folds(logs, "color"), SetupError);
}

}  // namespace
}  // namespace murosimf::identification
