// The same walk at every level: how far it gets, and what must hold on the way.
#include <gtest/gtest.h>

#include <array>
#include <map>

#include "murosimf/collision/contact_properties.h"
#include "tests/physics/walk.h"

namespace murosimf::test {
namespace {

/// 18 s of walking with `command` from standing.
Walk walk(const std::string& level, const Vec3d& command) { return test::walk({{.level = level}, command}); }

/// Regression: figures of the project's prototype, no law, for the same robot and walk parameters (18 s, with the ramp at the start).
struct Expected {
  Vec3d command;
  std::array<double, 4> progress;  // [m] along the command, or [rad]; by level as in all_levels()
};

/// Names tests by their command: Forward20 is vx = 0.20 m/s.
std::string name_of(const testing::TestParamInfo<Expected>& info) {
  const Vec3d& c = info.param.command;
  const char* way = c.x > 0 ? "Forward" : c.x < 0 ? "Back" : c.y != 0 ? "Sideways" : "Turn";
  return way + std::to_string(std::lround(100 * std::abs(c.x + c.y + c.z)));
}
void PrintTo(const Expected& expected, std::ostream* stream) {
  *stream << expected.command.x << ' ' << expected.command.y << ' ' << expected.command.z;
}

class WalkTable : public testing::TestWithParam<Expected> {};

double progress(const Walk& walk, const Vec3d& command) {
  return command.x != 0 ? walk.moved.x : command.y != 0 ? walk.moved.y : walk.turned;
}

std::string words(const Vec3d& command) {
  if (command.z != 0) return fmt::format("turn with {} rad/s", command.z);
  if (command.y != 0) return fmt::format("walk sideways with {} m/s", command.y);
  return fmt::format("walk {} with {} m/s", command.x > 0 ? "forward" : "back", std::abs(command.x));
}

void expect_progress(const std::string& level, const Walk& walk, const Vec3d& command, double expected,
                     double tolerance) {
  law::expect_near({.law = words(command) + ": progress in 18 s",
                    .level = level,
                    .source = "regression: the project's prototype with the same robot, parameters and level"},
                   progress(walk, command), expected, tolerance * std::abs(expected), command.z != 0 ? "rad" : "m");
}

/// What a level may miss of the prototype's progress, and how far [deg] the pelvis may lean. full_dynamics is 5.1 % short
/// at 0.25 m/s, where it veers by 0.3 m; articulated_dynamics with very stiff servos walks 3.83 m.
struct Limits {
  double progress, lean;
};
const std::map<std::string, Limits> limits{{"kinematic_walking", {0.05, 6}},
                                           {"simplified_dynamics", {0.05, 8}},
                                           {"full_dynamics", {0.06, 8}},
                                           {"articulated_dynamics", {0.10, 10}}};

TEST_P(WalkTable, GetsAsFarAsThePrototype) {
  const Expected& expected = GetParam();
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string level = all_levels()[i];
    const Walk result = walk(level, expected.command);
    expect_progress(level, result, expected.command, expected.progress[i], limits.at(level).progress);
    law::expect_below({.law = "walk and turn: largest lean of the pelvis in 18 s",
                       .level = level,
                       .source = "it does not fall"},
                      result.lean, limits.at(level).lean, "deg");
  }
}

INSTANTIATE_TEST_SUITE_P(
    Commands, WalkTable,
    testing::Values(Expected{{0.10, 0, 0}, {1.69, 1.65, 1.65, 1.90}}, Expected{{0.20, 0, 0}, {3.36, 3.27, 3.28, 3.70}},
                    Expected{{0.25, 0, 0}, {4.18, 4.07, 4.11, 4.62}},
                    Expected{{-0.10, 0, 0}, {-1.69, -1.64, -1.62, -1.59}},
                    Expected{{0, 0.06, 0}, {1.01, 0.92, 0.90, 0.92}},
                    Expected{{0, 0, 0.5}, {485 * degree, 455 * degree, 449 * degree, 425 * degree}}),
    name_of);

TEST(KinematicWalking, StandingSoleIsFixed) {
  law::expect_below({.law = "walk in a curve: way of the standing sole on the plane between two swaps",
                     .level = "kinematic_walking",
                     .source = "it is fixed, but for what it moves while it stops: 0.02 s, and back"},
                    walk("kinematic_walking", {0.2, 0, 0.2}).slip, 0.0025, "m");
}
// The ramp at the start and the joint filter cost some of the commanded way.
TEST(KinematicWalking, WalksTheCommandedDistance) {
  law::expect_near({.law = "walk forward with 0.2 m/s: way in 18 s",
                    .level = "kinematic_walking",
                    .source = "the commanded speed times time"},
                   walk("kinematic_walking", {0.2, 0, 0}).moved.x, 0.2 * 18, 0.08 * 0.2 * 18, "m");
}

void expect_steady_pelvis(const std::string& level, const Walk& walk, double limit) {
  law::expect_below({.law = "walk forward with 0.1 m/s: highest minus lowest pelvis",
                     .level = level,
                     .source = "gait at constant hip height: a few millimeters"},
                    walk.center_range, limit, "m");
}

// Servos let the swinging leg overshoot, so steps are longer with them.
TEST(Levels, AgreeOnASlowWalk) {
  const Walk kinematic = walk("kinematic_walking", {0.1, 0, 0});
  expect_steady_pelvis("kinematic_walking", kinematic, 0.008);
  for (const auto& [level, tolerance] : {std::pair{"simplified_dynamics", 0.05}, std::pair{"full_dynamics", 0.05},
                                         std::pair{"articulated_dynamics", 0.15}}) {
    const Walk dynamic = walk(level, {0.1, 0, 0});
    law::expect_near({.law = "walk forward with 0.1 m/s: way in 18 s, as a part of kinematic walking's",
                      .level = level,
                      .source = "levels agree on the same motion"},
                     dynamic.moved.x / kinematic.moved.x, 1, tolerance, "");
    expect_steady_pelvis(level, dynamic, 0.010);
  }
}

// Central differences at 1 kHz of a motion with frequencies up to 120 rad/s: 1e-2 of the speed.
TEST(KinematicWalking, TwistIsTheRateOfThePose) {
  Rig rig;
  Entity& robot = rig.add("robot", kid21());
  rig.simulation.attach<locomotion::WalkEngine>("walk_engine", robot, locomotion::WalkEngine::rate_hz,
                                                Vec3d{0.2, 0, 0.3});
  rig.simulation.attach<dynamics::KinematicWalking>("kinematic_walking", robot, 1000);
  rig.run(3.0);
  auto head = robot.object("head");
  int compared = 0;
  law::Worst error;
  for (int i = 0; i < 500; ++i) {
    const double foot = robot.base().get(properties::stance_foot);
    const Vec3d before = head.get(properties::position);
    rig.simulation.step();
    const Vec3d v = head.get(properties::linear_velocity);
    const Vec3d difference = 1000.0 * (head.get(properties::position) - before);
    if (robot.base().get(properties::stance_foot) != foot) continue;
    // joints move by dt * the new rate, so the backward difference belongs to half a step earlier
    error.see(norm(v - difference), "step", i);
    ++compared;
  }
  law::expect_below({.law = "velocity of the head while the same foot stands: error",
                     .level = "kinematic_walking",
                     .source = "differences of its place"},
                    error, 0.02, "m/s");
  EXPECT_GT(compared, 450);
}

/// A leg of another robot: longer, with mirrored yaw and knee axes; side +1 is left.
Chain long_leg(double side) {
  const std::string name = side > 0 ? "left" : "right";
  PlacedShape foot;
  foot.shape = Box{{0.11, 0.06, 0.015}};
  foot.position = {0.02, 0, -0.04};
  const auto inertia = [](double mass, double length) { return diagonal(mass * length * length / 12); };
  return Chain{}
      .translation({0, side * 0.07, -0.03})
      .revolute(name + "_yaw", {0, 0, -1})
      .revolute(name + "_roll", {1, 0, 0})
      .revolute(name + "_pitch", {0, 1, 0})
      .with(properties::mass, 0.9)
      .with(properties::center_of_mass, {0, 0, -0.1})
      .with(properties::inertia, inertia(0.9, 0.2))
      .translation({0, 0, -0.20})
      .revolute(name + "_knee", {0, -1, 0})
      .with(properties::mass, 0.6)
      .with(properties::center_of_mass, {0, 0, -0.08})
      .with(properties::inertia, inertia(0.6, 0.18))
      .translation({0, 0, -0.18})
      .revolute(name + "_ankle", {0, 1, 0})
      .revolute(name + "_foot", {1, 0, 0})
      .with(properties::mass, 0.4)
      .with(properties::center_of_mass, {0.02, 0, -0.03})
      .with(properties::inertia, inertia(0.4, 0.22))
      .with(properties::shapes, Shapes{foot})
      .translation({0.02, 0, -0.055})
      .endpoint(name + "_sole")
      .with(properties::sole, {0.11, 0.06});
}

/// Its legs are 45 % of its mass: its soles slip at every step, and full dynamics, which has their reactions, gets it half as far.
void expect_biped_way(const std::string& level, double way) {
  const law::Statement statement{.law = "another biped, seeded parameters, walk with 0.2 m/s: way in 15 s",
                                 .level = level,
                                 .source = "the commanded speed times time"};
  if (level == "kinematic_walking") {
    law::expect_near(statement, way, 3.0, 0.45, "m");
  } else {
    law::expect_between(statement, way, 1.5, 3.45, "m");
  }
}

// The walk is seeded from the legs' lengths: a robot of 8 kg with legs of 0.38 m, that nobody tuned, walks 15 s at every
// level with prescribed joints (it has no servos) without falling and gets the commanded way, or half of it where soles slip.
TEST(Levels, AnotherBipedWalksWithSeededParameters) {
  const auto model =
      std::make_shared<const Model>("other", Chain{}
                                                 .base("pelvis")
                                                 .with(properties::mass, 4.2)
                                                 .with(properties::center_of_mass, {0, 0, 0.14})
                                                 .with(properties::inertia, SymMat3d{0.05, 0.04, 0.03, 0, 0, 0})
                                                 .fork(long_leg(1), long_leg(-1)));
  for (const std::string level : {"kinematic_walking", "simplified_dynamics", "full_dynamics"}) {
    Rig rig;
    Entity& robot = rig.add("robot", model);
    rig.simulation.attach<locomotion::WalkEngine>("walk_engine", robot, locomotion::WalkEngine::rate_hz,
                                                  Vec3d{0.2, 0, 0});
    rig.attach_motion(robot, {.level = level});
    rig.simulation.initialize();
    const double start = Rig::place(robot).x;
    double lean = 0;
    for (int i = 0; i < 15000; ++i) {
      rig.simulation.step();
      lean = std::max(lean, std::acos(std::min(1.0, robot.base().get(properties::orientation).z.z)));
    }
    expect_biped_way(level, Rig::place(robot).x - start);
    law::expect_below({.law = "another biped, seeded parameters, walk with 0.2 m/s: largest lean of the pelvis",
                       .level = level,
                       .source = "it does not fall"},
                      lean * 180 / pi, 10, "deg");
  }
}

}  // namespace
}  // namespace murosimf::test
