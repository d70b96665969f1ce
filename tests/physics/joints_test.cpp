// Mechanisms with free joints on a bolted base: closed forms of textbook mechanics.
#include <gtest/gtest.h>

#include "murosimf/collision/contact_properties.h"
#include "tests/fixtures.h"
#include "tests/law.h"
#include "tests/physics/bolted.h"

namespace murosimf::test {
namespace {

constexpr const char* level = "articulated_dynamics";

// 0.5 kg at 0.3 m below a hinge. Tolerance: 1e-3 at 1 ms.
TEST(Pendulum, HasThePeriodOfItsClosedForm) {
  const double m = 0.5, l = 0.3, I = 0.002, amplitude = 0.1;
  Bolted pendulum(Chain{}
                      .base("ceiling")
                      .revolute("hinge", {0, 1, 0})
                      .with(properties::mass, m)
                      .with(properties::center_of_mass, {0, 0, -l})
                      .with(properties::inertia, diagonal(I)));
  auto hinge = pendulum.joint("hinge");
  hinge.set(properties::joint_position, amplitude);
  double first = 0, last = 0, before = amplitude;
  int crossings = 0;
  for (int i = 1; i <= 10000; ++i) {
    pendulum.rig.simulation.step();
    const double q = hinge.get(properties::joint_position);
    if (q * before < 0) {
      last = 1e-3 * (i - q / (q - before));
      if (crossings++ == 0) first = last;
    }
    before = q;
  }
  const double period = 2 * (last - first) / (crossings - 1);
  const double closed = 2 * pi * std::sqrt((I + m * l * l) / (m * g * l)) * (1 + amplitude * amplitude / 16);
  law::expect_near({.law = "pendulum with an amplitude of 0.1 rad: period",
                    .level = level,
                    .source = "2 pi sqrt(I / (m g l)) (1 + amplitude^2 / 16)"},
                   period, closed, 1e-3 * closed, "s");
}

// Tolerance: 1000 additions.
TEST(Slider, AcceleratesUnderAConstantForce) {
  const double m = 0.8, force = 2.5;
  Bolted slider(Chain{}.base("wall").prismatic("rail", {1, 0, 0}).with(properties::mass, m));
  slider.joint("rail").set(properties::applied_force, Wrenchd{{}, {force, 0, 0}});
  slider.rig.run(1.0);
  law::expect_near({.law = "slider of 0.8 kg, pushed with 2.5 N: rate after 1 s", .level = level, .source = "F t / m"},
                   slider.joint("rail").get(properties::joint_velocity), force / m, 1e-9, "m/s");
}

/// A cart of M kg on a rail with a pendulum (m, l, I at its center); phi from hanging, positive towards +x.
struct CartPole {
  static constexpr double M = 0.8, m = 0.3, l = 0.25, I = 0.004;

  static Chain chain() {
    return Chain{}
        .base("wall")
        .prismatic("rail", {1, 0, 0})
        .with(properties::mass, M)
        .revolute("pole", {0, -1, 0})
        .with(properties::mass, m)
        .with(properties::center_of_mass, {0, 0, -l})
        .with(properties::inertia, diagonal(I));
  }
  /// (M + m) x'' + m l (phi'' cos phi - phi'^2 sin phi) = F
  /// m l x'' cos phi + (I + m l^2) phi'' = -m g l sin phi
  static std::pair<double, double> accelerations(double force, double phi, double rate) {
    const double a = M + m, b = m * l * std::cos(phi), d = I + m * l * l;
    const double right = force + m * l * rate * rate * std::sin(phi), turning = -m * g * l * std::sin(phi);
    const double determinant = a * d - b * b;
    return {(d * right - b * turning) / determinant, (a * turning - b * right) / determinant};
  }
};

// One step from each of 50 random states. Tolerance: rates of 3 /s, rounded, over 1 ms.
TEST(Slider, CartWithPoleAcceleratesAsLagrangeSays) {
  Bolted cart(CartPole::chain());
  auto rail = cart.joint("rail"), pole = cart.joint("pole");
  fixtures::Dice dice("cart");
  law::Worst error;
  for (int i = 0; i < 50; ++i) {
    const double force = dice.uniform(-5, 5), phi = dice.uniform(-pi, pi), rate = dice.uniform(-3, 3);
    rail.set(properties::applied_force, Wrenchd{{}, {force, 0, 0}});
    rail.set(properties::joint_velocity, 0);
    pole.set(properties::joint_position, phi);
    pole.set(properties::joint_velocity, rate);
    cart.rig.simulation.step();
    const auto [x, turn] = CartPole::accelerations(force, phi, rate);
    error.see(std::abs(rail.get(properties::joint_velocity) / 1e-3 - x), "cart, state", i);
    error.see(std::abs((pole.get(properties::joint_velocity) - rate) / 1e-3 - turn), "pole, state", i);
  }
  law::expect_below({.law = "cart with a pole under a force: error of the accelerations",
                     .level = level,
                     .source = "Lagrange's equations of the two coordinates"},
                    error, 1e-9, "m/s^2, rad/s^2");
}

}  // namespace
}  // namespace murosimf::test
