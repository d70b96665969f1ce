// A ball on the ground: sliding, rolling, bouncing.
#include <gtest/gtest.h>

#include "murosimf/collision/touches.h"
#include "tests/law.h"
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

class Ball : public testing::TestWithParam<LevelAndLaw> {};
INSTANTIATE_TEST_SUITE_P(Contact, Ball, at_every_level({"implicit_stick", "island_gauss_seidel", "kelvin_voigt"}),
                         test_name);

// Whatever the friction.
TEST_P(Ball, RollsWithFiveSeventhsOfItsSpeed) {
  Rig rig(0.3);
  Entity& ball = rig.add("ball", scene_file::ball_model({.material = ""}));
  rig.materials.set("", "", {.friction = 0.3});
  rig.attach_dynamics(ball, dynamics(GetParam()));
  rig.run(0.5);
  Rig::launch(ball, {1, 0, 0});
  rig.run(1.0);
  const double rolling = Rig::velocity(ball).x;
  const std::string level = words_of(GetParam());
  law::expect_near({.law = "solid ball slides with 1 m/s: speed when it rolls",
                    .level = level,
                    .source = "angular momentum about the ground: 5/7"},
                   rolling, 5.0 / 7.0, 1e-4, "m/s");
  law::expect_near({.law = "solid ball rolls: rate less speed over radius", .level = level, .source = "no slip: none"},
                   ball.base().get(properties::angular_velocity).y - rolling / 0.05, 0, 1e-3, "rad/s");
  rig.run(1.0);
  law::expect_near({.law = "solid ball rolls without resistance: change of speed in 1 s",
                    .level = level,
                    .source = "nothing brakes it: none"},
                   Rig::velocity(ball).x - rolling, 0, 1e-6, "m/s");
}

// Then it stays there.
TEST_P(Ball, RollingResistanceBringsItToRest) {
  const double c = 0.03;
  Rig rig(0.8);
  rig.materials.set("", "", {.friction = 0.8, .rolling = c});
  Entity& ball = rig.add("ball", scene_file::ball_model({.material = ""}));
  rig.attach_dynamics(ball, dynamics(GetParam()));
  rig.run(0.5);
  const double radius = 0.05, v = 0.7;
  Rig::launch(ball, {v, 0, 0}, {0, v / radius, 0});
  rig.run(1.0);
  law::expect_near({.law = "rolling resistance of 0.03: speed of a solid ball after 1 s, from 0.7 m/s",
                    .level = words_of(GetParam()),
                    .source = "v - 5/7 c g t"},
                   Rig::velocity(ball).x, v - 5.0 / 7.0 * c * g, 0.01 * v, "m/s");
  rig.run(9.0);
  law::expect_below({.law = "rolling resistance of 0.03: speed of a solid ball after 10 s",
                     .level = words_of(GetParam()),
                     .source = "it comes to rest"},
                    norm(Rig::velocity(ball)), 1e-3, "m/s");
}

/// Speed kept by a ball that meets the ground with 3 m/s, without gravity, starting `height` [m] above it.
double bounce(const LevelAndLaw& names, double restitution, double height, double rate_hz = 1000) {
  Rig rig(0.8, 0, rate_hz);
  rig.simulation.world().gravity = {};
  rig.materials.set("", "", {.restitution = restitution});
  Entity& ball = rig.add("ball", scene_file::ball_model({.material = ""}), {.position = {0, 0, height}});
  rig.attach_dynamics(ball, dynamics(names));
  rig.simulation.initialize();
  Rig::launch(ball, {0, 0, -3});
  rig.run(0.3);
  return Rig::velocity(ball).z / 3;
}

// Laws that are implicit bounce by an impulse: right in every single bounce, a dead ball's to 0.005 (bounce.h). On the spring of an
// explicit law, which keeps 0.15 at least, a bounce scatters by up to 8 % at 1 ms, where steps are 1/20 of it, and is right within 5 %
// on the average over where in a step the ball touches.
TEST_P(Ball, BouncesWithTheRestitutionOfItsMaterials) {
  const bool on_a_spring = std::get<1>(GetParam()) == "kelvin_voigt";
  for (const double ms : {0.5, 1.0, 2.0, 5.0, 8.0, 10.0}) {
    law::Worst error, average_error;
    for (const double e : {0.0, 0.3, 0.4, 0.6, 0.8, 0.9, 1.0}) {
      double sum = 0;
      constexpr int phases = 10;
      for (int i = 0; i < phases; ++i) {
        const double kept = bounce(GetParam(), e, 3e-3 * ms * (1 + i / double{phases}), 1000.0 / ms);
        error.see(std::abs(kept - e), "restitution", e, "phase", i);
        sum += kept;
      }
      if (e > 0.15) average_error.see(std::abs(sum / phases / e - 1), "restitution", e);
    }
    if (on_a_spring) {
      law::expect_below(
          {.law = fmt::format("ball bounces in steps of {} ms: error of the speed that it keeps, on the average", ms),
           .level = words_of(GetParam()) + ", restitution 0.3 to 1",
           .source = "closed form of a damped spring that cannot pull"},
          average_error, 0.05, "1");
    } else {
      law::expect_below({.law = fmt::format("ball bounces in steps of {} ms: error of the restitution", ms),
                         .level = words_of(GetParam()) + ", restitution 0 to 1",
                         .source = "Newton's law of impact; 0 counts as 0.005"},
                        error, 5.1e-3, "1");
    }
  }
}

