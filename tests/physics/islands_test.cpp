// Entities that touch each other: piles come to rest, weights go through, nothing jumps when an island begins or ends.
#include <gtest/gtest.h>

#include <limits>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "tests/fixtures.h"
#include "tests/law.h"
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

/// A ball of 0.1 kg on a box of 4.3 kg on the ground.
struct Stack {
  Stack(const std::string& level, double rate_hz) : rig(0.8, 0, rate_hz) {
    rig.materials = MaterialTable::standard();
    box = &rig.add("box", box_model({"plastic"}));
    ball = &rig.add("ball", scene_file::ball_model(), {.position = {0.02, 0.01, 0.1}});
    rig.attach_together({{box, {.level = level}}, {ball, {.level = level}}});
  }
  Rig rig;
  Entity* box = nullptr;
  Entity* ball = nullptr;
};

double ground_force(Entity& entity) {
  double sum = 0;
  for (const auto& c : entity.find(collision::contacts)->values[0].points) sum += c.force.z;
  return sum;
}

/// A level and a rate [Hz].
using LevelAndRate = std::tuple<std::string, int>;
std::string words(const LevelAndRate& p) { return fmt::format("{}, {} Hz", std::get<0>(p), std::get<1>(p)); }
std::string test_name(const testing::TestParamInfo<LevelAndRate>& info) {
  return fmt::format("{}_{}Hz", std::get<0>(info.param), std::get<1>(info.param));
}

class Island : public testing::TestWithParam<LevelAndRate> {};

TEST_P(Island, CarriesTheWeightOfWhatLiesOnTop) {
  Stack stack(std::get<0>(GetParam()), std::get<1>(GetParam()));
  stack.rig.run(3.0);
  const double weight = g * (4.3 + stack.ball->base().get(properties::total_mass));
  law::expect_near({.law = "ball rests on a box: force of the ground on the box",
                    .level = words(GetParam()),
                    .source = "weight of both"},
                   ground_force(*stack.box), weight, 1e-3 * weight, "N");
  law::expect_below({.law = "ball rests on a box: speed of the ball after 3 s",
                     .level = words(GetParam()),
                     .source = "rolling resistance stops it"},
                    norm(Rig::velocity(*stack.ball)), 1e-3, "m/s");
}

// Two boxes are pushed against a ball between them, which hangs in their friction. If its contacts were not all solved
// together it would creep or shake.
TEST_P(Island, HoldsABallBetweenTwoBoxes) {
  const auto& [level, rate] = GetParam();
  Rig rig(0.8, 0, rate);
  rig.materials = MaterialTable::standard();
  rig.materials.set("ball", "plastic", {.friction = 0.8, .restitution = 0.2});
  Entity& left = rig.add("left", box_model({"plastic", 0.1}), {.position = {-0.21, 0, 0}});
  Entity& right = rig.add("right", box_model({"plastic", 0.1}), {.position = {0.21, 0, 0}});
  Entity& ball = rig.add("ball", scene_file::ball_model(), {.position = {0, 0, 0.0}});
  rig.attach_together({{&left, {.level = level}}, {&right, {.level = level}}, {&ball, {.level = level}}});
  rig.simulation.initialize();
  const double push = 20;
  left.base().set(properties::applied_force, {{}, {push, 0, 0}});
  right.base().set(properties::applied_force, {{}, {-push, 0, 0}});
  rig.run(3.0);
  const Vec3d before = Rig::place(ball);
  rig.run(2.0);
  law::expect_below({.law = "ball squeezed between two boxes: way in 2 s",
                     .level = words(GetParam()),
                     .source = "friction within its cone: none"},
                    norm(Rig::place(ball) - before), 1e-6, "m");
}

INSTANTIATE_TEST_SUITE_P(Bodies, Island,
                         testing::Combine(testing::ValuesIn(dynamic_levels()), testing::Values(1000, 500, 200)),
                         test_name);

/// Where kid21 is after 10 s, under a law for the ground.
Vec3d walk_under(const std::string& level, const std::string& law) {
  Rig rig;
  Entity& robot = rig.add("robot", kid21());
  rig.simulation.attach<locomotion::WalkEngine>("walk_engine", robot, locomotion::WalkEngine::rate_hz,
                                                Vec3d{0.2, 0, 0});
  rig.attach_together({{&robot, {.level = level, .law = law_named(law)}}});
  rig.run(10);
  return Rig::place(robot);
}

class IslandLevels : public testing::TestWithParam<std::string> {};

// The same force and memory by another way of solving: walks agree to the accuracy of the sweeps.
TEST_P(IslandLevels, WalkAsWithTheImplicitLaw) {
  const Vec3d one = walk_under(GetParam(), "implicit_stick"), other = walk_under(GetParam(), "island_gauss_seidel");
  law::expect_below({.law = "walk of 10 s: distance between the ends by implicit_stick and by the island solver",
                     .level = GetParam(),
                     .source = "the same law of force, part of the way"},
                    norm(one - other) / norm(one), 0.03, "");
}

