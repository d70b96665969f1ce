// Kicks in a direction: the path of the ball, the side of the foot, and requests that cannot be met.
#include <cmath>

#include <gtest/gtest.h>

#include "murosimf/locomotion/motion_engine.h"
#include "murosimf/scene/scene.h"
#include "tests/fixtures.h"

namespace murosimf::locomotion {
namespace {

using namespace std::chrono_literals;

/// kid21 of scene `kick` with a motion engine, and its ball.
struct Kicker {
  explicit Kicker(const std::string& level, const Vec3d& at, std::vector<std::string> more = {},
                  const char* model = "kid21")
      : scene("kick", options(level, at, std::move(more), model)) {
    scene.simulation().run(1s);
  }
  static scene::SceneOptions options(const std::string& level, const Vec3d& at, std::vector<std::string> more,
                                     const std::string& model) {
    for (const std::string& text :
         {"robot.level=" + level, "robot.model=" + model, std::string("robot.controller=motions"),
          fmt::format("ball.position=[{},{}]", at.x, at.y)})
      more.push_back(text);
    return {.overrides = std::move(more), .cameras = false};
  }
  void ask(const KickRequest& request) { robot.base().set(properties::kick_request, request); }
  [[nodiscard]] MotionState state() { return robot.base().get(properties::motion_state); }
  /// [rad] from where it lay.
  [[nodiscard]] double direction_of_ball(const Vec3d& from) {
    const Vec3d way = ball.base().get(properties::position) - from;
    return std::hypot(way.x, way.y) > 0.5 ? std::atan2(way.y, way.x) : std::nan("");
  }

  scene::Scene scene;
  Entity& robot = scene.simulation().world().entity("robot");
  Entity& ball = scene.simulation().world().entity("ball");
};

TEST(KickDirection, SendsTheBallThere) {
  const Vec3d at{0.2, 0.056, 0};
  for (const char* level : {"simplified_dynamics", "articulated_dynamics"}) {
    for (const double direction : {-0.5, 0.0, 0.6, 1.5}) {
      Kicker kicker(level, at);
      kicker.ask({.number = 1, .direction = direction, .ball_x = at.x, .ball_y = at.y});
      kicker.scene.simulation().run(15s);
      EXPECT_NEAR(kicker.direction_of_ball(at), direction, 0.3) << level;
      EXPECT_EQ(kicker.state().falls, 0) << level << direction;
      EXPECT_EQ(kicker.state().mode, 0) << level << direction;
    }
  }
}

TEST(KickDirection, TakesTheFootThatIsWanted) {
  for (const double side : {1.0, -1.0}) {
    Kicker kicker("kinematic_walking", {3, 3, 0});
    const NamedMotions& motions = *kicker.robot.model().find(properties::given_motions, 0);
    kicker.ask({.number = 1, .side = side});
    std::string played;
    for (int i = 0; i < 30 && played.empty(); ++i) {
      kicker.scene.simulation().run(100ms);
      if (kicker.state().mode == 1) played = motions[static_cast<std::size_t>(kicker.state().motion)].name;
    }
    EXPECT_EQ(played, side > 0 ? "kick_left" : "kick_right");
  }
}

TEST(KickDirection, IsDroppedWhenItIsTakenBack) {
  Kicker kicker("kinematic_walking", {3, 3, 0});
  kicker.ask({.number = 1, .direction = 2});
  kicker.scene.simulation().run(500ms);
  EXPECT_GE(kicker.state().kick, 0);
  EXPECT_GT(kicker.robot.base().get(properties::gait_amplitude), 0) << "it turns";
  kicker.ask({});
  kicker.scene.simulation().run(2s);
  EXPECT_EQ(kicker.state().kick, -1);
  EXPECT_EQ(kicker.state().mode, 0);
  EXPECT_EQ(kicker.robot.base().get(properties::gait_amplitude), 0);
}

TEST(KickDirection, GoesOnFromASavedStateInTheMiddleOfTheWay) {
  const Vec3d at{0.2, 0.056, 0};
  Kicker first("full_dynamics", at), second("full_dynamics", at);
  first.ask({.number = 1, .direction = 0.8, .ball_x = at.x, .ball_y = at.y});
  first.scene.simulation().run(1s);
  const std::vector<std::byte> state = first.scene.save();
  first.scene.simulation().run(4s);
  second.scene.load(state);
  second.scene.simulation().run(4s);
  EXPECT_EQ(first.scene.simulation().state_hash(), second.scene.simulation().state_hash());
}

TEST(KickDirection, EventsAskForIt) {
  scene::SceneOptions options = Kicker::options("kinematic_walking", {0.2, -0.056, 0}, {}, "kid21");
  options.events = {"0.5:robot.kick=[0, -1, 0.2, -0.056]"};
  scene::Scene scene("kick", options);
  scene.simulation().run(5s);
  EXPECT_GT(scene.simulation().world().entity("ball").base().get(properties::position).x, 1);
  const auto error = [](const std::string& event, const char* model = "kid21", const char* controller = "motions") {
    return fixtures::error_of([&] {
      scene::SceneOptions options = Kicker::options("kinematic_walking", {1, 0, 0}, {}, model);
      options.overrides.push_back(std::string("robot.controller=") + controller);
      options.events = {event};
      const scene::Scene scene("kick", options);
    });
  };
  EXPECT_TRUE(fixtures::says(error("1:robot.kick=4"), {"--at", "write DIRECTION"}));
  EXPECT_TRUE(fixtures::says(error("1:robot.kick=[0,1,2]"), {"write DIRECTION"}));
  EXPECT_TRUE(fixtures::says(error("1:robot.kick=left"), {"must be a number"}));
  EXPECT_TRUE(fixtures::says(error("1:robot.kick=0", "kid21", "walk"), {"has no motion engine that could kick"}));
  EXPECT_TRUE(fixtures::says(error("1:robot.kick=0", "spark_nao3"), {"no motion of its file says where"}));
}

}  // namespace
}  // namespace murosimf::locomotion
