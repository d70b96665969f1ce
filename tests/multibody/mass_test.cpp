#include <algorithm>

#include "murosimf/multibody/mass.h"

#include <gtest/gtest.h>

#include "murosimf/multibody/kinematics.h"
#include "tests/fixtures.h"
#include "tests/law.h"

namespace murosimf::multibody {
namespace {

using fixtures::Dice;
using fixtures::difference;
using fixtures::State;
using namespace properties;

CommonBody<double> common(const Model& model, const State<double>& s) {
  return common_body<double>(model.tree(), std::span<const Vec3d>(s.r), std::span<const Mat3d>(s.R),
                             std::span<const Vec3d>(s.v), std::span<const Vec3d>(s.w));
}

State<double> moving_state(const Model& model, Dice& dice) {
  State<double> s = fixtures::random_state(model, dice);
  poses<double>(model.tree(), s.q, s.r, s.R);
  velocities<double>(model.tree(), s.qd, s.r, s.R, s.v, s.w);
  return s;
}

/// One row about the common body.
void expect_kernel(const std::string& law, const std::string& source, const law::Measured& error, double limit,
                   const std::string& unit) {
  law::expect_below({.law = law, .level = "common body", .source = source}, error, limit, unit);
}

// Sums not over the merged links, and with the inertia taken about the common center directly. Tolerance: up to 30
// bodies, 40 kg, within 10 m, moving with up to 100 m/s: 1e-16 of the largest terms.
TEST(Mass, CommonBodyAgainstBruteForce) {
  law::Worst mass_error, center_error, velocity_error, inertia_error;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Model model = fixtures::random_model(seed);
    Dice dice("common body", seed);
    const State<double> s = moving_state(model, dice);
    const CommonBody<double> body = common(model, s);

    double m = 0;
    Vec3d first, momentum;
    for (const int i : model.having(mass)) {
      const double mi = *model.find(mass, i);
      const Vec3d* com = model.find(center_of_mass, i);
      const Vec3d arm = com ? s.R[i] * *com : Vec3d{};
      m += mi;
      first += mi * (s.r[i] + arm);
      momentum += mi * (s.v[i] + cross(s.w[i], arm));
    }
    const Vec3d center = (1 / m) * first;
    SymMat3d I;
    for (const int i : model.having(mass)) {
      const Vec3d* com = model.find(center_of_mass, i);
      const SymMat3d* own = model.find(inertia, i);
      I += *model.find(mass, i) * inertia_of_point(s.r[i] + (com ? s.R[i] * *com : Vec3d{}) - center);
      if (own) I += rotated(s.R[i], *own);
    }
    mass_error.see(std::abs(body.mass - m), "tree", seed);
    center_error.see(difference(body.center, center), "tree", seed);
    velocity_error.see(difference(body.velocity, (1 / m) * momentum), "tree", seed);
    inertia_error.see(difference(body.inertia, I), "tree", seed);
  }
  const std::string source = "sum over the bodies of the model";
  expect_kernel("random trees: error of the mass", source, mass_error, 1e-13, "kg");
  expect_kernel("random trees: error of the center of mass", source, center_error, 2e-14, "m");
  expect_kernel("random trees: error of the center's velocity", source, velocity_error, 2e-13, "m/s");
  expect_kernel("random trees: error of the inertia about the center", source, inertia_error, 1e-12, "kg m^2");
}

// Tolerance: central differences over 1e-5 s, as in kinematics_test.cpp.
TEST(Mass, CenterMovesWithItsVelocity) {
  const double h = 1e-5;
  const Model model = fixtures::two_legged();
  Dice dice("center moves");
  const State<double> s = moving_state(model, dice);
  const auto center_at = [&](double time) {
    State<double> next = s;
    next.r[0] += time * s.v[0];
    next.R[0] = to_matrix(exponential(time * s.w[0])) * s.R[0];
    for (const int joint : model.joints()) next.q[joint] += time * s.qd[joint];
    poses<double>(model.tree(), next.q, next.r, next.R);
    return common(model, next).center;
  };
  expect_kernel("two-legged robot: error of the center's velocity", "central differences of the center",
                difference(common(model, s).velocity, (0.5 / h) * (center_at(h) - center_at(-h))), 1e-7, "m/s");
}

// Tolerance: the moments are taken about the base, so a place 10 m away costs only the rounding of 10 m in the
// positions.
TEST(Mass, InertiaIsThatOfTheBody) {
  const Model model = fixtures::two_legged();
  Dice dice("invariants");
  State<double> s = moving_state(model, dice);
  const CommonBody<double> before = common(model, s);
  const Mat3d turn = dice.turn();
  const Vec3d away{10, -20, 5};
  s.r[0] = turn * s.r[0] + away;
  s.R[0] = turn * s.R[0];
  poses<double>(model.tree(), s.q, s.r, s.R);
  const CommonBody<double> after = common(model, s);
  expect_kernel("two-legged robot, moved and turned: error of the inertia", "R I R^T, independent of the place",
                difference(after.inertia, rotated(turn, before.inertia)), 1e-14, "kg m^2");
  expect_kernel("two-legged robot, moved and turned: error of the center", "R c + r",
                difference(after.center, turn * before.center + away), 1e-14, "m");
  EXPECT_EQ(after.mass, before.mass);
}

// In numbers worked out by hand: 3 kg; z of the center from 1.4 kg at 0.05 m, 2 x 0.4 kg at -0.10 m, 2 x 0.3 kg at
// -0.22 m, 2 x 0.1 kg at -0.31 m. Tolerance: rounding.
TEST(Mass, TwoLeggedByHand) {
  const Model model = fixtures::two_legged();
  State<double> s(model.size());
  poses<double>(model.tree(), s.q, s.r, s.R);
  const CommonBody<double> body = common(model, s);
  const Vec3d center{(0.6 * 0.01 + 0.2 * 0.02) / 3, 0, (1.4 * 0.05 - 0.8 * 0.10 - 0.6 * 0.22 - 0.2 * 0.31) / 3};
  EXPECT_NEAR(body.mass, 3, 1e-15);
  expect_kernel("two-legged robot, straight: error of the center", "worked out by hand",
                difference(body.center, center), 1e-16, "m");
  EXPECT_EQ(difference(body.velocity, {}), 0);
}

// v of the base is as the turning says. Tolerance: rounding.
TEST(Mass, TurningAboutTheCenter) {
  const Model model = fixtures::two_legged();
  Dice dice("turning");
  State<double> s = fixtures::random_state(model, dice);
  poses<double>(model.tree(), s.q, s.r, s.R);
  std::fill(s.qd.begin(), s.qd.end(), 0.0);
  s.v[0] = cross(s.w[0], s.r[0] - common(model, s).center);
  velocities<double>(model.tree(), s.qd, s.r, s.R, s.v, s.w);
  expect_kernel("two-legged robot turns about its center: velocity of the center", "it rests",
                difference(common(model, s).velocity, {}), 1e-15, "m/s");
}

}  // namespace
}  // namespace murosimf::multibody