/// A box stands on a slope while a ball rolls down onto it: largest speed of the box on the way.
law::Worst lean_on(const std::string& level, const std::string& law) {
  Rig rig(0.8, 3 * degree);
  rig.materials = MaterialTable::standard();
  Entity& box = rig.add("box", box_model({"plastic"}));
  Entity& ball = rig.add("ball", scene_file::ball_model(), {.position = {-0.215, 0, 0}});
  rig.attach_together({{&box, {.level = level, .law = law_named(law)}}, {&ball, {.level = level}}});
  law::Worst speed;
  bool touched = false;
  for (int i = 0; i < 2000; ++i) {
    rig.simulation.step();
    touched |= !rig.simulation.world().common().find(collision::pair_contacts)->values[0].points.empty();
    if (i > 500) speed.see(norm(Rig::velocity(box)), "step", i);
  }
  EXPECT_TRUE(touched) << "the ball did not reach the box";
  return speed;
}

// Its own law before, an island from then on: with the ground as rows (implicit_stick), or with the memory of an explicit
// law that goes on (kelvin_voigt).
TEST_P(IslandLevels, BeginWithoutAJump) {
  for (const char* law : {"implicit_stick", "kelvin_voigt"}) {
    law::expect_below({.law = "ball leans against a box on a slope of 3 degrees: largest speed of the box",
                       .level = GetParam() + ", " + law,
                       .source = "it stands before and after, the ball is 40 times lighter"},
                      lean_on(GetParam(), law), 2e-3, "m/s");
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, IslandLevels, testing::ValuesIn(dynamic_levels()),
                         [](const auto& test) { return test.param; });

/// A heap of 12 jacks, of three crossed capsules each, that falls from up to 1 m. Jacks hook into each other and do not roll.
struct Heap {
  explicit Heap(double rate_hz, int threads) : rig(0.8, 0, rate_hz, threads) {
    std::vector<Rig::Together> all;
    for (int i = 0; i < 12; ++i) {
      Entity& jack = rig.add("jack" + std::to_string(i), jack_model(),
                             {.position = {0.02 * (i % 3), 0.03 * (i % 2), 0.09 * i}, .heading = 0.4 * i});
      jacks.push_back(&jack);
      all.push_back({&jack, {}});
    }
    rig.attach_together(all);
  }
  static ModelPtr jack_model() {
    Shapes shapes;
    for (const Mat3d& turn : {Mat3d{}, rotation_x(pi / 2), rotation_y(pi / 2)}) {
      PlacedShape shape;
      shape.shape = Capsule{0.02, 0.08};
      shape.orientation = turn;
      shape.surface = {"", 0.6};
      shapes.push_back(shape);
    }
    const double I = 0.5 * 0.16 * 0.16 / 12;
    return std::make_shared<const Model>("jack", Chain{}
                                                     .base("jack")
                                                     .with(properties::mass, 0.5)
                                                     .with(properties::inertia, SymMat3d{I, I, I, 0, 0, 0})
                                                     .with(properties::shapes, shapes));
  }
  double energy() {
    double sum = 0;
    for (Entity* jack : jacks) {
      const Vec3d v = Rig::velocity(*jack), w = jack->base().get(properties::angular_velocity);
      sum += 0.5 * jack->base().get(properties::total_mass) * dot(v, v) +
             0.5 * dot(w, jack->base().get(properties::common_inertia) * w);
    }
    return sum;
  }
  Rig rig;
  std::vector<Entity*> jacks;
};

class HeapRates : public testing::TestWithParam<int> {};

TEST_P(HeapRates, ComesToRest) {
  Heap heap(GetParam(), 1);
  heap.rig.run(6.0);
  law::expect_below({.law = "heap of 12 jacks: kinetic energy after 6 s",
                     .level = fmt::format("simplified_dynamics, {} Hz", GetParam()),
                     .source = "it lies"},
                    heap.energy(), 1e-4, "J");
}

INSTANTIATE_TEST_SUITE_P(Bodies, HeapRates, testing::Values(1000, 500, 200));

TEST(Islands, DoNotDependOnThreads) {
  std::uint64_t first = 0;
  for (const int threads : {1, 2, 3}) {
    Heap heap(1000, threads);
    heap.rig.run(0.8);
    if (threads == 1) first = heap.rig.simulation.state_hash();
    EXPECT_EQ(heap.rig.simulation.state_hash(), first) << threads << " threads";
  }
}

class TreeLevels : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Bodies, TreeLevels, testing::Values("full_dynamics", "articulated_dynamics"),
                         [](const auto& test) { return test.param; });