/// The lowest force [N] along the normal that level ground has on something that falls on it from 0.3 m, in 1 s.
double lowest_ground_force(const LevelAndLaw& names, const ModelPtr& model, double rate_hz) {
  Rig rig(0.8, 0, rate_hz);
  Entity& thing = rig.add("thing", model, {.position = {0, 0, 0.35}});
  rig.attach_dynamics(thing, dynamics(names));
  rig.simulation.initialize();
  double lowest = 0, highest = 0;
  for (int i = 0; i < std::lround(rate_hz); ++i) {
    rig.simulation.step();
    for (const auto& touch : collision::touches(rig.simulation.world(), thing)) {
      lowest = std::min(lowest, touch.force.z);
      highest = std::max(highest, touch.force.z);
    }
  }
  EXPECT_GT(highest, 0) << "it has touched";
  return lowest;
}

// The damper alone would pull a body back that leaves.
TEST_P(Ball, NothingSticksToTheGround) {
  law::Worst pull;
  for (const double rate : {2000.0, 1000.0, 200.0, 125.0}) {
    if (std::get<1>(GetParam()) == "kelvin_voigt" && rate < 1000) continue;  // its spring is explicit
    pull.see(-lowest_ground_force(GetParam(), scene_file::ball_model({.material = ""}), rate), "ball", rate);
    pull.see(-lowest_ground_force(GetParam(), box_model(), rate), "box", rate);
  }
  law::expect_below({.law = "ball and box fall from 0.3 m: largest force with which the ground pulls",
                     .level = words_of(GetParam()) + ", 0.5 to 8 ms",
                     .source = "contact pushes only"},
                    pull, 1e-9, "N");
}

/// The largest height [m] of a ball in the second half of a minute, that has fallen from 1 m.
double height_in_the_end(const LevelAndLaw& names, double rate_hz) {
  Rig rig(0.8, 0, rate_hz);
  rig.materials.set("", "", {.restitution = 1});
  Entity& ball = rig.add("ball", scene_file::ball_model({.material = ""}), {.position = {0, 0, 1}});
  rig.attach_dynamics(ball, dynamics(names));
  rig.simulation.initialize();
  const double ground = Rig::place(ball).z - 1;
  double highest = 0;
  for (int i = 0; i < std::lround(60 * rate_hz); ++i) {
    rig.simulation.step();
    if (i > 30 * rate_hz) highest = std::max(highest, Rig::place(ball).z - ground);
  }
  return highest;
}

// It was 1.24 m after a minute of steps of 5 ms.
TEST_P(Ball, NeverGainsEnergy) {
  if (std::get<1>(GetParam()) == "kelvin_voigt") return;  // its spring is explicit
  for (const int ms : {2, 5, 8}) {
    law::expect_near(
        {.law = fmt::format("ball of restitution 1 falls from 1 m, steps of {} ms: highest after 30 to 60 s", ms),
         .level = words_of(GetParam()),
         .source = "energy: as high as at first"},
        height_in_the_end(GetParam(), 1000.0 / ms), 1, 2e-3, "m");
  }
}

// A dead ball stays down: on its spring alone it rose to 2.5 cm.
TEST_P(Ball, WithoutRestitutionStaysDown) {
  if (std::get<1>(GetParam()) == "kelvin_voigt") return;  // its largest damping ratio keeps 0.15
  for (const int ms : {1, 5, 10}) {
    Rig rig(0.8, 0, 1000.0 / ms);
    rig.materials.set("", "", {.restitution = 0});
    Entity& ball = rig.add("ball", scene_file::ball_model({.material = ""}), {.position = {0, 0, 1}});
    rig.attach_dynamics(ball, dynamics(GetParam()));
    rig.run(0.5);
    const double ground = 0.05;
    double highest = 0;
    for (int i = 0; i < 500 / ms; ++i) {
      rig.simulation.step();
      highest = std::max(highest, Rig::place(ball).z - ground);
    }
    law::expect_below({.law =
                           fmt::format("ball of restitution 0 falls from 1 m, steps of {} ms: how high it rises", ms),
                       .level = words_of(GetParam()),
                       .source = "not at all"},
                      highest, 1e-4, "m");
  }
}

