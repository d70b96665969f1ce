// Separation of kinematic walkers: feet from above, bodies by their deepest contact, goals, limits.
#include "murosimf/collision/kinematic_separation.h"

#include <gtest/gtest.h>

#include "murosimf/geometry/sweep_and_prune.h"
#include "tests/collision/movers.h"

namespace murosimf::collision {
namespace {

using fixtures::difference;
using fixtures::placed;

/// Robots whose feet go from -0.08 to 0.08 m along y, none of which can be pushed; and a wall whose face is at y = -3.
struct Walkers : Movers {
  Walkers() {
    field =
        &world.add("field",
                   std::make_shared<const Model>("field",
                                                 Chain{}.base().with(properties::shapes,
                                                                     Shapes{placed(Box{{2, 0.5, 1}}, {0, -3.5, 1})})));
  }
  void walker(const Vec3d& at) {
    static const auto model = std::make_shared<const Model>(fixtures::two_legged());
    MovingEntity& mover = add("walker" + std::to_string(all.size()), model, at);
    stand_fast(mover);
    mover.separation[0] = {7, 7, 7};
  }
  void can_be_pushed(std::size_t i) { all[i].entity->column(properties::dynamic).values[0] = 1; }
  /// In a step of `dt` [s].
  void separate(double dt = 1e-3) {
    start_step();
    std::vector<geometry::BoundingSphere> reach;
    for (const MovingEntity& mover : all) reach.push_back(mover.reach());
    kinematic_separation(all, StaticCompound(field), geometry::SweepAndPrune().find(reach), dt, set);
  }
  void block(int a, int b, const Vec3d& normal, double depth) {
    PairContact c = joint_of(a, b);
    c.normal = normal;
    c.depth = depth;
    set.blocked.push_back(c);
  }
  /// Between the shapes of these numbers.
  void press(int a, int b, const Vec3d& normal, double depth) {
    PairContact c = joint_of(a, b);
    c.normal = normal;
    c.depth = depth;
    c.shapes = number_of_shapes(a, b, 0, 1);
    set.points.push_back(c);
  }
  [[nodiscard]] Vec3d way(std::size_t i) const { return all[i].separation[0]; }
  Entity* field = nullptr;
};

// Rule: half of the way for either, whatever the height of the feet; at most 1 mm in a step of 1 ms.
TEST(KinematicSeparation, FeetAreComparedFromAbove) {
  for (const double overlap : {0.6e-3, 1.4e-3, 6e-3}) {
    for (const double height : {0.0, 0.05, -0.04}) {
      Walkers walkers;
      walkers.walker({5, 0, 0.31});
      walkers.walker({5.01, 0.16 - overlap, 0.31 + height});
      walkers.separate();
      const double half = std::min(0.5 * overlap, 1e-3);
      EXPECT_LT(difference(walkers.way(0), {0, -half, 0}), 1e-12) << overlap << " " << height;
      EXPECT_LT(difference(walkers.way(1), {0, half, 0}), 1e-12) << overlap << " " << height;
      EXPECT_EQ(walkers.set.tests.objects, 4);
    }
  }
}

TEST(KinematicSeparation, WhoIsFarStays) {
  Walkers walkers;
  walkers.walker({0, 0, 0.31});
  walkers.walker({0, 0.161, 0.31});
  walkers.walker({0, 5, 0.31});
  walkers.separate();
  for (const std::size_t i : {0U, 1U, 2U}) EXPECT_EQ(norm(walkers.way(i)), 0) << "nothing of the step before either";
  EXPECT_EQ(walkers.set.tests.objects, 4) << "the third is out of reach";
}

// Rule: the deepest contact counts, by its horizontal part: leaving along the ground takes depth / cos of its slope.
TEST(KinematicSeparation, DeepestContactOfBodiesCounts) {
  Walkers walkers;
  walkers.walker({0, 0, 0.31});
  walkers.walker({0, 0.3, 0.31});
  walkers.block(0, 1, {1, 0, 0}, 0.2e-3);
  walkers.block(0, 1, {0.36, 0.48, -0.8}, 0.6e-3);
  walkers.block(0, 1, {-1, 0, 0}, 0.5e-3);
  walkers.separate();
  EXPECT_LT(difference(walkers.way(0), 0.5e-3 * Vec3d{0.6, 0.8, 0}), 1e-15);
  EXPECT_LT(difference(walkers.way(1), -0.5e-3 * Vec3d{0.6, 0.8, 0}), 1e-15);
}

// One on top of the other has no way along the ground.
TEST(KinematicSeparation, OneOnTopOfTheOtherIsNotHelped) {
  Walkers walkers;
  walkers.walker({0, 0, 0.31});
  walkers.walker({0, 0.3, 0.31});
  walkers.block(0, 1, {0.9e-3, 0, 1}, 0.01);
  walkers.separate();
  EXPECT_EQ(norm(walkers.way(0)), 0);
  walkers.set.blocked.clear();
  walkers.block(0, 1, {1.2e-3, 0, 1}, 0.5e-6);
  walkers.separate();
  EXPECT_NEAR(walkers.way(0).x, 0.25e-6 / 1.2e-3, 1e-9);
}

// Contacts of three come in the order of pairs; ways add up.
TEST(KinematicSeparation, WaysOfSeveralNeighborsAddUp) {
  Walkers walkers;
  for (const double y : {0.0, 0.3, 0.6}) walkers.walker({0, y, 0.31});
  walkers.block(0, 1, {1, 0, 0}, 0.2e-3);
  walkers.block(0, 2, {0, 1, 0}, 0.4e-3);
  walkers.block(1, 2, {-1, 0, 0}, 0.6e-3);
  walkers.separate();
  EXPECT_LT(difference(walkers.way(0), {0.1e-3, 0.2e-3, 0}), 1e-15);
  EXPECT_LT(difference(walkers.way(1), {-0.4e-3, 0, 0}), 1e-15);
  EXPECT_LT(difference(walkers.way(2), {0.3e-3, -0.2e-3, 0}), 1e-15);
}

// Rule: entities do not separate from a frozen one, pushed or not; two that can be pushed are left to forces.
TEST(KinematicSeparation, WhoIsFrozenIsLeftOut) {
  for (const std::size_t which : {0U, 1U}) {
    for (const bool pushable : {true, false}) {
      Walkers walkers;
      walkers.walker({0, 0, 0.31});
      walkers.walker({0, 0.15, 0.31});
      if (pushable) walkers.can_be_pushed(which);
      walkers.all[which].entity->freeze("test");
      walkers.separate();
      EXPECT_EQ(norm(walkers.way(0)), 0) << which << pushable;
      EXPECT_EQ(norm(walkers.way(1)), 0) << which << pushable;
    }
  }
}

TEST(KinematicSeparation, TwoThatCanBePushedAreLeftToForces) {
  Walkers walkers;
  walkers.walker({0, 0, 0.31});
  walkers.walker({0, 0.15, 0.31});
  for (const std::size_t i : {0U, 1U}) walkers.can_be_pushed(i);
  walkers.press(0, 1, {0, -1, 0}, 10e-3);
  walkers.separate();
  EXPECT_EQ(norm(walkers.way(0)), 0);
  EXPECT_EQ(norm(walkers.way(1)), 0);
}

// Rule: 0.15 of the thickness of feet (20 mm) may overlap with one that can be pushed; the walker leaves what is more, all of it.
TEST(KinematicSeparation, AWalkerDoesNotStepOnWhoCanBePushed) {
  for (const std::size_t pushable : {0U, 1U}) {
    for (const double overlap : {2.9e-3, 3.4e-3, 9e-3}) {
      for (const double height : {0.0, 0.05}) {
        Walkers walkers;
        walkers.walker({5, 0, 0.31});
        walkers.walker({5.01, 0.16 - overlap, 0.31 + height});
        walkers.can_be_pushed(pushable);
        walkers.separate();
        const double way = std::clamp(overlap - 3e-3, 0.0, 1e-3);
        EXPECT_EQ(norm(walkers.way(pushable)), 0);
        EXPECT_LT(difference(walkers.way(1 - pushable), {0, pushable == 1 ? -way : way, 0}), 1e-12) << overlap;
      }
    }
  }
}

// The same of all other contacts: here of a trunk of 80 mm and a foot, so that again 3 mm are borne.
TEST(KinematicSeparation, AWalkerPressesNothingFlat) {
  Walkers walkers;
  for (const double y : {0.0, 0.3, 0.6}) walkers.walker({0, y, 0.31});
  walkers.can_be_pushed(1);
  walkers.press(0, 1, {0, -1, 0}, 2e-3);
  walkers.press(0, 1, {0.6, 0, 0.8}, 3.3e-3);
  walkers.press(1, 2, {1, 0, 0}, 2.9e-3);
  walkers.separate();
  EXPECT_LT(difference(walkers.way(0), {0.5e-3, 0, 0}), 1e-12);
  EXPECT_EQ(norm(walkers.way(1)), 0);
}

// A ball between a walker and another robot: that is pressed into the robot, however little the walker is in the ball.
TEST(KinematicSeparation, AWalkerPressesNothingIntoOthers) {
  Walkers walkers;
  for (const double y : {0.0, 0.3, 0.6}) walkers.walker({0, y, 0.31});
  for (const std::size_t i : {1U, 2U}) walkers.can_be_pushed(i);
  walkers.press(0, 1, {0, -1, 0}, 1e-3);
  walkers.press(1, 2, {1, 0, 0}, 3.4e-3);
  walkers.separate();
  EXPECT_LT(difference(walkers.way(0), {0, -0.4e-3, 0}), 1e-12);
  EXPECT_EQ(norm(walkers.way(1)), 0);
  EXPECT_EQ(norm(walkers.way(2)), 0);
}

// In longer steps the way is longer: a robot that walks into an obstacle with 0.2 m/s comes 2 mm deeper in one of 10 ms.
TEST(KinematicSeparation, OutWithAtMostAMeterPerSecond) {
  for (const double dt : {0.5e-3, 1e-3, 10e-3}) {
    Walkers walkers;
    walkers.walker({5, 0, 0.31});
    walkers.walker({5.01, 0.145, 0.31});  // 15 mm in each other, each to go half of it
    walkers.separate(dt);
    EXPECT_LT(difference(walkers.way(0), {0, -std::min(dt, 7.5e-3), 0}), 1e-12) << dt;
  }
}

// All of the way out of what does not move, at most 1 mm.
TEST(KinematicSeparation, AWallSendsWalkersBack) {
  for (const double overlap : {0.3e-3, 0.8e-3, 4e-3}) {
    Walkers walkers;
    walkers.walker({0.2, -2.92 - overlap, 0.31});
    walkers.walker({0, 0, 0.31});
    walkers.separate();
    EXPECT_LT(difference(walkers.way(0), {0, std::min(overlap, 1e-3), 0}), 1e-9) << overlap;
    EXPECT_EQ(norm(walkers.way(1)), 0);
    EXPECT_GT(walkers.set.tests.objects, 0);
    EXPECT_GT(walkers.set.tests.volumes, 1);
  }
}

TEST(KinematicSeparation, AWallThatIsNotReachedSendsNobodyBack) {
  Walkers walkers;
  walkers.walker({0, -2.915, 0.31});
  walkers.separate();
  EXPECT_EQ(norm(walkers.way(0)), 0);
}

}  // namespace
}  // namespace murosimf::collision
