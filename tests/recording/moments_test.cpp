// Moments of recordings are found where they happened, and clips show them all.
#include "murosimf/recording/moments.h"

#include <cmath>

#include <gtest/gtest.h>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "tests/recording/repeatable_run.h"
#include "tests/written_scene.h"

namespace murosimf {
namespace {

using namespace std::chrono_literals;
using recording::clips_of;
using recording::Moment;
using Kind = Moment::Kind;

std::vector<Moment> moments_in(const std::filesystem::path& file) {
  recording::RecordedSource source(std::make_shared<const recording::RecordedRun>(file));
  return recording::find_moments(source, [] { return false; });
}

TEST(Moments, OfAKickIsOneOfTheRobotWhenTheBallBeginsToMove) {
  Duration moved{};
  double fastest = 0;
  fixtures::RepeatableRun run{.scene = "kick", .time = 3s};
  run.when_initialized = [&](scene::Scene& scene) {
    for (Duration at{}; at < 3s; at += 10ms) {
      scene.simulation().at(at, [&scene, &moved, &fastest, at] {
        const double speed = norm(scene.parts().ball->base().get(properties::linear_velocity));
        if (speed > 0.1 && moved == Duration{}) moved = at;
        fastest = std::fmax(fastest, speed);
      });
    }
  };
  const auto moments = moments_in(fixtures::record("kick.mcap", run));
  ASSERT_EQ(moments.size(), 1U);
  EXPECT_EQ(moments[0].kind, Kind::kick);
  EXPECT_EQ(moments[0].robot, "robot");
  EXPECT_GT(moved, 0ms);
  EXPECT_GE(moments[0].time, moved - 20ms);
  EXPECT_LE(moments[0].time, moved + 150ms);
  EXPECT_NEAR(moments[0].speed, fastest, 0.25 * fastest);
}

TEST(Moments, OfABallThatIsPutBesideARobotAreNone) {
  fixtures::RepeatableRun run{.scene = "kick", .time = 300ms};
  run.when_initialized = [](scene::Scene& scene) {
    scene.simulation().at(100ms, [&scene] { (void)scene.post("ball.place = [0.9, 0.5]"); });
    scene.simulation().at(200ms, [&scene] { (void)scene.post("ball.place = [0.2, 0.2]"); });
  };
  EXPECT_EQ(moments_in(fixtures::record("placed.mcap", run)).size(), 0U);
}

TEST(Moments, AreFoundInRecordingsWithFewFrames) {
  fixtures::RepeatableRun run{.scene = "kick", .time = 3s};
  run.options.rate = 5;
  const auto moments = moments_in(fixtures::record("few.mcap", run));
  ASSERT_EQ(moments.size(), 1U);
  EXPECT_EQ(moments[0].kind, Kind::kick);
}

TEST(Moments, OfARobotThatIsPushedAreItsFallAndThatItIsUpAgain) {
  // the motion engine gets up by itself
  const auto file = fixtures::write_scene(
      "[[robots]]\nname = 'one'\nmodel = 'kid21'\nlevel = 'simplified_dynamics'\ncontroller = 'motions'\n"
      "[[robots]]\nname = 'two'\nmodel = 'kid21'\nposition = [0, 1]\nlevel = 'simplified_dynamics'\n");
  double falls = 0;
  fixtures::RepeatableRun run{.scene = file, .time = 8s, .how = {.pushes = {"one=[150,0,0]@1..1.1"}, .cameras = false}};
  run.when_initialized = [&](scene::Scene& scene) {
    scene.simulation().at(7990ms,
                          [&] { falls = scene.simulation().world().entity("one").find(properties::falls)->values[0]; });
  };
  const auto moments = moments_in(fixtures::record("pushed.mcap", run));
  ASSERT_EQ(falls, 1);
  ASSERT_EQ(moments.size(), 2U);
  EXPECT_EQ(text_of(moments[0]), "one falls");
  EXPECT_GT(moments[0].time, 1s);
  EXPECT_LT(moments[0].time, 2500ms);
  EXPECT_EQ(text_of(moments[1]), "one gets up");
  EXPECT_GT(moments[1].time, moments[0].time);
}

TEST(Moments, OfARobotThatLiesAtTheStartAreThatItIsUp) {
  const auto moments = moments_in(fixtures::record("get_up.mcap", {.scene = "get_up", .time = 4s}));
  ASSERT_EQ(moments.size(), 1U);
  EXPECT_EQ(moments[0].kind, Kind::get_up);
}

TEST(Moments, OfABallThatRollsIntoTheGoalAreTheGoalAndNoKick) {
  const auto file = fixtures::write_scene(
      "[field]\nsize = 'kid_size_2008'\n[ball]\nposition = [2.6, 0]\nvelocity = [1.5, 0, 0]\n"
      "[[robots]]\nname = 'one'\nmodel = 'kid21'\n");
  const auto moments = moments_in(fixtures::record("goal.mcap", {.scene = file, .time = 2s}));
  ASSERT_EQ(moments.size(), 1U);
  EXPECT_EQ(moments[0].kind, Kind::goal);
  EXPECT_EQ(moments[0].robot, "");
}

const std::set<std::string> all{"goal", "kick", "fall", "get_up"};

TEST(Clips, AreAroundTheirMomentsWithinTheRecording) {
  const auto clips = clips_of({{Kind::kick, 500ms, "a", 1}, {Kind::goal, 20s, "", 0}}, all, 9, 0s, 21s);
  ASSERT_EQ(clips.size(), 2U);
  EXPECT_EQ(clips[0].begin, 0s);
  EXPECT_EQ(clips[0].end, 2300ms);
  EXPECT_EQ(clips[1].begin, 17s);
  EXPECT_EQ(clips[1].end, 21s);
}

TEST(Clips, ThatMeetAreOne) {
  // the get-up begins before the end of the fall's, which begins before the end of the kick's
  const auto clips =
      clips_of({{Kind::get_up, 8s, "a", 0}, {Kind::kick, 2s, "a", 1}, {Kind::fall, 3s, "a", 0}}, all, 9, 0s, 60s);
  ASSERT_EQ(clips.size(), 1U);
  EXPECT_EQ(clips[0].begin, 800ms);
  EXPECT_EQ(clips[0].end, 9800ms);
  ASSERT_EQ(clips[0].moments.size(), 3U);
  for (std::size_t i = 0; i + 1 < 3; ++i) EXPECT_LT(clips[0].moments[i].time, clips[0].moments[i + 1].time);
}

TEST(Clips, AreOfTheMomentsMostWorthSeeing) {
  const std::vector<Moment> moments{{Kind::fall, 10s, "a", 0},
                                    {Kind::kick, 20s, "a", 1},
                                    {Kind::kick, 30s, "b", 3},
                                    {Kind::goal, 40s, "", 0}};
  const auto clips = clips_of(moments, all, 2, 0s, 60s);
  ASSERT_EQ(clips.size(), 2U);
  EXPECT_EQ(clips[0].moments[0].robot, "b");
  EXPECT_EQ(clips[1].moments[0].kind, Kind::goal);
  const auto falls = clips_of(moments, {"fall"}, 2, 0s, 60s);
  ASSERT_EQ(falls.size(), 1U);
  EXPECT_EQ(falls[0].moments[0].kind, Kind::fall);
}

TEST(Clips, DoNotOverlapWhateverTheMomentsAre) {
  std::vector<Moment> moments;
  std::uint32_t random = 1;
  for (int i = 0; i < 200; ++i) {
    random = random * 1664525u + 1013904223u;
    moments.push_back({static_cast<Kind>(random >> 30), std::chrono::milliseconds((random >> 8) % 300000), "a",
                       static_cast<double>(random % 7)});
  }
  for (const std::size_t most : {1U, 10U, 50U, 200U}) {
    const auto clips = clips_of(moments, all, most, 0s, 300s);
    std::size_t shown = 0;
    for (std::size_t i = 0; i < clips.size(); ++i) {
      EXPECT_LT(clips[i].begin, clips[i].end);
      if (i > 0) {
        EXPECT_LT(clips[i - 1].end, clips[i].begin);
      }
      for (const Moment& one : clips[i].moments) {
        EXPECT_LE(clips[i].begin, one.time);
        EXPECT_GE(clips[i].end, one.time);
      }
      shown += clips[i].moments.size();
    }
    EXPECT_EQ(shown, most);
  }
}

}  // namespace
}  // namespace murosimf
