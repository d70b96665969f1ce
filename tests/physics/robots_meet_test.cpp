// Two robots of any two levels fly into each other: momentum is kept, and nobody ends up inside the other.
#include <gtest/gtest.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "tests/law.h"
#include "tests/physics/encounters.h"

namespace murosimf::test {
namespace {

constexpr double speed = 0.5;  // [m/s]

/// Without gravity and ground. The second flies at the first, which stands still, face to face and off its middle.
struct Meeting {
  Meeting(const std::string& one, const std::string& other) {
    rig.simulation.world().gravity = {};
    rig.materials = MaterialTable::standard();
    // kinematic walkers stand on z = 0, so all do
    first = &rig.add("first", kid21());
    second = &rig.add("second", kid21(), {.position = {0.4, 0.04, 0}, .heading = pi});
    rig.attach_together({{first, {.level = one, .on_ground = false}}, {second, {.level = other, .on_ground = false}}});
    rig.simulation.initialize();
    Rig::launch(*second, {-speed, 0, 0});
    rig.simulation.step();  // takes over the launch
  }
  /// With the ledger of a robot that cannot be pushed, whose own momentum is given and does not count.
  [[nodiscard]] Vec3d total_momentum() const {
    Vec3d sum;
    for (Entity* robot : {first, second}) {
      const bool free = robot->base().get(properties::dynamic) != 0;
      sum += free ? linear_momentum(*robot) : robot->base().get(properties::absorbed_impulse).f;
    }
    return sum;
  }
  Rig rig;
  Entity* first = nullptr;
  Entity* second = nullptr;
};

using Levels = std::tuple<std::string, std::string>;

class RobotsMeet : public testing::TestWithParam<Levels> {};

// Tolerance: rounding of 1500 steps.
TEST_P(RobotsMeet, KeepMomentumAndStayApart) {
  const auto& [one, other] = GetParam();
  Meeting meeting(one, other);
  Overlap overlap(meeting.rig.simulation.world(), {meeting.first}, {meeting.second});
  const Vec3d before = meeting.total_momentum();
  const double mass = meeting.second->base().get(properties::total_mass);
  double deepest = 0;
  for (int i = 0; i < 1500; ++i) {
    meeting.rig.simulation.step();
    deepest = std::max(deepest, overlap.now());
  }
  const std::string words = one + " and " + other;
  law::expect_below({.law = "a robot flies into another one: change of the momentum of both, and the ledger",
                     .level = words,
                     .source = "forces are equal and opposite: none"},
                    norm(meeting.total_momentum() - before), 1e-12, "N s");
  // one point carries a quarter of the weight at 0.4 mm
  const double stiffness = mass * g / (4 * 0.4e-3);
  EXPECT_GT(deepest, 1e-4) << "they did not meet";
  law::expect_below({.law = "a robot flies into another one: deepest overlap",
                     .level = words,
                     .source = "less than one undamped spring takes: v sqrt(m / k)"},
                    deepest, speed * std::sqrt(mass / stiffness), "m");
  EXPECT_EQ(overlap.now(), 0) << "they did not part";
  EXPECT_FALSE(meeting.first->frozen() || meeting.second->frozen());
}

INSTANTIATE_TEST_SUITE_P(AllPairs, RobotsMeet,
                         testing::Combine(testing::ValuesIn(all_levels()), testing::ValuesIn(dynamic_levels())),
                         [](const auto& test) { return std::get<0>(test.param) + "_" + std::get<1>(test.param); });

/// One robot, or two that walk towards each other with 0.2 m/s each.
struct HeadOn {
  explicit HeadOn(bool both) {
    rig.materials = MaterialTable::standard();
    std::vector<Rig::Together> all;
    for (int i = 0; i < (both ? 2 : 1); ++i) {
      Entity& robot = rig.add("robot" + std::to_string(i), kid21(), {.position = {0.6 * i, 0, 0}, .heading = pi * i});
      rig.simulation.attach<locomotion::WalkEngine>("walk_engine", robot, locomotion::WalkEngine::rate_hz,
                                                    Vec3d{0.2, 0, 0});
      robots.push_back(&robot);
      all.push_back({&robot, {.level = "kinematic_walking"}});
    }
    rig.attach_together(all);
    rig.simulation.initialize();
  }
  /// Takes a step; the way [m] of the first robot's base in it.
  Vec3d step() {
    const Vec3d before = Rig::place(*robots[0]);
    rig.simulation.step();
    return Rig::place(*robots[0]) - before;
  }
  Rig rig;
  std::vector<Entity*> robots;
};

// A lone robot walks with the same joints, so its way in a step differs by what blocks the other.
TEST(KinematicWalkers, BlockEachOtherWithoutAJump) {
  HeadOn alone(false), both(true);
  Overlap overlap(both.rig.simulation.world(), {both.robots[0]}, {both.robots[1]});
  law::Worst deepest, blocked;
  for (int i = 0; i < 10000; ++i) {
    const Vec3d free = alone.step();
    blocked.see(norm(both.step() - free), "step", i);
    deepest.see(overlap.now(), "step", i);
  }
  law::expect_below({.law = "two robots walk head-on: deepest overlap",
                     .level = "kinematic_walking",
                     .source = "less than limbs swing in two steps"},
                    deepest, 2e-3, "m");
  law::expect_below({.law = "two robots walk head-on: largest way of a base in one step, against walking alone",
                     .level = "kinematic_walking",
                     .source = "they are moved by at most 1 mm"},
                    blocked, 1e-3 + 1e-12, "m");
  EXPECT_LT(Rig::place(*both.robots[0]).x, Rig::place(*both.robots[1]).x) << "they walked through each other";
  EXPECT_GT(Rig::place(*alone.robots[0]).x, 1) << "a lone robot gets past that place";
}

}  // namespace
}  // namespace murosimf::test
