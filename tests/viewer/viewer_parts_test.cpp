// Parts of the viewer that need no scene: who comes into a goal, and whose frames are asked for.
#include <gtest/gtest.h>

#include "murosimf/scene/scene.h"
#include "murosimf/viewer/plot_list.h"
#include "murosimf/viewer/scene_outline.h"
#include "murosimf/viewer/session_requests.h"
#include "murosimf/viewer/shown_poses.h"

namespace murosimf::viewer {
namespace {

using namespace std::chrono_literals;

struct ViewerParts : testing::Test {
  ViewerParts() : scene("duel", {.cameras = false}), outline(scene) {}
  scene::Scene scene;
  SceneOutline outline;
};

TEST_F(ViewerParts, AnOutlineKnowsItsPartsByNameAndNumber) {
  ASSERT_GE(outline.ball(), 0);
  EXPECT_TRUE(outline.of(outline.ball()).is_ball);
  EXPECT_EQ(outline.entity_named(outline.of(outline.ball()).name), outline.ball());
  EXPECT_EQ(outline.entity_named("nobody"), -1);
  EXPECT_EQ(outline.robot(77), -1);
  for (const EntityOutline& one : outline) {
    const ObjectPath base = outline.path_of(one.name);
    EXPECT_EQ(outline.path_of(outline.path_text(base)), base) << one.name;
  }
  EXPECT_THROW((void)outline.path_of("nobody"), SetupError);
}

TEST_F(ViewerParts, AGoalIsToldOnceForEachTimeThatTheBallIsInside) {
  ASSERT_GT(outline.goal_half_width(), 0);
  PoseFrame frame;
  frame.first = {0};
  for (std::size_t i = 0; i < outline.size(); ++i) frame.first.push_back(i + 1);
  frame.position.resize(outline.size());
  frame.present.assign(outline.size(), true);
  Vec3d& ball = frame.position[static_cast<std::size_t>(outline.ball())];
  GoalWatch watch;
  const auto told = [&](const Vec3d& r) {
    ball = r;
    return watch.look(frame, outline).value_or("");
  };
  const double line = outline.half_length();
  EXPECT_EQ(told({0, 0, 0}), "");
  EXPECT_EQ(told({line + 0.2, 0, 0}), "goal on the right");
  EXPECT_EQ(told({line + 0.3, 0, 0}), "");
  EXPECT_EQ(told({0, 0, 0}), "");
  EXPECT_EQ(told({-line - 0.2, 0, 0}), "goal on the left");
  EXPECT_EQ(told({-line - 0.2, outline.goal_half_width() + 0.1, 0}), "") << "beside the posts";
  EXPECT_EQ(told({line + 3, 0, 0}), "") << "far behind it";
}

TEST_F(ViewerParts, AFrameIsAskedForOnceWhereNoneHasCome) {
  ShownPoses poses(scene.simulation().poses());
  session::SessionStatus status;
  status.paused = false;
  EXPECT_FALSE(poses.must_ask(status)) << "frames come by themselves";
  status.paused = true;
  EXPECT_TRUE(poses.must_ask(status));
  EXPECT_FALSE(poses.must_ask(status));
  EXPECT_EQ(poses.place_of({0, 0}), std::nullopt);
  scene.simulation().step();
  EXPECT_TRUE(poses.refresh());
  EXPECT_FALSE(poses.refresh());
  status.time = poses.frame()->time;
  EXPECT_FALSE(poses.must_ask(status));
  status.time = scene.simulation().now();
  EXPECT_TRUE(poses.must_ask(status)) << "frames come at intervals";
  EXPECT_TRUE(poses.place_of({outline.ball(), 0}));
  EXPECT_EQ(poses.place_of({-1, 0}), std::nullopt);
}

TEST_F(ViewerParts, APlotIsThereOnceAndAsksForWhatItShows) {
  PlotList plots;
  const ObjectPath ball{outline.ball(), 0};
  plots.add(outline, ball, "position", false);
  plots.add(outline, ball, "position", false);
  plots.add(outline, {0, 0}, "imu.gyroscope", true);
  ASSERT_EQ(plots.size(), 2U);
  InspectionRequest request;
  plots.request(request);
  EXPECT_EQ(request.objects, std::vector<ObjectPath>{ball});
  EXPECT_EQ(request.sensors_of, 0);
  plots.remove_sensors();
  ASSERT_EQ(plots.size(), 1U);
  scene.simulation().step();
  plots.take(inspect(scene, request));
  ASSERT_EQ(plots[0].plot.curves.size(), 3U);
  EXPECT_EQ(plots[0].plot.unit, "m");
  plots.remove(0);
  EXPECT_TRUE(plots.empty());
}

TEST(MessageLog, KeepsTheLastOnes) {
  MessageLog messages;
  for (int i = 0; i < 250; ++i) messages.tell(std::to_string(i), i % 2 == 1);
  ASSERT_EQ(messages.all().size(), 200U);
  EXPECT_EQ(messages.all().front().text, "50");
  EXPECT_TRUE(messages.all().back().error);
}

}  // namespace
}  // namespace murosimf::viewer
