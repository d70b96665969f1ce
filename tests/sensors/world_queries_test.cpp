// What sensors with rays declare: poses of all that moves, and velocities too for those that draw.
#include "murosimf/sensors/world_queries.h"

#include <gtest/gtest.h>

#include <set>

#include "murosimf/model/properties.h"
#include "tests/fixtures.h"

namespace murosimf::sensors {
namespace {

/// A robot, a ball, and a wall that never moves.
struct Three {
  Three() {
    const auto model = std::make_shared<const Model>(fixtures::ball_model(0.1, 0.4));
    for (const char* name : {"robot", "ball", "wall"}) world.add(name, model);
  }
  [[nodiscard]] SensorSurroundings surroundings() const {
    return {.moving_entities = {&world.entity("robot"), &world.entity("ball")}};
  }
  [[nodiscard]] std::set<std::string> declared() const {
    std::set<std::string> names;
    for (const Access& a : access.all()) {
      EXPECT_EQ(a.mode, AccessMode::read);
      names.insert(a.entity->name() + "." + std::string(a.column->info().name));
    }
    return names;
  }
  World world;
  AccessSet access;
  Setup setup() { return {world, world.entity("robot"), access}; }
};

const std::set<std::string> poses{"robot.position", "robot.orientation", "ball.position", "ball.orientation"};

TEST(WorldQueries, ReadPosesOfAllThatMoves) {
  Three three;
  murosimf::Setup setup = three.setup();
  collision::QueryScene scene = world_queries(setup, three.surroundings());
  EXPECT_EQ(three.declared(), poses);
  three.world.entity("ball").column(properties::position).values[0] = {2, 0, 0};
  three.world.entity("ball").column(properties::orientation).values[0] = {};
  three.world.entity("robot").column(properties::position).values[0] = {-5, 0, 0};
  three.world.entity("robot").column(properties::orientation).values[0] = {};
  scene.refresh();
  const auto hit = scene.cast({{-1, 0, 0}, {1, 0, 0}}, {});
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->body.entity, &three.world.entity("wall"));
  EXPECT_NEAR(hit->distance, 0.9, 1e-12);
}

TEST(WorldQueries, WhoDrawsReadsVelocitiesToo) {
  Three three;
  murosimf::Setup setup = three.setup();
  read_motion_of_all(setup, three.surroundings());
  std::set<std::string> expected = poses;
  for (const char* name : {"robot", "ball"}) {
    expected.insert(std::string(name) + ".linear_velocity");
    expected.insert(std::string(name) + ".angular_velocity");
  }
  EXPECT_EQ(three.declared(), expected);
}

}  // namespace
}  // namespace murosimf::sensors
