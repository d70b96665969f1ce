// A search for a key-frame motion: its numbers and their bounds, what playing it shows, that it gets better, and threads.
#include "murosimf/studies/motion_tuning.h"

#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/robot/motion_file.h"
#include "tests/fixtures.h"
#include "tests/hasty_motion.h"
#include "tests/temp_folder.h"

namespace murosimf::studies {
namespace {

using locomotion::KeyframeMotion;

const VariedRobot& kid21() {
  static const VariedRobot robot("kid21", false);
  return robot;
}

KeyframeMotion shipped(const char* name) { return robot::read_motion(robot::find_motion(name)); }

std::string hasty_file() {
  const auto file = fixtures::temp_folder() / "hasty.toml";
  std::ofstream(file) << fixtures::hasty_motion;
  return file.string();
}

/// [rad/s] By the closed form of a cosine: pi/2 times the way over the time.
double steepest(const KeyframeMotion& motion, std::size_t column) {
  double largest = 0;
  const std::vector<double>* from = &motion.start;
  for (const auto& frame : motion.frames) {
    largest = std::max(largest, pi / 2 * std::abs(frame.values[column] - (*from)[column]) / frame.duration);
    from = &frame.values;
  }
  return largest;
}

TEST(MotionSpace, HasTheNumbersOfAllFramesButTheLastValues) {
  const KeyframeMotion motion = shipped("get_up_front");
  const MotionSpace space(kid21().model(), motion);
  EXPECT_EQ(space.space().start.size(), 6 * 7 + 1u);
  const KeyframeMotion again = space.motion_at(space.space().start);
  EXPECT_EQ(again.start, motion.start);
  EXPECT_EQ(again.frames.back().values, motion.frames.back().values);
  for (std::size_t i = 0; i < motion.frames.size(); ++i) {
    for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(again.frames[i].values[c], motion.frames[i].values[c], 1e-12);
    EXPECT_GE(again.frames[i].duration, motion.frames[i].duration - 1e-12);
  }
}

TEST(MotionSpace, KeepsToTheServosWhateverTheNumbersAre) {
  const KeyframeMotion motion = robot::read_motion(hasty_file());
  const MotionSpace space(kid21().model(), motion);
  EXPECT_NEAR(space.largest_rate(motion), pi / 2 * 3.093 / 0.158, 0.05) << "shoulders, in the fifth frame";
  CmaEs numbers(space.space());
  for (const auto& point : numbers.ask()) {
    const KeyframeMotion tried = space.motion_at(point);
    for (std::size_t column = 0; column < 6; ++column) {
      const int joint = kid21().model().object_index(motion.columns[column][0].name);
      const double fastest = kid21().model().find(properties::servo, joint)->no_load_speed;
      EXPECT_LE(steepest(tried, column), fastest) << motion.columns[column][0].name;
      double low = motion.start[column], high = low;  // kid21's joints have no ranges
      for (const auto& frame : motion.frames) {
        low = std::min(low, frame.values[column]);
        high = std::max(high, frame.values[column]);
      }
      for (const auto& frame : tried.frames) {
        EXPECT_GE(frame.values[column], low - 0.4);
        EXPECT_LE(frame.values[column], high + 0.4);
      }
    }
  }
}

TEST(MotionSpace, KeepsToTheRangesOfJoints) {
  const VariedRobot nao("spark_nao0", false);
  const Model& model = nao.model();
  const int joint = model.joints()[0];
  const Vec3d range = *model.find(properties::joint_range, joint);
  const std::string name = model.objects()[joint].name;
  const KeyframeMotion motion{.name = "far", .columns = {{{name, -1}}}, .start = {0}, .frames = {{1, {99}}, {1, {0}}}};
  const CmaEsOptions space = MotionSpace(model, motion).space();
  EXPECT_EQ(space.low[1], -range.y);
  EXPECT_EQ(space.high[1], -range.x);
  EXPECT_EQ(space.start[1], -range.x) << "moved to the end of the range";
}

TEST(MotionSpace, KeepsToTheRateThatIsGivenWhereTheRobotHasNone) {
  const VariedRobot nao("spark_nao0", false);
  const KeyframeMotion motion{.name = "wave",
                              .columns = {{{"laj1", 1}}},
                              .start = {0},
                              .frames = {{0.1, {1}}, {1, {0}}}};
  const auto first = [&](double fastest) {
    const MotionSpace space(nao.model(), motion, fastest);
    return space.motion_at(space.space().start).frames[0].duration;
  };
  EXPECT_NEAR(first(6), pi / 2 * 1 / 6, 2e-3) << "the steepest part of a cosine";
  EXPECT_EQ(first(0), 0.1) << "nothing is known of its servos";
}

TEST(MotionSpace, KnowsHowFastFeetMoveJoints) {
  // the kick lifts a foot by inverse kinematics: twice as slow is half the rate
  KeyframeMotion motion = shipped("kick");
  const MotionSpace space(kid21().model(), motion);
  const double rate = space.largest_rate(motion);
  EXPECT_GT(rate, 1);
  for (auto& frame : motion.frames) frame.duration *= 2;
  EXPECT_NEAR(space.largest_rate(motion), rate / 2, 1e-9 * rate);
}

TEST(TuningCases, AreTheSameAtEveryLevelAndSpread) {
  const auto cases = tuning_cases({"full_dynamics", "articulated_dynamics"}, 20, 3, "tuning");
  ASSERT_EQ(cases.size(), 40u);
  double mean = 0;
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(cases[i].friction, cases[20 + i].friction);
    EXPECT_EQ(cases[i].roll, cases[20 + i].roll);
    EXPECT_GE(cases[i].friction, 0.5);
    EXPECT_LE(cases[i].friction, 1.0);
    EXPECT_LE(std::hypot(cases[i].roll, cases[i].pitch), 2.001 * pi / 180);
    mean += cases[i].friction / 20;
  }
  EXPECT_NEAR(mean, 0.75, 0.02);
  EXPECT_NE(tuning_cases({"full_dynamics"}, 1, 3, "tuning")[0].heading,
            tuning_cases({"full_dynamics"}, 1, 4, "tuning")[0].heading);
  EXPECT_THROW((void)tuning_cases({}, 1, 1, "tuning"), SetupError);
  EXPECT_THROW((void)tuning_cases({"some_dynamics"}, 1, 1, "tuning"), SetupError);
  EXPECT_THROW((void)tuning_cases({"full_dynamics", "full_dynamics"}, 1, 1, "tuning"), SetupError);
}

TEST(TuningCases, MeanAndWorstLevelCount) { EXPECT_DOUBLE_EQ(mean_and_worst({1, 3, 0, 0}, 2), 0.5 * (1 + 2)); }

TEST(VariedRobot, IsHeavierAndStiffer) {
  const auto heavy = kid21().assets(1.1, 0.9)->robot(kid21().file(), {});
  const Model& model = kid21().model();
  for (const int object : model.having(properties::mass))
    EXPECT_DOUBLE_EQ(*heavy->model->find(properties::mass, object), 1.1 * *model.find(properties::mass, object));
  for (const int joint : model.having(properties::servo)) {
    EXPECT_DOUBLE_EQ(heavy->model->find(properties::servo, joint)->position_gain,
                     0.9 * model.find(properties::servo, joint)->position_gain);
  }
}

/// In how many of four cases at two levels the motion is good.
std::size_t good_runs(const KeyframeMotion& motion, const MotionTask& task) {
  MotionTrials trials(kid21(), motion, task);
  const auto outcomes = trials.run({motion}, tuning_cases({"full_dynamics", "articulated_dynamics"}, 2, 1, "tuning"));
  std::size_t good = 0;
  for (const MotionOutcome& one : outcomes[0]) good += one.good ? 1 : 0;
  return good;
}

TEST(MotionTrials, SeeWhoStands) {
  const KeyframeMotion motion = shipped("get_up_front");
  EXPECT_EQ(good_runs(motion, {.pitch = pi / 2, .threads = 2}), 4u);
  EXPECT_EQ(good_runs(motion, {.pitch = -pi / 2, .threads = 2}), 0u) << "from the back it is no use";
  KeyframeMotion nothing = motion;
  nothing.start = nothing.frames.back().values;
  for (auto& frame : nothing.frames) frame.values = nothing.start;
  EXPECT_EQ(good_runs(nothing, {.pitch = pi / 2, .threads = 2}), 0u) << "it lies there";
  EXPECT_EQ(good_runs(nothing, {.threads = 2}), 4u) << "it stands there";
}

TEST(MotionTrials, SeeWhereTheBallGoes) {
  const KeyframeMotion motion = shipped("kick");
  const auto cases = tuning_cases({"articulated_dynamics"}, 1, 1, "tuning");
  const auto cost_toward = [&](double direction, const Vec3d& ball) {
    MotionTrials trials(kid21(), motion,
                        {.goal = MotionGoal::kicks,
                         .direction = direction,
                         .ball = ball,
                         .ball_options = {.radius = 0.065, .mass = 0.3}});
    return trials.run({motion}, cases)[0][0];
  };
  const MotionOutcome ahead = cost_toward(0, {0.2, -0.056, 0}), behind = cost_toward(pi, {0.2, -0.056, 0}),
                      elsewhere = cost_toward(0, {0.2, 1, 0});
  EXPECT_TRUE(ahead.good);
  EXPECT_LT(ahead.cost, behind.cost - 0.3) << "1.5/(1.5 + v) of a ball that rolls at 1 m/s and more";
  EXPECT_NEAR(behind.cost, elsewhere.cost, 0.03) << "no speed to the back, and none at all";
}

TEST(MotionTrials, SeeWhoLies) {
  KeyframeMotion nothing = shipped("get_up_front");
  nothing.start = nothing.frames.back().values;
  for (auto& frame : nothing.frames) frame.values = nothing.start;
  EXPECT_EQ(good_runs(nothing, {.goal = MotionGoal::lies, .threads = 2}), 0u) << "it stands";
  EXPECT_EQ(good_runs(nothing, {.goal = MotionGoal::lies, .pitch = pi / 2, .threads = 2}), 4u);
}

/// The motion that gets up from the back, as fast as servos can: it does not, always.
MotionTuningOptions small_tuning(int threads, std::size_t evaluations, std::uint64_t seed = 1) {
  MotionTuningOptions options{.motion = hasty_file(),
                              .model = "kid21",
                              .task = {.pitch = -pi / 2},
                              .levels = {"full_dynamics"}};
  options.budget.evaluations = evaluations;
  options.budget.seed = seed;
  options.common.threads = threads;
  return options;
}

TEST(MotionTuning, GetsBetterAndWritesAMotion) {
  const MotionTuning tuned = tune_motion(small_tuning(2, 66));
  EXPECT_EQ(tuned.search.generations, 4u);
  EXPECT_LT(tuned.search.best_cost, tuned.search.start_cost - 0.1);
  EXPECT_LT(tuned.rate_after, 6.65) << "kid21's servos";
  ASSERT_EQ(tuned.checks.size(), 1u);
  EXPECT_EQ(tuned.checks[0].runs, 20u);
  const auto file = fixtures::temp_folder() / "tuned_motion.toml";
  std::ofstream(file) << to_toml(tuned, "found by a test");
  const KeyframeMotion read = robot::read_motion(file);
  ASSERT_EQ(read.frames.size(), tuned.after.frames.size());
  for (std::size_t i = 0; i < read.frames.size(); ++i) {
    EXPECT_NEAR(read.frames[i].duration, tuned.after.frames[i].duration, 1e-9);
    for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(read.frames[i].values[c], tuned.after.frames[i].values[c], 1e-9);
  }
  EXPECT_EQ(read.columns[1][1].name, "j_r_upper_arm");
  EXPECT_EQ(read.columns[1][1].sign, -1);
}

TEST(MotionTuning, KeepsWhereTheBallLies) {
  MotionTuning tuning;
  tuning.after = shipped("kick_right");
  const auto file = fixtures::temp_folder() / "tuned_kick.toml";
  std::ofstream(file) << to_toml(tuning, "by hand");
  const KeyframeMotion read = robot::read_motion(file);
  ASSERT_TRUE(read.kick);
  EXPECT_EQ(read.kick->ball.x, tuning.after.kick->ball.x);
  EXPECT_EQ(read.kick->ball.y, tuning.after.kick->ball.y);
  EXPECT_EQ(read.kick->direction, tuning.after.kick->direction);
}

TEST(MotionTuning, ThreadsDoNotMatter) {
  EXPECT_EQ(to_toml(tune_motion(small_tuning(1, 17)), ""), to_toml(tune_motion(small_tuning(3, 17)), ""));
}

TEST(MotionTuning, NamesWhatIsWrong) {
  const auto refusal = [](const MotionTuningOptions& options) -> std::string {
    try {
      (void)tune_motion(options);
    } catch (const SetupError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_NE(refusal({.motion = "get_up_frond", .model = "kid21"}).find("did you mean 'get_up_front'"),
            std::string::npos);
  EXPECT_NE(refusal({.motion = "get_up_front", .model = "kid22"}).find("kid22"), std::string::npos);
  EXPECT_NE(refusal({.motion = "get_up_front", .model = "quadruped"}).find("j_l_sh_pitch"), std::string::npos);
  EXPECT_NE(refusal({.motion = "get_up_front", .model = "kid21", .levels = {"half_dynamics"}}).find("half_dynamics"),
            std::string::npos);
}

}  // namespace
}  // namespace murosimf::studies
