// The score of two teams: goals that are counted while a scene runs, and in its recording.
#include "murosimf/recording/score_keeper.h"

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "tests/recording/repeatable_run.h"

namespace murosimf {
namespace {

using namespace std::chrono_literals;
using Goals = std::array<int, 2>;
using recording::ScoreKeeper;

/// The ball is put into one goal, taken away, and put into the other one twice.
fixtures::RepeatableRun goals() {
  fixtures::RepeatableRun run{.scene = "three_on_three", .time = 700ms};
  run.when_initialized = [](scene::Scene& scene) {
    int x = 0;
    for (const char* place : {"3.2", "0", "-3.2", "0.5", "-3.2"}) {
      scene.simulation().at(x++ * 100ms + 50ms,
                            [&scene, place] { (void)scene.post(std::string("ball.place = [") + place + ", 0]"); });
    }
  };
  return run;
}

TEST(ScoreKeeper, CountsGoalsForTheTeamThatAttacksThem) {
  scene::Scene scene("three_on_three");
  ScoreKeeper score(scene);
  scene.simulation().initialize();
  score.watch(scene);
  goals().when_initialized(scene);
  scene.simulation().run(700ms);
  ASSERT_EQ(scene.spec().teams[0].attacks, 1);
  EXPECT_EQ(score.at(0ms), (Goals{0, 0}));
  EXPECT_EQ(score.at(40ms), (Goals{0, 0}));
  EXPECT_EQ(score.at(120ms), (Goals{1, 0}));
  EXPECT_EQ(score.at(320ms), (Goals{1, 1}));
  EXPECT_EQ(score.at(10s), (Goals{1, 2}));
}

TEST(ScoreKeeper, CountsTheSameInARecording) {
  const auto run = std::make_shared<const recording::RecordedRun>(fixtures::record("goals.mcap", goals()));
  recording::RecordedSource source(run);
  ScoreKeeper score(source.scene());
  EXPECT_FALSE(score.hear(*run)) << "there is no referee";
  score.count(find_moments(source, [] { return false; }));
  EXPECT_EQ(score.at(120ms), (Goals{1, 0}));
  EXPECT_EQ(score.at(10s), (Goals{1, 2}));
}

TEST(ScoreKeeper, NeedsTwoTeams) {
  const scene::Scene scene("walk");
  EXPECT_THROW(ScoreKeeper{scene}, SetupError);
}

}  // namespace
}  // namespace murosimf
