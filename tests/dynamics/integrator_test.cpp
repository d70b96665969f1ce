// One step of Runge-Kutta against its own series and quadrature, and which contacts go with which integrator.
#include "murosimf/dynamics/integrator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "murosimf/collision/contact_laws/implicit_stick_law.h"
#include "murosimf/collision/contact_laws/kelvin_voigt_law.h"
#include "tests/fixtures.h"

namespace murosimf::dynamics {
namespace {

using collision::ContactInterface;
using Numbers = std::vector<double>;

TEST(Integrators, HaveNames) {
  ASSERT_EQ(integrators().size(), 2U);
  EXPECT_EQ(integrators()[0].name, "semi_implicit_euler");
  EXPECT_EQ(integrators()[0].integrator, Integrator::semi_implicit_euler);
  EXPECT_EQ(integrators()[1].name, "rk4");
  EXPECT_EQ(integrators()[1].integrator, Integrator::rk4);
}

// y' = a y: a step multiplies by the first five terms of exp(a h). Tolerance: rounding.
TEST(RungeKutta4, StepIsTheSeriesOfFourthOrder) {
  RungeKutta4 method;
  const Numbers a{-1.5, 0.4, 2};
  Numbers y{1, -3, 0.5};
  const Numbers before = y;
  const double h = 0.3;
  method.step(y, h, [&](const Numbers& now, Numbers& rate) {
    for (std::size_t i = 0; i < 3; ++i) rate[i] = a[i] * now[i];
  });
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = a[i] * h;
    EXPECT_NEAR(y[i] / before[i], 1 + x + x * x / 2 + x * x * x / 6 + x * x * x * x / 24, 1e-15) << i;
  }
}

// With t' = 1 beside it, y' = f(t) is Simpson's rule: exact up to the third power. The working memory fits another size.
TEST(RungeKutta4, IntegratesAsSimpsonDoes) {
  RungeKutta4 method;
  Numbers more(5, 1.0), y{2, 7};
  method.step(more, 0.1, [](const Numbers&, Numbers& rate) { std::fill(rate.begin(), rate.end(), 1.0); });
  for (const double number : more) EXPECT_NEAR(number, 1.1, 1e-15);
  const double h = 0.5;
  method.step(y, h, [](const Numbers& now, Numbers& rate) { rate = {1, now[0] * now[0] * now[0]}; });
  EXPECT_NEAR(y[0], 2 + h, 1e-15);
  EXPECT_NEAR(y[1], 7 + (2.5 * 2.5 * 2.5 * 2.5 - 16) / 4, 1e-14);
}

// y' = A y with eigenvalues -0.4 +- 3i: the error falls with the fourth power of the step.
TEST(RungeKutta4, IsOfFourthOrder) {
  const auto error = [](int steps) {
    std::vector<double> y{1, 0};
    RungeKutta4 method;
    for (int i = 0; i < steps; ++i) {
      method.step(y, 1.0 / steps, [](const std::vector<double>& x, std::vector<double>& dx) {
        dx = {-0.4 * x[0] - 3 * x[1], 3 * x[0] - 0.4 * x[1]};
      });
    }
    return std::hypot(y[0] - std::exp(-0.4) * std::cos(3), y[1] - std::exp(-0.4) * std::sin(3));
  };
  EXPECT_LT(error(20), 2e-5);
  EXPECT_NEAR(std::log2(error(20) / error(40)), 4, 0.1);
}

std::string error(Integrator integrator, const ContactInterface& interface, double period = 1e-3) {
  return fixtures::error_of([&] { check_contacts(integrator, interface, period); });
}

TEST(CheckContacts, WantsOnePeriod) {
  ContactInterface interface;
  for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::rk4}) {
    interface.terms.dt = 0;
    EXPECT_EQ(error(integrator, interface, 2e-3), "no error") << "there is no contact";
    interface.terms.dt = 2e-3;
    EXPECT_EQ(error(integrator, interface, 2e-3), "no error");
    EXPECT_TRUE(fixtures::says(error(integrator, interface, 1e-3), {"steps of 1 ms", "contact of 2 ms"}));
  }
}

TEST(CheckContacts, RungeKuttaNeedsExplicitForces) {
  const collision::KelvinVoigt explicit_law;
  const collision::ImplicitStick implicit_law;
  EXPECT_EQ(error(Integrator::rk4, {}), "no error");
  EXPECT_EQ(error(Integrator::rk4, {.law = &explicit_law}), "no error");
  EXPECT_TRUE(fixtures::says(error(Integrator::rk4, {.law = &implicit_law}), {"'rk4' needs an explicit contact law"}));
  EXPECT_TRUE(fixtures::says(error(Integrator::rk4, {.law = &explicit_law, .damped_by_others = true}),
                             {"'rk4' does not go with 'carry'"}));
  EXPECT_EQ(error(Integrator::semi_implicit_euler, {.law = &implicit_law, .damped_by_others = true}), "no error");
}

}  // namespace
}  // namespace murosimf::dynamics
