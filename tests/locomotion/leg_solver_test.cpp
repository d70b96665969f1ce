// Inverse kinematics of chains of hinges against direct kinematics and against the closed form.
#include "murosimf/locomotion/leg_solver.h"

#include <gtest/gtest.h>

#include "murosimf/locomotion/gait_seed.h"
#include "murosimf/math/quaternion.h"
#include "murosimf/math/random.h"
#include "tests/law.h"
#include "tests/locomotion/chains.h"
#include "tests/physics/rig.h"

namespace murosimf::locomotion {
namespace {

using test::TestHinge;

struct Sort {
  std::string name;
  std::vector<TestHinge> hinges;
};
std::vector<Sort> sorts() {
  return {{"hip pitch, roll, yaw", test::pitch_roll_yaw()},
          {"hip yaw, roll, pitch with offsets", test::offset_yaw_roll_pitch()},
          {"hip slanted", test::slanted_hip()},
          {"five hinges", test::five_hinges()}};
}

Leg leg_of(const std::vector<TestHinge>& hinges) {
  const Model model = test::legged("made_up", hinges, {0.02, 0.005, -0.04}, false);
  return find_leg(model, model.having(properties::sole)[0]);
}

double angle_between(const Mat3d& a, const Mat3d& b) { return norm(rotation_vector(from_matrix(a * transpose(b)))); }

/// Input of `bend` for which the leg gets angles q.
FootTarget target_at(const Leg& leg, std::span<const double> q) {
  const ChainPose pose = pose_of(leg.chain, q);
  return {.ankle = pose.tip - leg.hip, .sole = pose.sole};
}

/// Postures with a bent knee, within `share` of all ranges and 1.2 rad.
std::vector<double> random_posture(const Leg& leg, const RandomStream& random, std::uint64_t& n, double share) {
  std::vector<double> q;
  for (std::size_t i = 0; i < leg.joints.size(); ++i) {
    const LegHinge& hinge = leg.chain.hinges[i];
    const double low = std::max(hinge.lowest, leg.home[i] - 1.2), high = std::min(hinge.highest, leg.home[i] + 1.2);
    q.push_back(
        random.uniform(n++, leg.home[i] + share * (low - leg.home[i]), leg.home[i] + share * (high - leg.home[i])));
  }
  return q;
}

// From home; angles may differ from those drawn, the place of the foot must not.
TEST(LegSolver, PutsTheFootWhereDirectKinematicsHadIt) {
  for (const auto& [name, hinges] : sorts()) {
    const Leg leg = leg_of(hinges);
    ASSERT_FALSE(leg.signs) << name;
    const RandomStream random(1, name);
    std::uint64_t n = 0;
    law::Worst distance, angle, beyond;
    for (int i = 0; i < 1000; ++i) {
      const FootTarget target = target_at(leg, random_posture(leg, random, n, 0.7));
      std::vector<double> q = leg.home;
      EXPECT_TRUE(bend(leg, target, q)) << name << ' ' << i;
      const FootTarget found = target_at(leg, q);
      distance.see(norm(found.ankle - target.ankle), "posture", i);
      angle.see(angle_between(found.sole, target.sole), "posture", i);
      for (std::size_t k = 0; k < q.size(); ++k) {
        const LegHinge& hinge = leg.chain.hinges[k];
        beyond.see(std::max(hinge.lowest - q[k], q[k] - hinge.highest), "joint", k, "posture", i);
      }
    }
    const law::Statement says{.law = "numeric inverse kinematics: error of the ankle, 1,000 random feet",
                              .level = "leg_solver, " + name,
                              .source = "FK(IK(x)) = x"};
    law::expect_below(says, distance, 1e-9, "m");
    law::expect_below({.law = "numeric inverse kinematics: error of the sole's attitude, 1,000 random feet",
                       .level = says.level,
                       .source = says.source},
                      angle, 1e-9, "rad");
    law::expect_between({.law = "numeric inverse kinematics: way beyond the joint ranges, 1,000 random feet",
                         .level = says.level,
                         .source = "none"},
                        beyond, -10, 0, "rad");
  }
}

TEST(LegSolver, EqualsTheClosedFormForKid21) {
  const Leg exact = find_legs(*test::kid21())[0];
  ASSERT_TRUE(exact.signs);
  Leg numeric = exact;
  numeric.signs.reset();
  const RandomStream random(1, "kid21");
  std::uint64_t n = 0;
  law::Worst error;
  for (int i = 0; i < 1000; ++i) {
    const FootTarget target = target_at(exact, random_posture(exact, random, n, 0.5));
    std::vector<double> a = exact.home, b = exact.home;
    EXPECT_TRUE(bend(exact, target, a));
    EXPECT_TRUE(bend(numeric, target, b));
    for (std::size_t k = 0; k < 6; ++k) error.see(std::abs(a[k] - b[k]), "joint", k, "posture", i);
  }
  law::expect_below({.law = "numeric inverse kinematics of kid21: difference of angles, 1,000 random feet",
                     .level = "leg_solver",
                     .source = "the closed form"},
                    error, 1e-8, "rad");
}

// The foot moves down beyond the leg's length and up again: the leg stretches, stays, and returns along the same path.
TEST(LegSolver, AStretchedLegDoesNotJump) {
  for (const auto& [name, hinges] : sorts()) {
    const Leg leg = leg_of(hinges);
    const FootTarget stands = target_at(leg, leg.home);
    std::vector<double> q = leg.home, before;
    law::Worst jump;
    const int steps = 400;
    for (int i = 0; i <= 2 * steps; ++i) {
      const double way = 0.25 * (leg.thigh + leg.shin) * (1 - std::abs(i - steps) / double(steps));
      before = q;
      FootTarget target = stands;
      target.ankle.z -= way;
      const bool reached = bend(leg, target, q);
      if (way == 0) {
        EXPECT_TRUE(reached) << name;
      }
      if (i == steps) {
        EXPECT_FALSE(reached) << name;
      }
      for (std::size_t k = 0; k < q.size(); ++k) jump.see(std::abs(q[k] - before[k]), name, "joint", k, "step", i);
    }
    for (std::size_t k = 0; k < q.size(); ++k) EXPECT_NEAR(q[k], leg.home[k], 1e-6) << name << ' ' << k;
    law::expect_below({.law =
                           "leg is stretched by 25 % of its length in 400 steps and back: largest change of an angle",
                       .level = "leg_solver, " + name,
                       .source = "2 dl / (l sin(0.03)), with the 0.06 rad of bend that are left at the end"},
                      jump, 0.05, "rad");
  }
}

// A roll of the foot that the ankle's range does not allow: it goes to its end, and the rest is as near as it can be.
TEST(LegSolver, KeepsRangesAndSaysSo) {
  const Leg leg = leg_of(test::pitch_roll_yaw());
  FootTarget target = target_at(leg, leg.home);
  target.sole = target.sole * rotation_x(1.2);
  std::vector<double> q = leg.home;
  EXPECT_FALSE(bend(leg, target, q));
  EXPECT_NEAR(q[5], 0.5, 1e-12);
  const double before = angle_between(target_at(leg, leg.home).sole, target.sole);
  EXPECT_LT(angle_between(target_at(leg, q).sole, target.sole), before - 0.5);
  EXPECT_LT(norm(target_at(leg, q).ankle - target.ankle), 0.05);
}

// Squared error over a grid about the solution: nowhere is it smaller.
TEST(LegSolver, UnreachableFeetAreAsNearAsTheyCanBe) {
  const Leg leg = leg_of(test::five_hinges());
  const RandomStream random(1, "far");
  const SolverOptions options{.weight = leg.weight};
  for (std::uint64_t i = 0; i < 50; ++i) {
    TipTarget target{leg.hip + Vec3d{random.uniform(6 * i, -0.2, 0.2), random.uniform(6 * i + 1, -0.1, 0.1), -0.23},
                     rotation_z(random.uniform(6 * i + 2, -0.5, 0.5))};
    std::vector<double> q = leg.home;
    EXPECT_FALSE(solve_leg(leg.chain, target, options, q).reached);
    const auto cost = [&](std::span<const double> angles) {
      const ChainPose pose = pose_of(leg.chain, angles);
      return std::hypot(norm(target.tip - pose.tip), leg.weight * angle_between(target.sole, pose.sole));
    };
    const double best = cost(q);
    for (std::size_t k = 0; k < q.size(); ++k) {
      for (const double change : {-1e-3, 1e-3}) {
        std::vector<double> other = q;
        other[k] = std::clamp(q[k] + change, leg.chain.hinges[k].lowest, leg.chain.hinges[k].highest);
        EXPECT_GE(cost(other), best - 1e-9) << "joint " << k << " target " << i;
      }
    }
  }
}

// Every pose of a walk is reached, starting from the one before, and no angle jumps.
TEST(LegSolver, WalksWithLegsOfAnyKind) {
  for (const auto& [name, hinges] : sorts()) {
    if (hinges.size() < 6) continue;
    const Model model = test::legged("made_up", hinges, {0.02, 0.005, -0.04}, true);
    const auto legs = find_legs(model);
    const WalkParameters p = seeded_parameters(legs);
    const Vec3d fast{p.fastest.x, 0, 0.5 * p.fastest.z};
    GaitPose pose = gait_pose(legs, p, 0, 1, fast);
    law::Worst jump;
    for (double phase = 0.01; phase < 4 * pi; phase += 0.01) {
      const GaitPose before = std::exchange(pose, gait_pose(legs, p, std::fmod(phase, 2 * pi), 1, fast, pose));
      EXPECT_TRUE(pose.reachable) << name << ' ' << phase;
      for (std::size_t side = 0; side < 2; ++side) {
        for (std::size_t k = 0; k < 6; ++k)
          jump.see(std::abs(pose.q[side][k] - before.q[side][k]), name, "phase", phase, "joint", k);
      }
    }
    law::expect_below({.law = "gait at full speed: largest change of a joint target per 0.01 rad of phase",
                       .level = "leg_solver, " + name,
                       .source = "it is continuous, as fast as the swing allows"},
                      jump, 0.1, "rad");
  }
}

}  // namespace
}  // namespace murosimf::locomotion