// A ball flies at a wall that is bolted to the world and bounces as from the ground: e v.
TEST_P(TreeLevels, ABoltedBaseDoesNotGiveWay) {
  Rig rig;
  rig.simulation.world().gravity = {};
  rig.materials = MaterialTable::standard();
  rig.materials.set("ball", "plastic", {.friction = 0.8, .restitution = 0.6});
  Entity& wall = rig.add("wall", box_model({"plastic"}));
  Entity& ball = rig.add("ball", scene_file::ball_model(), {.position = {-0.4, 0, 0}});
  rig.attach_together({{&wall, {.level = GetParam(), .on_ground = false, .tree = {.fixed_base = true}}},
                       {&ball, {.on_ground = false}}});
  rig.simulation.initialize();
  Rig::launch(ball, {2, 0, 0});
  const Vec3d place = Rig::place(wall);
  rig.run(0.5);
  law::expect_near({.law = "ball bounces from a bolted box: speed afterwards",
                    .level = GetParam() + ", fixed_base",
                    .source = "restitution 0.6 of 2 m/s, up to the phase of a step"},
                   -Rig::velocity(ball).x, 1.2, 0.1, "m/s");
  EXPECT_EQ(norm(Rig::place(wall) - place), 0);
}

/// A robot whose numbers go bad while a ball leans on it.
struct BadNeighbor {
  BadNeighbor(const std::string& level, double target) {
    rig.simulation.world().gravity = {};
    rig.materials = MaterialTable::standard();
    robot = &rig.add("robot", kid21(), {.position = {0, 0, 1}});
    ball = &rig.add("ball", scene_file::ball_model(), {.position = {0.12, 0.05, 1.05}});
    rig.attach_together({{robot, {.level = level, .on_ground = false}}, {ball, {.on_ground = false}}});
    rig.simulation.initialize();
    ball->base().set(properties::applied_force, {{}, {-1, 0, 0}});
    for (int i = 0; i < 2000 && touching() == 0; ++i) rig.simulation.step();
    EXPECT_EQ(touching(), 1);
    robot->object("j_l_shin").set(properties::joint_target, target);
    rig.run(0.01);
  }
  [[nodiscard]] std::size_t touching() const {
    return rig.simulation.world().common().find(collision::pair_contacts)->values[0].points.size();
  }
  Rig rig;
  Entity* robot = nullptr;
  Entity* ball = nullptr;
};

// The neighbor plays on: it neither freezes nor is shot away.
TEST_P(IslandLevels, BadNumbersDoNotReachTheNeighbor) {
  for (const double target : {std::numeric_limits<double>::quiet_NaN(), 1e300}) {
    const BadNeighbor scene(GetParam(), target);
    EXPECT_TRUE(scene.robot->frozen()) << target;
    EXPECT_FALSE(scene.ball->frozen()) << target;
    EXPECT_LT(norm(Rig::velocity(*scene.ball)), 2) << target;
  }
}

// Robots of links that touch each other, with controllers: the solver must wait for all that levels read.
TEST(Islands, OfWalkingRobotsDoNotDependOnThreads) {
  std::uint64_t first = 0;
  for (const int threads : {1, 2, 3}) {
    Rig rig(0.8, 0, 1000, threads);
    rig.materials = MaterialTable::standard();
    std::vector<Rig::Together> all;
    for (int i = 0; i < 3; ++i) {
      Entity& robot = rig.add("robot" + std::to_string(i), kid21(), {.position = {0, 0.27 * i, 0}});
      rig.simulation.attach<locomotion::WalkEngine>("walk_engine", robot, locomotion::WalkEngine::rate_hz,
                                                    Vec3d{0.1, 0.06 * (1 - i), 0});
      all.push_back({&robot, {.level = i == 1 ? "full_dynamics" : "articulated_dynamics"}});
    }
    rig.attach_together(all);
    int touched = 0;
    for (int i = 0; i < 3000; ++i) {
      rig.simulation.step();
      touched += rig.simulation.world().common().find(collision::pair_contacts)->values[0].points.empty() ? 0 : 1;
    }
    EXPECT_GT(touched, 100) << "the robots do not touch";
    if (threads == 1) first = rig.simulation.state_hash();
    EXPECT_EQ(rig.simulation.state_hash(), first) << threads << " threads";
  }
}

TEST(Islands, RefuseMotionAtAnotherRate) {
  Rig rig;
  Entity& box = rig.add("box", box_model());
  rig.attach_ground(box, {});
  rig.simulation.attach<dynamics::SimplifiedDynamics>("simplified_dynamics", box, 500);
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { rig.simulation.initialize(); }),
                             {"simplified_dynamics of box", "2 ms", "1 ms", "one rate"}));
}

}  // namespace
}  // namespace murosimf::test
