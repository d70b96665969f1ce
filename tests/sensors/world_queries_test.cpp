// What sensors with rays declare: poses of all that moves, and velocities too for those that draw.
#include "murosimf/sensors/world_queries.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <set>

#include "murosimf/model/properties.h"
#include "tests/sensors/range_rig.h"

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
  WorldView view(setup, three.surroundings());
  EXPECT_EQ(three.declared(), poses);
  three.world.entity("ball").column(properties::position).values[0] = {2, 0, 0};
  three.world.entity("ball").column(properties::orientation).values[0] = {};
  three.world.entity("robot").column(properties::position).values[0] = {-5, 0, 0};
  three.world.entity("robot").column(properties::orientation).values[0] = {};
  const auto hit = view.now().cast({{-1, 0, 0}, {1, 0, 0}}, {});
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->body.entity, &three.world.entity("wall"));
  EXPECT_NEAR(hit->distance, 0.9, 1e-12);
}

// Rule: one scene for each kind of volume, for all users; it is as old as the last step of its algorithm.
TEST(WorldQueries, OneSceneForAll) {
  Three three;
  AccessSet others;
  murosimf::Setup field(three.world, three.world.entity("wall"), others);
  WorldQueries queries(field, three.surroundings().moving_entities);
  murosimf::Setup setup = three.setup();
  collision::QueryScene& scene = queries.scene(setup, "sphere");
  EXPECT_EQ(three.declared(), (std::set<std::string>{"wall.query_turn"})) << "asks after it";
  EXPECT_EQ(&queries.scene(setup, "sphere"), &scene);
  EXPECT_NE(&queries.scene(setup, "obb"), &scene);
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { (void)queries.scene(setup, "cube"); }), {"cube"}));
  SensorSurroundings surroundings = three.surroundings();
  surroundings.queries = [&]() -> WorldQueries& { return queries; };
  WorldView view(setup, surroundings);
  EXPECT_EQ(&view.now(), &scene);
  EXPECT_EQ(&view.scene(), &scene);

  std::span<Vec3d> ball = three.world.entity("ball").column(properties::position).values;
  for (const char* name : {"ball", "robot"}) {
    three.world.entity(name).column(properties::position).values[0] = {0, 0, -7};
    three.world.entity(name).column(properties::orientation).values[0] = {};
  }
  const geometry::Ray ray{{-1, 0, 0}, {1, 0, 0}};
  queries.step({});
  EXPECT_NEAR(scene.cast(ray)->distance, 0.9, 1e-12);
  ball[0] = {-0.5, 0, 0};
  EXPECT_NEAR(view.now().cast(ray)->distance, 0.9, 1e-12) << "users of a shared one do not refresh it";
  queries.step({});
  EXPECT_NEAR(view.now().cast(ray)->distance, 0.4, 1e-12);
}

/// What lasers, sonars and detectors on three tumbling boxes among balls and walls report in 40 steps.
std::vector<double> readings(bool shared, int threads) {
  fixtures::Dice dice("tumbling");
  test::RangeRig rig(threads);
  std::vector<Entity*> boxes;
  const char* volumes[] = {"sphere", "obb", "sphere"};
  for (int i = 0; i < 3; ++i) boxes.push_back(&rig.add_box("box" + std::to_string(i), volumes[i]));
  for (int i = 0; i < 7; ++i) rig.add_ball("ball" + std::to_string(i), 0.05 + 0.02 * i);
  rig.add_walls({fixtures::placed(Box{{0.1, 3, 2}}, {4, 0.5, 0})});
  WorldQueries* queries = nullptr;
  const auto of_all = [&]() -> WorldQueries& {
    if (!queries) {
      queries = &rig.simulation.attach<WorldQueries>("world_queries", rig.rate, rig.moving_entities);
    }
    return *queries;
  };
  SensorSurroundings surroundings{.seed = 3, .moving_entities = rig.moving_entities};
  if (shared) surroundings.queries = of_all;
  std::vector<const Reading*> all;
  for (Entity* box : boxes) {
    for (const char* type : {"laser", "sonar", "detector", "rangefinder"}) {
      const SensorSpec spec =
          test::sensor(type, type == std::string("laser") ? std::map<std::string, double>{{"rays", 90}}
                                                          : std::map<std::string, double>{});
      all.push_back(&component_files::attach_sensor(rig.simulation, *box, spec, surroundings, rig.rate).reading());
    }
  }
  rig.begin();
  std::vector<double> values;
  for (int step = 0; step < 40; ++step) {
    for (Entity* one : rig.moving_entities) test::RangeRig::put(*one, dice.vector(1.5), dice.turn());
    rig.simulation.step();
    for (const Reading* reading : all) values.insert(values.end(), reading->values.begin(), reading->values.end());
  }
  return values;
}

// Law: sensors that share their scenes report the same numbers, bit for bit, for any number of threads.
TEST(WorldQueries, SharedOnesGiveTheSameReadings) {
  const std::vector<double> alone = readings(false, 1);
  std::size_t seen = 0;
  for (const double value : alone) seen += std::isfinite(value) ? 1 : 0;
  EXPECT_GT(seen, alone.size() / 10);
  for (const int threads : {1, 2, 4}) {
    const std::vector<double> together = readings(true, threads);
    ASSERT_EQ(together.size(), alone.size());
    EXPECT_EQ(std::memcmp(together.data(), alone.data(), alone.size() * sizeof(double)), 0) << threads;
  }
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
