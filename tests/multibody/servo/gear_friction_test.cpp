#include "murosimf/multibody/servo/gear_friction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "murosimf/math/pack.h"
#include "tests/fixtures.h"
#include "tests/physics/friction_sets.h"

namespace murosimf::multibody {
namespace {

using fixtures::Dice;
using fixtures::same_bits;

/// The budget as the paper writes it, with the library's exp and pow.
double by_the_book(const GearFriction& k, double w, double m, double e) {
  const double s = k.stribeck_rate > 0 ? std::exp(-std::pow(std::fabs(w) / k.stribeck_rate, k.stribeck_exponent)) : 0;
  const double larger =
      std::fabs(m) < std::fabs(e) ? k.quadratic_motor_load * m * m : k.quadratic_external_load * e * e;
  const double q = m * e < 0 ? larger : 0;
  return k.coulomb + std::fabs(k.motor_load * m - k.external_load * e) +
         s * (k.stribeck + std::fabs(k.stribeck_motor_load * m - k.stribeck_external_load * e) + q);
}

GearFriction random_friction(Dice& dice) {
  return {.coulomb = dice.uniform(0, 0.1),
          .viscous = dice.uniform(0, 0.1),
          .stribeck = dice.uniform(0, 0.1),
          .stribeck_rate = dice.uniform(0.02, 3),
          .stribeck_exponent = dice.chance(0.2) ? 1 : dice.uniform(0.5, 10),
          .motor_load = dice.chance(0.3) ? 0 : dice.uniform(0, 0.5),
          .external_load = dice.chance(0.3) ? 0 : dice.uniform(0, 0.5),
          .stribeck_motor_load = dice.chance(0.3) ? 0 : dice.uniform(0, 0.5),
          .stribeck_external_load = dice.chance(0.3) ? 0 : dice.uniform(0, 0.5),
          .quadratic_motor_load = dice.chance(0.3) ? 0 : dice.uniform(0, 0.1),
          .quadratic_external_load = dice.chance(0.3) ? 0 : dice.uniform(0, 0.1)};
}

// Law: the budget is the paper's, for any numbers. Tolerance: what counts as gone, exp(-20) of at most 2 N m.
TEST(JointFriction, IsThePapersBudget) {
  Dice dice("budget");
  for (int i = 0; i < 100000; ++i) {
    const GearFriction k = random_friction(dice);
    const double w = dice.uniform(-6, 6), m = dice.uniform(-2, 2), e = dice.uniform(-2, 2);
    ASSERT_NEAR(dry_friction(k, w, m, e), by_the_book(k, w, m, e), 4.2e-9);
  }
}

// Law: M1 is a constant, and viscous friction is not in the budget.
TEST(JointFriction, OfCoulombIsAConstant) {
  const GearFriction k{.coulomb = 0.01283, .viscous = 0.00366};
  for (const double w : {-10.0, 0.0, 1e-9, 3.0}) EXPECT_EQ(dry_friction(k, w, 0.3, -0.2), 0.01283);
}

// Law: M3 takes the load's share of the torque that goes through the gear: |tau_m - tau_e|.
TEST(JointFriction, FollowsTheTransmittedLoad) {
  const GearFriction k{.coulomb = 0.01, .motor_load = 0.1, .external_load = 0.1};
  EXPECT_DOUBLE_EQ(dry_friction(k, 1.0, 0.5, -0.5), 0.01 + 0.1);
  EXPECT_DOUBLE_EQ(dry_friction(k, 1.0, 0.5, 0.5), 0.01);
}

// Law: each part that the Stribeck curve multiplies counts by itself, also where all others are 0. At |w| = v_s, tau_m and
// tau_e against each other, either of them the larger one.
TEST(JointFriction, EveryRisingPartCountsAlone) {
  const GearFriction base{.coulomb = 0.01, .stribeck_rate = 0.5, .stribeck_exponent = 2};
  for (const auto part :
       {&GearFriction::stribeck, &GearFriction::stribeck_motor_load, &GearFriction::stribeck_external_load,
        &GearFriction::quadratic_motor_load, &GearFriction::quadratic_external_load}) {
    GearFriction k = base;
    k.*part = 0.2;
    double most = 0;
    for (const auto& [m, e] : {std::pair{0.3, -0.7}, {-0.7, 0.3}}) {
      EXPECT_NEAR(dry_friction(k, -0.5, m, e), by_the_book(k, -0.5, m, e), 1e-12);
      most = std::max(most, dry_friction(k, -0.5, m, e));
    }
    EXPECT_GT(most, 0.012);
  }
}

// Law: the Stribeck part is whole at rest, 1/e of itself at v_s, gone at many times v_s.
TEST(JointFriction, FallsWithTheRate) {
  for (const double alpha : {0.5, 1.0, 2.0, 8.0}) {
    const GearFriction k{.stribeck = 0.2, .stribeck_rate = 0.5, .stribeck_exponent = alpha};
    EXPECT_EQ(dry_friction(k, 0.0, 0.0, 0.0), 0.2);
    EXPECT_NEAR(dry_friction(k, -0.5, 0.0, 0.0), 0.2 / std::exp(1.0), 1e-15);
    EXPECT_EQ(dry_friction(k, 1000.0, 0.0, 0.0), 0.0);
  }
}

// Rule: from |w/v_s|^alpha = 20 on nothing is left, be it found by the power or by a shortcut; before, it is exp(-20).
TEST(JointFriction, IsGoneFromTwentyOn) {
  for (const double alpha : {0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 8.0}) {
    const GearFriction k{.stribeck = 0.2, .stribeck_rate = 0.5, .stribeck_exponent = alpha};
    const auto left_at = [&](double x) { return dry_friction(k, 0.5 * std::pow(x, 1 / alpha), 0.0, 0.0); };
    EXPECT_NEAR(left_at(19.999), 0.2 * std::exp(-19.999), 1e-14) << alpha;
    for (const double x : {20.001, 20.5, 21.5, 50.0}) EXPECT_EQ(left_at(x), 0) << alpha << ' ' << x;
  }
}

// Rule: a rate below which a gear counts as sticking, 0.01 rad/s, is the least that v_s may be.
TEST(JointFriction, HasALeastStribeckRate) {
  const GearFriction k{.stribeck = 0.2, .stribeck_rate = 1e-4, .stribeck_exponent = 1};
  EXPECT_NEAR(dry_friction(k, 0.01, 0.0, 0.0), 0.2 / std::exp(1.0), 1e-15);
}

// Rule: without v_s nothing is more at rest.
TEST(JointFriction, WithoutARateHasNoStribeckPart) {
  EXPECT_EQ(dry_friction(GearFriction{.coulomb = 0.1, .stribeck = 0.2}, 0.0, 0.0, 0.0), 0.1);
}

// Law: a mirrored joint has the same friction, bit for bit: left and right legs mirror each other.
TEST(JointFriction, IsTheSameInBothDirections) {
  Dice dice("mirror");
  for (int i = 0; i < 10000; ++i) {
    const GearFriction k = random_friction(dice);
    const double w = dice.uniform(-6, 6), m = dice.uniform(-2, 2), e = dice.uniform(-2, 2);
    ASSERT_TRUE(same_bits(dry_friction(k, w, m, e), dry_friction(k, -w, -m, -e)));
  }
}

// Rule: a lane has the bits of the scalar, among lanes at rest, fast lanes and NaN. No tolerance.
TEST(JointFriction, LanesAreScalars) {
  Dice dice("friction lanes");
  const std::array rates{0.0, -0.0, 1e-12, 1.0, -3.0, 200.0, std::numeric_limits<double>::quiet_NaN(), 40.0};
  for (int i = 0; i < 20000; ++i) {
    const GearFriction k = i == 0 ? test::published_m6 : random_friction(dice);
    Pack8 w, m, e;
    for (int lane = 0; lane < Pack8::lanes; ++lane) {
      w.set_lane(lane, dice.chance(0.7) ? rates[static_cast<std::size_t>(dice.pick(8))] : dice.uniform(-3, 3));
      m.set_lane(lane, dice.uniform(-2, 2));
      e.set_lane(lane, dice.uniform(-2, 2));
    }
    const Pack8 budget = dry_friction(k, w, m, e);
    for (int lane = 0; lane < Pack8::lanes; ++lane) {
      ASSERT_TRUE(same_bits(budget.lane(lane), dry_friction(k, w.lane(lane), m.lane(lane), e.lane(lane)))) << lane;
    }
  }
}

// Rule: shares that are computed eight at a time, of joints with gears of their own, have the bits of those computed alone; a
// gear without Stribeck part writes none. No tolerance.
TEST(JointFriction, SharesOfManyJointsAreThoseOfEach) {
  Dice dice("shares");
  const std::array rates{0.0, -0.0, 1e-12, 1.0, -3.0, 200.0, std::numeric_limits<double>::quiet_NaN(), 40.0};
  for (int round = 0; round < 2000; ++round) {
    std::vector<GearFriction> gears(static_cast<std::size_t>(1 + dice.pick(21)));
    std::vector<double> rate(gears.size()), share(gears.size(), -1.0);
    StribeckShares shares;
    for (std::size_t i = 0; i < gears.size(); ++i) {
      gears[i] = dice.chance(0.2) ? GearFriction{.coulomb = 0.1} : random_friction(dice);
      rate[i] = dice.chance(0.3) ? rates[static_cast<std::size_t>(dice.pick(8))] : dice.uniform(-3, 3);
      shares.add(gears[i], rate[i], share[i]);
    }
    shares.write();
    for (std::size_t i = 0; i < gears.size(); ++i) {
      const double alone = gears[i].stribeck_rate > 0 ? stribeck_share(gears[i], rate[i]) : -1.0;
      ASSERT_TRUE(same_bits(share[i], alone)) << i << " of " << gears.size() << ", rate " << rate[i];
    }
  }
}

}  // namespace
}  // namespace murosimf::multibody
