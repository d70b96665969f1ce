// A robot changes its level of detail in the middle of what it does: nobody sees a jump, nothing is lost.
#include <gtest/gtest.h>

#include "murosimf/dynamics/motion_properties.h"
#include "tests/fixtures.h"
#include "tests/law.h"
#include "tests/physics/mechanics.h"
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

/// Every level follows every other one: the twelve ordered pairs.
const std::vector<std::string> chain{"kinematic_walking",    "simplified_dynamics",  "full_dynamics",
                                     "articulated_dynamics", "kinematic_walking",    "full_dynamics",
                                     "simplified_dynamics",  "articulated_dynamics", "full_dynamics",
                                     "kinematic_walking",    "articulated_dynamics", "simplified_dynamics",
                                     "kinematic_walking"};

struct Placed {
  Vec3d r;
  Mat3d R;
};

Placed base_of(Entity& robot) {
  return {robot.base().get(properties::position), robot.base().get(properties::orientation)};
}

/// Angle [rad] between two attitudes.
double angle(const Mat3d& a, const Mat3d& b) { return norm(rotation_vector(from_matrix(a * transpose(b)))); }

/// Largest differences over all switches of a run.
struct Seen {
  law::Worst pose_change;   // [m] of any object, by the exchange itself
  law::Worst step, turn;    // [m], [rad] of the base in the step after it
  law::Worst center_speed;  // [m/s] change of the center's velocity in that step, between dynamic levels
  law::Worst lean;          // [deg] of the base, always
  int switches = 0;
};

/// A robot at the levels of the chain, two seconds each.
Seen change_levels(Rig& rig, Entity& robot, double each = 2.0) {
  Seen seen;
  const auto watch = [&](double s) {
    for (int i = 0; i < std::lround(1000 * s); ++i) {
      rig.simulation.step();
      seen.lean.see(std::acos(std::min(1.0, base_of(robot).R.z.z)) / degree);
    }
  };
  watch(each);
  for (std::size_t k = 1; k < chain.size(); ++k) {
    const std::string words = chain[k - 1] + " -> " + chain[k];
    const std::vector<Vec3d> r = robot.find(properties::position)->values;
    const Placed before = base_of(robot);
    rig.exchange(robot, chain[k]);
    ++seen.switches;
    for (const int i : robot.model().bodies()) {
      seen.pose_change.see(norm(robot.find(properties::position)->values[i] - r[i]), words);
    }
    watch(0.001);
    seen.step.see(norm(base_of(robot).r - before.r), words);
    seen.turn.see(angle(base_of(robot).R, before.R), words);
    watch(each - 0.001);
  }
  return seen;
}

void expect_no_jump(const Seen& seen, const std::string& what) {
  const std::string level = "all, changing";
  EXPECT_EQ(seen.switches, 12);
  law::expect_below({.law = what + ": pose changed by an exchange itself", .level = level, .source = "rule: never"},
                    seen.pose_change, 1e-12, "m");
  law::expect_below({.law = what + ": way of the base in the step after an exchange (0.3 mm is 0.3 m/s)",
                     .level = level,
                     .source = "regression: the project's prototype, 0.25 mm"},
                    seen.step, 0.3e-3, "m");
  law::expect_below({.law = what + ": turn of the base in that step", .level = level, .source = "no visible jump"},
                    seen.turn, 0.1 * degree, "rad");
  law::expect_below({.law = what + ": lean of the base", .level = level, .source = "no fall"}, seen.lean, 10, "deg");
}

Entity& robot_in(Rig& rig, const Vec3d& command) {
  Entity& robot = rig.add("robot", kid21());
  rig.simulation.attach<locomotion::WalkEngine>("walk_engine", robot, locomotion::WalkEngine::rate_hz, command);
  rig.attach_dynamics(robot, {.level = chain[0]});
  return robot;
}

TEST(Handover, TwelveSwitchesInAWalk) {
  Rig rig;
  Entity& robot = robot_in(rig, {0.15, 0, 0});
  const Seen seen = change_levels(rig, robot);
  expect_no_jump(seen, "12 switches while walking 0.15 m/s");
  law::expect_near({.law = "12 switches while walking 0.15 m/s: way in 26 s",
                    .level = "all, changing",
                    .source = "command, less the ramp at the start"},
                   Rig::place(robot).x, 0.15 * 26, 0.5, "m");
}

TEST(Handover, TwelveSwitchesOnASlope) {
  Rig rig(0.8, 3 * degree);
  Entity& robot = robot_in(rig, {});
  const Seen seen = change_levels(rig, robot, 1.0);
  expect_no_jump(seen, "12 switches while standing on 3 degrees");
}

/// Momentum of the whole robot as the equations of its level have it: simplified_dynamics is a rigid body.
Wrenchd momentum_at(const std::string& level, Entity& robot) {
  if (level != "simplified_dynamics") return momentum(robot);
  const auto base = robot.base();
  return {base.get(properties::common_inertia) * base.get(properties::angular_velocity),
          base.get(properties::total_mass) * base.get(properties::common_center_of_mass_velocity)};
}

using TwoLevels = std::tuple<std::string, std::string>;
std::string both_levels(const testing::TestParamInfo<TwoLevels>& info) {
  return std::get<0>(info.param) + "_" + std::get<1>(info.param);
}

class HandoverBetween : public testing::TestWithParam<TwoLevels> {};

