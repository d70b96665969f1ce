// Robots that act by their cameras: one localizes itself, one crosses the field between obstacles. Nothing of
// this is a row of docs/validation.md: machines without OpenGL could not prove it.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "murosimf/collision/queries.h"
#include "murosimf/scene/scene.h"
#include "murosimf/soccer/behavior_properties.h"
#include "murosimf/soccer/localize.h"
#include "murosimf/soccer/obstacle_course.h"
#include "tests/law.h"

namespace murosimf {
namespace {

using namespace std::chrono_literals;

/// Small pictures, ten a second: the scenes do not depend on more, and tests have to be fast.
scene::SceneOptions options(std::uint64_t seed, std::vector<std::string> more = {}) {
  std::vector<std::string> overrides{"robot.sensors.camera.width=320", "robot.sensors.camera.height=240",
                                     "robot.sensors.camera.rate=10"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return {.seed = seed, .overrides = std::move(overrides)};
}

Vec3d truth(Entity& robot) {
  const Vec3d place = robot.base().get(properties::position);
  return {place.x, place.y, heading(robot.base().get(properties::orientation))};
}

struct PoseError {
  double place, direction;  // [m], [rad]
};

PoseError error_of(Entity& robot) {
  const Vec3d is = truth(robot), believed = robot.base().get(properties::pose_estimate);
  return {std::hypot(believed.x - is.x, believed.y - is.y), std::abs(soccer::wrapped(believed.z - is.z))};
}

/// Largest errors from 2 s to 8 s.
struct Errors {
  law::Worst place, direction;
};

void localize(const std::string& camera, std::vector<std::string> overrides, Errors& errors) {
  scene::Scene scene("self_localization", options(1, std::move(overrides)));
  Simulation& simulation = scene.simulation();
  Entity& robot = simulation.world().entity("robot");
  simulation.run(2s);
  while (simulation.now() < 8s) {
    simulation.run(100ms);
    const PoseError error = error_of(robot);
    errors.place.see(error.place, camera, seconds(simulation.now()));
    errors.direction.see(error.direction * 180 / pi, camera, seconds(simulation.now()));
  }
}

TEST(SelfLocalization, KnowsWhereItIs) {
  Errors errors;
  for (const char* level : {"kinematic_walking", "simplified_dynamics"}) {
    localize(level, {std::string("robot.level=") + level}, errors);
  }
  const law::Measured place = errors.place, direction = errors.direction;
  EXPECT_LT(place.value, 0.15) << place.where;
  EXPECT_LT(direction.value, 6) << direction.where;
}

TEST(SelfLocalization, KnowsLessWithAnUnknownMountingError) {
  Errors good, bad;
  localize("plain", {}, good);
  localize("mounted wrongly", {"robot.sensors.camera.mounting_error_deg=[0,0,8]"}, bad);
  EXPECT_GT(law::Measured(bad.direction).value, law::Measured(good.direction).value + 3);
}

TEST(SelfLocalization, WalksTheSameWayEveryTime) {
  const auto run = [](std::uint64_t seed, int threads) {
    scene::SceneOptions all = options(seed);
    all.threads = threads;
    scene::Scene scene("self_localization", all);
    scene.simulation().run(1s);
    Entity& robot = scene.simulation().world().entity("robot");
    return std::pair(scene.simulation().state_hash(), robot.base().get(properties::pose_estimate).x);
  };
  EXPECT_EQ(run(1, 1), run(1, 2));
  EXPECT_NE(run(1, 1), run(2, 1));
}

/// [m] the least distance from a pole on the way across; that the robot arrives is checked.
double nearest_pole(const std::string& level, std::uint64_t seed) {
  scene::Scene scene("obstacle_challenge", options(seed, {"robot.level=" + level}));
  Simulation& simulation = scene.simulation();
  Entity& robot = simulation.world().entity("robot");
  collision::QueryScene queries(simulation.world());
  double nearest = 1e9;
  do {
    simulation.run(100ms);
    queries.refresh();
    for (const Entity* moving_entity : scene.moving_entities()) {
      if (moving_entity != &robot) nearest = std::min(nearest, queries.distance({&robot}, {moving_entity})->distance);
    }
  } while (simulation.now() < 50s && truth(robot).x < 2.8);
  EXPECT_GE(truth(robot).x, 2.8) << level << ", seed " << seed;
  return nearest;
}

class ObstacleChallenge : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Levels, ObstacleChallenge, testing::Values("kinematic_walking", "simplified_dynamics"),
                         [](const auto& level) { return level.param; });

TEST_P(ObstacleChallenge, IsCrossedWithoutATouch) {
  const double nearest = nearest_pole(GetParam(), 1);
  EXPECT_GT(nearest, 0.02);  // [m] a touch is disqualified
}

}  // namespace
}  // namespace murosimf
