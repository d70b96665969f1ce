// Air slows balls down and bends the ways of those that spin.
#include "murosimf/air/air.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"
#include "tests/law.h"
#include "tests/physics/rig.h"
#include "tests/written_scene.h"

namespace murosimf::air {
namespace {

constexpr double g = 9.81, radius = 0.11, mass = 0.2, density = 1.2;

/// [1/m] of drag_coefficient c.
double drag_per_meter(double c) { return 0.5 * density * c * pi * radius * radius / mass; }

/// A ball in a scene, far above the ground.
struct Flight {
  explicit Flight(const std::string& more, double rate = 1000, const std::string& first = "")
      : scene(
            fixtures::write_scene(fmt::format("rate = {}\n{}\n[field]\ngoals = false\n[ball]\nradius = {}\nmass = {}\n"
                                              "position = [0, 0, 500]\n{}\n",
                                              rate, first, radius, mass, more))) {
    scene.simulation().initialize();
  }
  void run(double seconds) { scene.simulation().run(from_seconds(seconds)); }
  [[nodiscard]] ObjectAccess ball() { return scene.simulation().world().entity("ball").base(); }
  [[nodiscard]] Vec3d velocity() { return ball().get(properties::linear_velocity); }
  [[nodiscard]] Vec3d place() { return ball().get(properties::position); }
  void spin(const Vec3d& w) { ball().set(properties::angular_velocity, w); }
  scene::Scene scene;
};

TEST(Air, FallsWithItsTerminalVelocityAtAnyStep) {
  const double terminal = std::sqrt(g / drag_per_meter(0.5));
  law::Worst error;
  for (const double rate : {1000.0, 100.0, 20.0}) {
    Flight flight("", rate);
    flight.run(12);
    error.see(std::abs(flight.velocity().z + terminal), rate, "Hz");
  }
  law::expect_below(
      {.law = "ball falls for 12 s in air, steps of 1 to 50 ms: deviation from its terminal velocity of 13 m/s",
       .level = "simplified_dynamics",
       .source = "sqrt(2 m g / (rho C_d A))"},
      error, 1e-6, "m/s");
}

/// Largest deviation [m/s] of a ball that falls from rest, within 2 s.
double falling_error(double rate) {
  Flight flight("", rate);
  const double k = drag_per_meter(0.5), terminal = std::sqrt(g / k);
  double worst = 0;
  for (int i = 1; i <= 20; ++i) {
    flight.run(0.1);
    worst = std::max(worst, std::abs(flight.velocity().z + terminal * std::tanh(g * 0.1 * i / terminal)));
  }
  return worst;
}

TEST(Air, FallsAsTheClosedFormSaysAndBetterWithShorterSteps) {
  const double at_1_ms = falling_error(1000), at_10_ms = falling_error(100);
  law::expect_below({.law = "ball falls from rest in air for 2 s, steps of 1 ms: largest deviation of its speed",
                     .level = "simplified_dynamics",
                     .source = "v_t tanh(g t / v_t)"},
                    at_1_ms, 1e-5, "m/s");
  // In the constant pull of gravity the linearly implicit step is a Moebius map, as the exact solution is.
  law::expect_near({.law = "ball falls in air: error of steps of 10 ms over that of 1 ms",
                    .level = "simplified_dynamics",
                    .source = "second order: 100"},
                   at_10_ms / at_1_ms, 100, 1, "");
}

// The linearly implicit step solves dv/dt = -k v^2 exactly: 1 / v grows by k dt.
TEST(Air, SlowsDownExactlyAtAnyStep) {
  const double k = drag_per_meter(0.4), v = 30;
  law::Worst error;
  for (const double rate : {1000.0, 100.0, 20.0}) {
    Flight flight(fmt::format("velocity = [{}, 0, 0]\ndrag = 0.4", v), rate, "gravity = [0, 0, 0]");
    flight.run(2);
    error.see(std::abs(flight.velocity().x - v / (1 + k * v * 2)), rate, "Hz");
  }
  law::expect_below({.law = "ball of 30 m/s without gravity, 2 s, steps of 1 to 50 ms: deviation of its speed",
                     .level = "simplified_dynamics",
                     .source = "v / (1 + k v t)"},
                    error, 1e-10, "m/s");
}

/// Place after `seconds` of a spinning ball by Runge and Kutta's fourth order with steps of 0.1 ms, from the equations of air.h.
Vec3d integrated(Vec3d v, const Vec3d& w, double drag, double lift, const Vec3d& wind, double seconds) {
  const auto rate = [&](const Vec3d& velocity) {
    const Vec3d u = velocity - wind, side = cross(w, u);
    const double area = pi * radius * radius, speed = norm(u), spin = radius * norm(side) / (speed * speed);
    const double c_l = lift * spin / (spin + 0.172);
    return Vec3d{0, 0, -g} - (0.5 * density * drag * area * speed / mass) * u +
           (0.5 * density * c_l * area * speed * speed / mass / norm(side)) * side;
  };
  const double h = 1e-4;
  Vec3d r;
  for (int i = 0; i < std::lround(seconds / h); ++i) {
    const Vec3d a1 = rate(v), v2 = v + (h / 2) * a1, a2 = rate(v2), v3 = v + (h / 2) * a2, a3 = rate(v3);
    const Vec3d v4 = v + h * a3, a4 = rate(v4);
    r += (h / 6) * (v + 2.0 * v2 + 2.0 * v3 + v4);
    v += (h / 6) * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
  }
  return r;
}

/// [m] off after 1.5 s, of a free kick with spin about a slanted axis, in wind.
double curve_error(double rate) {
  const Vec3d v{25, 3, 8}, w{4, -11, 45}, wind{-2, 5, 0.5};
  Flight flight("velocity = [25, 3, 8]\ndrag = 0.25\nlift = 0.4", rate, "[air]\nwind = [-2, 5, 0.5]");
  const Vec3d start = flight.place();
  flight.spin(w);
  flight.run(1.5);
  return norm(flight.place() - start - integrated(v, w, 0.25, 0.4, wind, 1.5));
}

TEST(Air, BendsTheWayOfASpinningBallAsAFineIntegrationDoes) {
  const Vec3d straight = integrated({25, 3, 8}, {1e-9, 0, 0}, 0.25, 0.4, {-2, 5, 0.5}, 1.5);
  const Vec3d bent = integrated({25, 3, 8}, {4, -11, 45}, 0.25, 0.4, {-2, 5, 0.5}, 1.5);
  EXPECT_GT(norm(bent - straight), 2.0) << "spin does little here";
  const double at_1_ms = curve_error(1000), at_10_ms = curve_error(100);
  law::expect_below(
      {.law = "free kick of 26 m/s that spins about a slanted axis, in wind: place after 1.5 s, steps of 1 ms",
       .level = "simplified_dynamics",
       .source = "Runge-Kutta 4 with steps of 0.1 ms of the equations in air.h"},
      at_1_ms, 0.015, "m");
  law::expect_near({.law = "free kick: error of steps of 10 ms over that of 1 ms",
                    .level = "simplified_dynamics",
                    .source = "first order: 10"},
                   at_10_ms / at_1_ms, 10, 0.7, "");
}

// With lift alone, at steps in which it turns by up to 1.3 rad.
TEST(Air, LiftTurnsTheWayAndGivesNoEnergy) {
  law::Worst error;
  for (const double rate : {1000.0, 10.0}) {
    Flight flight("velocity = [30, 0, 5]\ndrag = 0\nlift = 10", rate, "gravity = [0, 0, 0]");
    const double speed = norm(flight.velocity());
    flight.spin({30, 80, 400});
    for (int i = 0; i < 20; ++i) {
      flight.run(0.1);
      error.see(std::abs(norm(flight.velocity()) / speed - 1), rate, "Hz");
    }
    EXPECT_LT(dot(flight.velocity(), Vec3d{30, 0, 5}), 0.99 * speed * speed) << "it does not turn";
  }
  law::expect_below({.law = "spinning ball without drag and gravity, 2 s: largest change of its speed, as a part",
                     .level = "simplified_dynamics",
                     .source = "lift is across the way: none"},
                    error, 1e-12, "");
}

// Against the sides of w x v: topspin dips, and a ball that spins counterclockwise as seen from above goes to the left.
TEST(Air, TopspinDipsAndSidespinGoesToTheSideOfTheFrontsMotion) {
  const RoundBody ball{.radius = radius, .mass = mass, .drag = 0, .lift = usual_lift};
  EXPECT_LT(air_force(density, ball, {10, 0, 0}, {0, 30, 0}, {}, 1e-3).z, -0.1);
  EXPECT_GT(air_force(density, ball, {10, 0, 0}, {0, 0, 30}, {}, 1e-3).y, 0.1);
  EXPECT_EQ(norm(air_force(density, ball, {10, 0, 0}, {300, 0, 0}, {}, 1e-3)), 0) << "a bullet's spin";
}

// Law: 1/2 rho C_l A v^2, C_l = lift S / (S + 0.172) with S = r w / v = 0.33: 0.2828 of C_l.
TEST(Air, LiftHasTheSizeOfItsCoefficient) {
  const RoundBody ball{.radius = radius, .mass = mass, .drag = 0, .lift = 0.43};
  const double force = norm(air_force(density, ball, {10, 0, 0}, {0, 0, 30}, {}, 1e-6));
  EXPECT_NEAR(force / (0.5 * density * pi * radius * radius * 100), 0.43 * 0.33 / 0.502, 1e-6);
}

TEST(Air, DoesNothingAtRestAndNothingWithoutDensity) {
  const RoundBody ball{.radius = radius, .mass = mass, .drag = 0.5, .lift = 0.43};
  EXPECT_EQ(norm(air_force(density, ball, {}, {0, 0, 50}, {0, 0, -g}, 1e-3)), 0);
  EXPECT_EQ(norm(air_force(0, ball, {10, 0, 0}, {0, 0, 50}, {0, 0, -g}, 1e-3)), 0);
  const auto resting = [](const std::string& more) {
    scene::Scene scene(fixtures::write_scene("[ball]\nposition = [0, 0, 0]\n" + more));
    scene.simulation().run(from_seconds(3));
    return scene.simulation().world().entity("ball").base().get(properties::position);
  };
  EXPECT_LT(norm(resting("[air]\ndensity = 1.2\n") - resting("[air]\ndensity = 0\n")), 1e-12);
}

// A step of 0.1 s in which explicit drag would throw it back with 30 times its speed.
TEST(Air, IsStableForALightBallAtALongStep) {
  const RoundBody balloon{.radius = 0.2, .mass = 0.005, .drag = 0.5, .lift = 0.43};
  Vec3d v{30, 0, 0};
  for (int i = 0; i < 100; ++i) {
    const double before = norm(v);
    v += (0.1 / balloon.mass) * air_force(density, balloon, v, {0, 0, 100}, {}, 0.1);
    EXPECT_LT(norm(v), before);
  }
}

TEST(Air, WindTakesABallAlong) {
  Flight flight("", 1000, "gravity = [0, 0, 0]\n[air]\nwind = [3, -4, 0]");
  flight.run(60);
  const double k = drag_per_meter(0.5);
  law::expect_near({.law = "ball in wind of 5 m/s, without gravity: its speed after 60 s",
                    .level = "simplified_dynamics",
                    .source = "w - w / (1 + k w t)"},
                   dot(flight.velocity(), Vec3d{0.6, -0.8, 0}), 5 - 5 / (1 + k * 5 * 60), 1e-9, "m/s");
}

// [[bodies]]: spheres feel it, with their own numbers.
TEST(Air, SlowsDownSpheresAmongBodies) {
  const auto speed_after_1_s = [](const std::string& keys) {
    scene::Scene scene(fixtures::write_scene(
        "gravity = [0, 0, 0]\n[field]\ngoals = false\n[[bodies]]\nname = 's'\nradius = 0.11\nshape = 'sphere'\n"
        "mass = 0.2\nposition = [0, 0, 50]\nvelocity = [20, 0, 0]\n" +
        keys));
    scene.simulation().run(from_seconds(1));
    return scene.simulation().world().entity("s").base().get(properties::linear_velocity).x;
  };
  EXPECT_NEAR(speed_after_1_s(""), 20 / (1 + drag_per_meter(0.5) * 20), 1e-9);
  EXPECT_NEAR(speed_after_1_s("drag = 0.2\n"), 20 / (1 + drag_per_meter(0.2) * 20), 1e-9);
  EXPECT_EQ(speed_after_1_s("drag = 0\n"), 20);
}

TEST(Air, TakesTheBallThatAnEventBrings) {
  Flight flight("velocity = [20, 0, 0]\ndrag = 0\n[[events]]\ntime = 1\nset = ['ball.drag = 0.5']", 1000,
                "gravity = [0, 0, 0]");
  flight.run(1);
  EXPECT_EQ(flight.velocity().x, 20);
  flight.run(1);
  EXPECT_NEAR(flight.velocity().x, 20 / (1 + drag_per_meter(0.5) * 20), 1e-2);
}

TEST(Air, IsTheSameForAnyNumberOfThreads) {
  const auto hash = [](int threads) {
    std::string text = "[ball]\nposition = [0, 0, 1]\nvelocity = [9, 1, 4]\n[air]\nwind = [1, 2, 0]\n";
    for (int i = 0; i < 12; ++i) {
      text += fmt::format(
          "[[bodies]]\nname = 's{0}'\nshape = 'sphere'\nradius = 0.1\nmass = 0.3\nposition = [{0}, 2, 1]\n"
          "velocity = [{0}, -3, 2]\nangular_velocity = [0, {0}, 20]\n",
          i);
    }
    scene::Scene scene(fixtures::write_scene(text), {.threads = threads});
    scene.simulation().run(from_seconds(1.5));
    return scene.simulation().state_hash();
  };
  EXPECT_EQ(hash(1), hash(3));
}

// Nothing is ignored in silence.
TEST(Air, IsMissedWhereNothingFeelsIt) {
  const auto warned = [](const std::string& text, const std::string& words) {
    scene::Scene scene(fixtures::write_scene(text));
    const std::vector<std::string> lines = scene::make_report(scene).warnings;
    return std::ranges::any_of(lines, [&](const std::string& line) { return line.find(words) != std::string::npos; });
  };
  const std::string box = "[[bodies]]\nname = 'b'\nshape = 'box'\nsize = [1, 1, 1]\nmass = 1\n";
  EXPECT_TRUE(warned("air.wind = [1, 0, 0]\n" + box, "[air] changes nothing"));
  EXPECT_FALSE(warned(box, "air"));
  EXPECT_FALSE(warned("air.wind = [1, 0, 0]\n[ball]\n" + box, "air"));
  EXPECT_TRUE(warned("air.wind = [1, 0, 0]\nair.density = 0\n[ball]\n", "'wind' changes nothing"));
  EXPECT_THROW(warned(box + "drag = 0.5\n", ""), SetupError) << "drag of a box";
}

// Eight balls of one model are stepped together.
TEST(Air, IsTheSameInLanes) {
  const auto hash = [](bool lanes) {
    test::Rig rig;
    rig.simulation.use_lanes(lanes);
    const ModelPtr model = scene_file::ball_model();
    std::vector<Entity*> balls;
    for (int i = 0; i < 8; ++i) {
      balls.push_back(&rig.add(fmt::format("ball{}", i), model, {.position = {i * 1.0, 0, 0.5}}));
      rig.attach_ground(*balls.back(), {});
      rig.simulation.attach<Air>("air", *balls.back(), rig.rate, AirOptions{.wind = {1, 0, 0}});
    }
    for (Entity* ball : balls) {
      rig.simulation.attach<dynamics::SimplifiedDynamics>("simplified_dynamics", *ball, rig.rate);
    }
    rig.simulation.initialize();
    for (int i = 0; i < 8; ++i) test::Rig::launch(*balls[i], {3.0 + i, -2, 4}, {0, 10.0 * i, 30});
    rig.run(1);
    return rig.simulation.state_hash();
  };
  EXPECT_EQ(hash(true), hash(false));
}

}  // namespace
}  // namespace murosimf::air