TEST_P(HandoverBetween, KeepsMomentumInTheMiddleOfAStep) {
  const auto& [from, to] = GetParam();
  Rig rig;
  Entity& robot = rig.add("robot", kid21());
  rig.simulation.attach<locomotion::WalkEngine>("walk_engine", robot, locomotion::WalkEngine::rate_hz,
                                                Vec3d{0.15, 0, 0.3});
  rig.attach_dynamics(robot, {.level = from});
  rig.run(3.137);  // a foot swings
  const Wrenchd before = momentum_at(from, robot);
  rig.exchange(robot, to);
  const Wrenchd after = momentum_at(to, robot);
  ASSERT_GT(norm(before.f), 0.1);
  ASSERT_GT(norm(before.n), 1e-3);
  const law::Statement statement{.law = "momentum of a walking robot over an exchange",
                                 .level = from + " -> " + to,
                                 .source = "conservation of momentum"};
  law::expect_below(statement, norm(after.f - before.f) / norm(before.f), 1e-12, "1");
  law::expect_below({.law = "angular " + statement.law, .level = statement.level, .source = statement.source},
                    norm(after.n - before.n) / norm(before.n), 1e-12, "1");
}

std::vector<TwoLevels> different_levels() {
  std::vector<TwoLevels> pairs;
  for (const auto& from : dynamic_levels()) {
    for (const auto& to : dynamic_levels()) {
      if (from != to) pairs.emplace_back(from, to);
    }
  }
  return pairs;
}
INSTANTIATE_TEST_SUITE_P(Levels, HandoverBetween, testing::ValuesIn(different_levels()), both_levels);

TEST(Handover, FromKinematicWalkingKeepsTheTwistOfThePinnedStance) {
  for (const std::string level : {"full_dynamics", "articulated_dynamics"}) {
    Rig rig;
    Entity& robot = robot_in(rig, {0.15, 0, 0});
    rig.run(3.137);
    const std::vector<Vec3d> v = robot.find(properties::linear_velocity)->values;
    rig.exchange(robot, level);
    for (const int i : robot.model().bodies()) {
      EXPECT_LT(norm(robot.find(properties::linear_velocity)->values[i] - v[i]), 1e-12) << level;
    }
  }
}

TEST(Handover, AFlyingRobotFliesOn) {
  // the center of mass follows its parabola through exchanges, whoever moves the robot
  Rig rig;
  Entity& robot = rig.add("robot", kid21(), {.position = {0, 0, 3}});
  rig.attach_dynamics(robot, {.level = "articulated_dynamics"});
  rig.simulation.initialize();
  Rig::launch(robot, {1, 0.5, 2}, {2, -1, 3});
  rig.simulation.step();
  const Vec3d start = robot.base().get(properties::common_center_of_mass);
  const Vec3d v = Rig::velocity(robot);
  const Wrenchd spin = momentum(robot);
  double t = 0;
  for (const std::string level : {"full_dynamics", "simplified_dynamics", "articulated_dynamics"}) {
    rig.exchange(robot, level);
    rig.run(0.1);
    t += 0.1;
    const Vec3d expected = start + t * v + Vec3d{0, 0, -0.5 * g * t * (t + 0.001)};
    law::expect_below({.law = "flight: center of mass through exchanges of levels",
                       .level = level,
                       .source = "parabola of semi-implicit Euler"},
                      norm(robot.base().get(properties::common_center_of_mass) - expected), 1e-9, "m");
    law::expect_below(
        {.law = "flight: angular momentum through exchanges of levels", .level = level, .source = "conservation"},
        norm(momentum_at(level, robot).n - spin.n) / norm(spin.n), level == "simplified_dynamics" ? 0.03 : 0.05, "1");
  }
}

TEST(Handover, ALyingOrHighRobotCannotWalkKinematically) {
  Rig rig;
  Entity& lying = rig.add("lying", kid21(), {.attitude = rotation_y(pi / 2)});
  Entity& high = rig.add("high", kid21(), {.position = {2, 0, 0.5}});
  for (Entity* robot : {&lying, &high}) rig.attach_dynamics(*robot, {.level = "articulated_dynamics"});
  rig.run(0.05);
  const std::uint64_t hash = rig.simulation.state_hash();
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { rig.exchange(lying, "kinematic_walking"); }),
                             {"'lying' stays at articulated_dynamics", "it leans 9", "only a jump"}));
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { rig.exchange(high, "kinematic_walking"); }),
                             {"'high' stays at articulated_dynamics", "lower sole is 4", "mm away"}));
  EXPECT_EQ(rig.simulation.state_hash(), hash) << "a refusal changes nothing";
  rig.run(0.05);
  EXPECT_EQ(lying.level, "articulated_dynamics");
  EXPECT_FALSE(lying.frozen());
}

TEST(Handover, AContactLawIsExchangedWithoutSinking) {
  Rig rig;
  Entity& robot = rig.add("robot", kid21());
  auto& contact = rig.simulation.attach<collision::GroundContact>("ground_contact", robot, 1000, rig.ground,
                                                                  law_named("implicit_stick"), rig.materials);
  rig.simulation.attach<dynamics::SimplifiedDynamics>("simplified_dynamics", robot, 1000);
  rig.run(1);
  const Vec3d stood = Rig::place(robot);
  for (const std::string law : {"kelvin_voigt", "paper_multipoint", "implicit_stick"}) {
    contact.exchange_law(law_named(law));
    rig.run(1);
    EXPECT_LT(norm(Rig::place(robot) - stood), 0.5e-3) << law;
  }
}

}  // namespace
}  // namespace murosimf::test
