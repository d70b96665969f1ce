// A ball of up to 30 m/s against what is thin, at steps of 0.5 to 10 ms: it does not pass, and has not won energy.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "tests/law.h"
#include "tests/written_scene.h"

namespace murosimf {
namespace {

using namespace std::chrono_literals;

struct Obstacle {
  const char *name, *text;
  double thickness;  // [m] along x, about x = 1
};

constexpr Obstacle obstacles[] = {
    {"bar", "shape = 'cylinder'\nradius = 0.01\nlength = 2\nposition = [1, 0, 0.005]\nstatic = true", 0.02},
    {"wall", "shape = 'box'\nsize = [0.05, 2, 2]\nposition = [1, 0, 0.1]\nstatic = true", 0.05},
    {"post", "shape = 'cylinder'\nradius = 0.05\nlength = 2\nposition = [1, 0, 0.005]\nstatic = true", 0.1},
    {"plate", "shape = 'box'\nsize = [0.02, 1, 1]\nmass = 5\nposition = [1, 0, 0.6]", 0.02},
    {"loose_bar", "shape = 'cylinder'\nradius = 0.01\nlength = 2\nmass = 2\nposition = [1, 0, 0.065]", 0.02},
    {"other_ball", "shape = 'sphere'\nradius = 0.065\nmass = 0.15\nposition = [1, 0, 1]", 0.13},
};

std::string shot_at(const Obstacle& obstacle, double speed, double before) {
  return fmt::format(
      "gravity = [0, 0, 0]\n[field]\ngoals = false\n[ball]\nradius = 0.065\nmass = 0.15\nposition = [{}, 0, 1]\n"
      "velocity = [{}, 0, 0]\n[[bodies]]\nname = '{}'\n{}\n",
      before, speed, obstacle.name, obstacle.text);
}

TEST(FastBall, DoesNotPassWhatIsThin) {
  int shots = 0;
  double fastest_return = 0;  // [1] of its speed
  for (const Obstacle& obstacle : obstacles) {
    for (const double speed : {5.0, 15.0, 30.0}) {
      for (const int rate : {2000, 1000, 500, 200, 125, 100}) {
        for (const double before : {0.0, 0.031, 0.077}) {  // where in a step it comes
          scene::Scene scene(fixtures::write_scene(shot_at(obstacle, speed, before)),
                             {.overrides = {fmt::format("rate={}", rate)}});
          scene.simulation().run(400ms);
          const World& world = scene.simulation().world();
          const ObjectAccess ball = world.entity("ball").base();
          const bool moves = std::string(obstacle.text).find("mass") != std::string::npos;
          const double front = moves ? world.entity(obstacle.name).base().get(properties::position).x : 1;
          const std::string shot = fmt::format("{} m/s at {}, {} Hz, from {} m", speed, obstacle.name, rate, before);
          EXPECT_LT(ball.get(properties::position).x, front) << shot;
          fastest_return = std::max(fastest_return, norm(ball.get(properties::linear_velocity)) / speed);
          ++shots;
        }
      }
    }
  }
  law::expect_near({.law = "balls of 5 to 30 m/s at bars, walls, posts, a loose plate, a loose bar and a ball, 0.5 to "
                           "10 ms: largest speed "
                           "after over speed before",
                    .level = "simplified_dynamics",
                    .source = "contact gives no energy"},
                   std::max(1.0, fastest_return), 1, 0.02, "1");
  EXPECT_EQ(shots, 6 * 3 * 6 * 3);
}

/// At its left shin, and beside the middle of it: where the ball is not past it, it is in front of it.
TEST(FastBall, DoesNotPassARobot) {
  for (const int rate : {2000, 1000, 500, 200, 125, 100}) {
    for (const double before : {0.5, 0.53, 0.58}) {
      for (const double y : {0.05, 0.06}) {
        scene::Scene scene(fixtures::write_scene(fmt::format(
                               "[field]\ngoals = false\n[ball]\nposition = [{}, {}, 0.03]\nvelocity = [-30, 0, 0]\n"
                               "[[robots]]\nname = 'robot'\nmodel = 'kid21'\nlevel = 'full_dynamics'\n",
                               before, y)),
                           {.overrides = {fmt::format("rate={}", rate)}});
        World& world = scene.simulation().world();
        Entity& robot = world.entity("robot");
        double front = 1;  // [m] of the ball in front of the shin
        for (int i = 0; i < 6; ++i) {
          scene.simulation().run(10ms);
          const Vec3d knee = robot.object("j_l_shin").get(properties::position);
          const Vec3d ankle = robot.object("j_l_ankle").get(properties::position);
          const Vec3d ball = world.entity("ball").base().get(properties::position);
          if (std::abs(ball.y - knee.y) < 0.05) front = std::min(front, ball.x - std::min(knee.x, ankle.x));
        }
        EXPECT_GT(front, 0.0) << rate << " Hz from " << before << " m, y " << y;
      }
    }
  }
}

}  // namespace
}  // namespace murosimf