/// How far [m] a solid ball rolls that begins with `v` [m/s] along x, and the same of its way to the side, on a pile that leans along
/// `pile` with an anisotropy of 0.25; resistance 0.05 across it.
Vec3d way_on_a_pile(const LevelAndLaw& names, const Vec3d& pile, double v, double rate_hz) {
  const double radius = 0.05;
  Rig rig(Surface{"turf", 0, pile}, 0, rate_hz);
  rig.materials.set("turf", "ball", {.friction = 0.8, .rolling = 0.05, .rolling_anisotropy = 0.25});
  Entity& ball = rig.add("ball", scene_file::ball_model({.material = "ball"}));
  rig.attach_dynamics(ball, dynamics(names));
  rig.run(0.5);
  const Vec3d start = Rig::place(ball);
  Rig::launch(ball, {v, 0, 0}, {0, v / radius, 0});
  rig.run(5);
  EXPECT_LT(norm(Rig::velocity(ball)), 1e-3);
  return Rig::place(ball) - start;
}

// With a = 5/7 c (1 - g cos) g0 the way is v^2 / (2 a); where it turns more slowly than 0.5 rad/s resistance fades, which takes as long
// again as the last v_s^2 / (2 a), v_s = 25 mm/s: 1 mm. Tolerance: that, and half of the first step, v dt / 2.
TEST_P(Ball, RollsFartherAlongThePileThanAgainstIt) {
  const double v = 0.7, across = 5.0 / 7.0 * 0.05 * g;
  law::Worst error, aside;
  for (const int ms : {1, 5}) {
    if (std::get<1>(GetParam()) == "kelvin_voigt" && ms > 1) continue;  // its spring is explicit
    for (const auto& [pile, share] :
         {std::pair{Vec3d{1, 0, 0}, 0.75}, {Vec3d{0, 1, 0}, 1.0}, {Vec3d{-2, 0, 0}, 1.25}}) {
      const Vec3d way = way_on_a_pile(GetParam(), pile, v, 1000.0 / ms);
      error.see(std::abs(way.x - v * v / (2 * across * share)), "share", share, "ms", ms);
      aside.see(std::abs(way.y), "share", share, "ms", ms);
    }
  }
  law::expect_below({.law =
                         "ball of 0.7 m/s rolls with, across and against a pile of anisotropy 0.25: error of its way",
                     .level = words_of(GetParam()),
                     .source = "v^2 / (10/7 c (1 - g cos a) g0): 0.93, 0.70, 0.56 m"},
                    error, 4e-3, "m");
  law::expect_below({.law = "ball of 0.7 m/s rolls with, across and against a pile: way to the side",
                     .level = words_of(GetParam()),
                     .source = "the pile turns no ball"},
                    aside, 1e-3, "m");
}

// Law: spinning on the spot ends after I w / (torsional m g), I = 2/5 m r^2.
TEST_P(Ball, TorsionalFrictionEndsItsSpin) {
  const double radius = 0.05, spin = 10, torsional = 0.002;
  Rig rig(0.8);
  rig.materials.set("", "", {.friction = 0.8, .rolling = 0.05, .torsional = torsional});
  Entity& ball = rig.add("ball", scene_file::ball_model({.material = ""}));
  rig.attach_dynamics(ball, dynamics(GetParam()));
  rig.run(0.5);
  Rig::launch(ball, {}, {0, 0, spin});
  rig.run(0.2);
  law::expect_near({.law = "solid ball spins on the spot, torsional 2 mm: rate after 0.2 s, from 10 rad/s",
                    .level = words_of(GetParam()),
                    .source = "w - torsional g t / (2/5 r^2)"},
                   ball.base().get(properties::angular_velocity).z,
                   spin - torsional * g * 0.2 / (0.4 * radius * radius), 0.01 * spin, "rad/s");
  rig.run(1.0);
  EXPECT_LT(std::abs(ball.base().get(properties::angular_velocity).z), 1e-2);
}

}  // namespace
}  // namespace murosimf::test
