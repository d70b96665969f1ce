// Playing joint angles: values at and between rows, loops, and logs of runs, which give the same runs again.
#include "murosimf/control_software/trajectory_player.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "murosimf/logging/run_log.h"
#include "murosimf/scene/scene.h"
#include "tests/fixtures.h"
#include "tests/physics/rig.h"
#include "tests/temp_folder.h"

namespace murosimf::control_software {
namespace {

namespace fs = std::filesystem;

const std::string joint_name = "j_head";

/// Rows 0.02 s apart from 1 s on: 0, 0.1, 0.4, 0.2 rad.
JointTrajectory four_rows(const Model& model) {
  JointTrajectory rows{{{model.object_index(joint_name), {1, 1.02, 1.04, 1.06}, {0, 0.1, 0.4, 0.2}}}, 1, 1.06, 0.02};
  return rows;
}

/// Targets after each step of 10 ms, the first before all of them.
std::vector<double> played(const TrajectoryOptions& options, int steps,
                           const std::function<void(JointTrajectory&)>& change = {}) {
  test::Rig rig(0.8, 0, 100);
  Entity& robot = rig.add("robot", test::kid21());
  JointTrajectory rows = four_rows(robot.model());
  if (change) change(rows);
  rig.simulation.attach<TrajectoryPlayer>("trajectory_player", robot, 100, rows, options);
  rig.attach_motion(robot, {.level = "kinematic_walking"});
  rig.simulation.initialize();
  std::vector<double> targets;
  for (int i = 0; i <= steps; ++i) {
    targets.push_back(robot.object(joint_name).get(properties::joint_target));
    rig.simulation.step();
  }
  return targets;
}

void expect_near(const std::vector<double>& got, const std::vector<double>& want) {
  ASSERT_EQ(got.size(), want.size());
  for (std::size_t i = 0; i < got.size(); ++i) EXPECT_NEAR(got[i], want[i], 1e-12) << i;
}

TEST(TrajectoryPlayer, RunsAlongALineAndHoldsTheEnd) {
  expect_near(played({}, 8), {0, 0.05, 0.1, 0.25, 0.4, 0.3, 0.2, 0.2, 0.2});
}

TEST(TrajectoryPlayer, HoldsEachRowIfAskedTo) {
  expect_near(played({.between = "hold"}, 8), {0, 0, 0.1, 0.1, 0.4, 0.4, 0.2, 0.2, 0.2});
}

TEST(TrajectoryPlayer, BeginsWhereAndWhenItIsToldTo) {
  expect_near(played({.begin = 1.02, .delay = 0.03}, 8), {0.1, 0.1, 0.1, 0.1, 0.25, 0.4, 0.3, 0.2, 0.2});
}

TEST(TrajectoryPlayer, GoesFromTheLastRowToTheFirstInALoop) {
  expect_near(played({.loop = true}, 9), {0, 0.05, 0.1, 0.25, 0.4, 0.3, 0.2, 0.1, 0, 0.05});
}

TEST(TrajectoryPlayer, TakesALastRowThatRepeatsTheFirstForTheSame) {
  const auto close = [](JointTrajectory& rows) { rows.joints[0].values.back() = 0; };
  expect_near(played({.loop = true}, 9, close), {0, 0.05, 0.1, 0.25, 0.4, 0.2, 0, 0.05, 0.1, 0.25});
}

// A thousand loops lose nothing: the sum of rounded periods stays within what counts as the same time.
TEST(TrajectoryPlayer, StaysInTimeForAThousandLoops) {
  const std::vector<double> targets = played({.loop = true}, 8000);
  EXPECT_NEAR(targets[8000], 0, 1e-6);
  EXPECT_NEAR(targets[7994], 0.1, 1e-6);
}

TEST(TrajectoryPlayer, RefusesABeginThatIsNotInTheFile) {
  EXPECT_EQ(fixtures::error_of([] { (void)played({.file = "gait.csv", .begin = 1.5}, 1); }),
            "'begin' is 1.5 s, but gait.csv has the times 1 to 1.06 s");
}

TEST(TrajectoryPlayer, PlaysAtTheRateOfItsRows) {
  JointTrajectory rows;
  EXPECT_EQ(own_rate(rows), 100);
  rows.spacing = 0.025 / 3;
  EXPECT_EQ(own_rate(rows), 120);
  rows.spacing = 0.00013;
  EXPECT_EQ(own_rate(rows), 1000);
}

/// [m] Where the base of a walker is after each 10 ms of 3 s; with `log`, its joint targets are written there.
std::vector<Vec3d> walk(const std::vector<std::string>& overrides, const fs::path& log = {}) {
  scene::Scene scene("walk", {.overrides = overrides, .cameras = false});
  std::optional<logging::RunLog> targets;
  if (!log.empty()) {
    targets.emplace(scene.simulation(), std::vector<std::string>{"walker.joint_target"},
                    logging::RunLogOptions{.step_rate = scene.spec().rate, .property_rate = 100});
  }
  std::vector<Vec3d> places;
  for (int i = 0; i < 300; ++i) {
    scene.simulation().run(std::chrono::milliseconds(10));
    places.push_back(scene.simulation().world().entity("walker").base().get(properties::position));
  }
  if (targets) targets->write(log);
  return places;
}

class PlayedLog : public testing::TestWithParam<std::string> {};

// What a run has told its joints makes the same run again, to the last bit: at the levels without and with servos.
TEST_P(PlayedLog, GivesTheSameRunAgain) {
  const fs::path log = fixtures::temp_folder() / ("played_log_" + GetParam() + std::to_string(::getpid()) + ".csv");
  const std::string level = "walker.level=" + GetParam();
  const std::vector<Vec3d> walked = walk({level, "walker.command=[0.15, 0, 0.2]"}, log);
  const std::vector<Vec3d> again = walk({level, "walker.controller=trajectory", "walker.options.file=" + log.string()});
  fs::remove(log);
  EXPECT_GT(norm(Vec3d(walked.back() - walked.front())), 0.2);
  // the targets of the last cycle would be noted by the step that follows it
  for (std::size_t i = 0; i + 1 < walked.size(); ++i) ASSERT_EQ(norm(Vec3d(walked[i] - again[i])), 0.0) << i;
}

INSTANTIATE_TEST_SUITE_P(Levels, PlayedLog, testing::ValuesIn(test::all_levels()), test::level_name);

TEST(TrajectoryController, SaysWhatIsMissing) {
  const auto error = [](const std::string& option) {
    return fixtures::error_of([&] {
      std::vector<std::string> overrides{"walker.controller=trajectory"};
      if (!option.empty()) overrides.push_back("walker.options." + option);
      scene::Scene("walk", {.overrides = overrides, .cameras = false});
    });
  };
  EXPECT_TRUE(fixtures::says(error(""), {"controller 'trajectory' needs the name of a file"}));
  EXPECT_TRUE(fixtures::says(error("file=nosuch.csv"), {"no file 'nosuch.csv'"}));
  EXPECT_TRUE(fixtures::says(error("between=spline"), {"unknown between 'spline'; did you mean 'line'?"}));
}

}  // namespace
}  // namespace murosimf::control_software
