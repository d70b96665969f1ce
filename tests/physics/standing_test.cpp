// A robot that stands: no creep, no shaking, the right weight, also on a slope and while its arms swing.
#include <gtest/gtest.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "tests/law.h"
#include "tests/physics/arm_swinger.h"
#include "tests/physics/rig.h"
#include "tests/physics/servo_variants.h"

namespace murosimf::test {
namespace {

struct Stand {
  double drift = 0;  // [m/s] of the left foot over the last 10 s
  double turn = 0;   // [rad/s] of the left foot over the last 10 s
  double noise = 0;  // [1] rms deviation of the ground force from the weight
  double mean = 0;   // [N] mean ground force along the ground's normal
  double zmp = 0;    // [m] largest distance between the zero moment point and the center of mass on the ground
};

/// Stands for 12 s on a slope [rad].
Stand stand(const Dynamics& dynamics, double slope, double amplitude, double rate_hz = 1000) {
  Rig rig(0.8, slope, rate_hz);
  Entity& robot = rig.add("robot", kid21());
  rig.simulation.attach<ArmSwinger>("arm_swinger", robot, 100, amplitude);
  rig.attach_dynamics(robot, dynamics);
  rig.run(2.0);

  auto foot = robot.object("l_foot");
  const Vec3d place = foot.get(properties::position);
  const double direction = heading(foot.get(properties::orientation));
  const double weight = robot.base().get(properties::total_mass) * g * std::cos(slope);
  Stand result;
  double squares = 0, sum = 0;
  const int steps = static_cast<int>(10 * rate_hz);
  for (int i = 0; i < steps; ++i) {
    rig.simulation.step();
    double f_z = 0;
    Vec3d moment;  // of the ground forces about the world's origin
    for (const int object : robot.model().bodies()) {
      const Wrenchd f = robot.find(properties::external_force)->values[object];
      moment += f.n + cross(robot.find(properties::position)->values[object], f.f);
      f_z += f.f.z;
    }
    const Vec3d c = robot.base().get(properties::common_center_of_mass);
    result.zmp = std::max(result.zmp, std::hypot(-moment.y / f_z - c.x, moment.x / f_z - c.y));
    squares += (f_z - weight) * (f_z - weight);
    sum += f_z;
  }
  result.drift = norm(foot.get(properties::position) - place) / 10;
  result.turn = std::abs(heading(foot.get(properties::orientation)) - direction) / 10;
  result.noise = std::sqrt(squares / steps) / weight;
  result.mean = sum / steps;
  return result;
}

/// A level, a law, and the rates [Hz] at which the robot stands with it.
struct Stander {
  std::string level, law;
  std::vector<double> rates;
};
std::string words_of(const Stander& s) {
  const long longest = std::lround(1000 / s.rates.back());
  return fmt::format("{}, {}, steps of {} ms", s.level, s.law, longest > 1 ? fmt::format("1 to {}", longest) : "1");
}
std::string name_of(const testing::TestParamInfo<Stander>& info) { return info.param.level + "_" + info.param.law; }
void PrintTo(const Stander& stander, std::ostream* stream) { *stream << words_of(stander); }

/// kelvin_voigt is explicit, and servos make what it pushes springy: with steps of 2 ms articulated_dynamics shakes.
std::vector<Stander> standers() {
  std::vector<Stander> all;
  for (const std::string& level : dynamic_levels()) {
    for (const char* law : {"implicit_stick", "island_gauss_seidel"})
      all.push_back({level, law, {1000, 500, 200, 100}});
    all.push_back({level, "kelvin_voigt", {1000}});
    if (level != "articulated_dynamics") all.back().rates.push_back(500);
  }
  return all;
}

class Standing : public testing::TestWithParam<Stander> {};
INSTANTIATE_TEST_SUITE_P(Contact, Standing, testing::ValuesIn(standers()), name_of);

void expect_rest(const std::string& level, const Stand& s) {
  const std::string source = "friction within its cone: none";
  law::expect_below({.law = "robot stands and swings its arms, level or on 3 degrees: creep",
                     .level = level,
                     .source = source},
                    1e3 * s.drift, 0.01, "mm/s");
  law::expect_below({.law = "robot stands and swings its arms, level or on 3 degrees: turn",
                     .level = level,
                     .source = source},
                    s.turn / degree, 0.01, "deg/s");
  law::expect_below({.law = "robot stands and swings its arms, level or on 3 degrees: rms change of the ground force",
                     .level = level,
                     .source = "the weight, up to the lift of the arms"},
                    s.noise, 0.01, "");
}

// Limits of the validation suite. Arms that swing by 0.3 rad lift the center of mass by 0.8 mm twice a second, which is
// 0.5 % of the weight by itself.
TEST_P(Standing, DoesNotCreepOrTurn) {
  const auto& [level, law, rates] = GetParam();
  for (const double rate : rates) {
    for (const double slope : {0.0, 3 * degree}) {
      SCOPED_TRACE(testing::Message() << rate << " Hz, slope " << slope);
      expect_rest(words_of(GetParam()), stand({.level = level, .law = law_named(law)}, slope, 1, rate));
    }
  }
}

// At rest.
TEST_P(Standing, GroundForceIsTheWeightUnderTheCenterOfMass) {
  const auto& [level, law, rates] = GetParam();
  const double weight = kid21()->tree().mass * g;
  for (const double rate : rates) {
    SCOPED_TRACE(testing::Message() << rate << " Hz");
    const Stand s = stand({.level = level, .law = law_named(law)}, 0, 0, rate);
    law::expect_near({.law = "robot stands: ground force, mean of 10 s",
                      .level = words_of(GetParam()),
                      .source = "its weight"},
                     s.mean, weight, 1e-3 * weight, "N");
    law::expect_below({.law = "robot stands: zero moment point from the center of mass, on the ground",
                       .level = words_of(GetParam()),
                       .source = "statics: none"},
                      1e3 * s.zmp, 0.1, "mm");
  }
}

// Back-EMF and gain of a servo whose rotor weighs nothing, made explicit, would need steps under 1 ms.
TEST(Servos, StandWithoutRotorInertiaAt4Milliseconds) {
  Rig rig(0.8, 3 * degree, 250);
  Entity& robot = rig.add("robot", kid21_with("rotor_inertia", 0));
  rig.simulation.attach<ArmSwinger>("arm_swinger", robot, 50, 1.0);
  rig.attach_dynamics(robot, {.level = "articulated_dynamics"});
  rig.run(1.0);
  const Vec3d place = Rig::place(robot);
  law::Worst moved;
  for (int i = 0; i < 1000; ++i) {
    rig.simulation.step();
    moved.see(1e3 * norm(Rig::place(robot) - place), "step", i);
  }
  EXPECT_FALSE(robot.frozen());
  law::expect_below({.law =
                         "robot without rotor inertia stands on 3 degrees and swings its arms: way of its base in 4 s",
                     .level = "articulated_dynamics, implicit_stick, steps of 4 ms",
                     .source = "servos are implicit: it stands, up to the swing of its arms"},
                    moved, 5, "mm");
}

}  // namespace
}  // namespace murosimf::test
