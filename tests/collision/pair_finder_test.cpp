// Which bodies touch: pairs, sides, arms and velocities, constants of the pair, memory, excluded entities, kept data.
#include "murosimf/collision/pair_finder.h"

#include <gtest/gtest.h>

#include "murosimf/collision/contact_laws/contact_parameters.h"
#include "tests/collision/movers.h"

namespace murosimf::collision {
namespace {

using fixtures::difference;
using fixtures::placed;

/// Movers and the finder of their contacts.
struct Found : Movers {
  void find() {
    if (!finder) {
      finder.emplace(materials, ContactConditions{}, Vec3d{});
      for (const MovingEntity& one : all) finder->add(one);
      set.parameters = finder->parameters();
    }
    start_step();
    finder->find(all, set);
  }
  MaterialTable materials;
  std::optional<PairFinder> finder;
};

ModelPtr box(const Vec3d& half_size, double mass, const Surface& surface = {}) {
  PlacedShape shape = placed(Box{half_size});
  shape.surface = surface;
  return std::make_shared<const Model>("box", Chain{}
                                                  .base("box")
                                                  .with(properties::mass, mass)
                                                  .with(properties::inertia, diagonal(0.01 * mass))
                                                  .with(properties::shapes, Shapes{shape}));
}

/// A trunk with two arms beside it, 2 cm from each other; the second shape of an arm is another surface.
ModelPtr two_arms() {
  const auto arm = [](const std::string& name, double y) {
    PlacedShape hand = placed(Sphere{0.02}, {0, 0, -0.2});
    hand.surface.friction = 0.3;
    return Chain{}
        .translation({0, y, 0})
        .revolute(name, {1, 0, 0})
        .with(properties::mass, 0.4)
        .with(properties::inertia, diagonal(1e-3))
        .with(properties::shapes, Shapes{placed(Sphere{0.05}), hand});
  };
  return std::make_shared<const Model>("arms", Chain{}
                                                   .base("trunk")
                                                   .with(properties::mass, 1.0)
                                                   .with(properties::inertia, diagonal(1e-2))
                                                   .fork(arm("left", 0.06), arm("right", -0.06)));
}

// Both move and turn: A is the first of the list, the normal points to it, velocities are those of the material points.
TEST(PairFinder, TwoBallsTouchInOnePoint) {
  Found found;
  const Vec3d n{0.48, 0.6, 0.64};
  found.add("small", ball(0.05, 0.3), Vec3d{1, 2, 3} + 0.169 * n);
  found.add("big", ball(0.12, 2.0), {1, 2, 3});
  Movers::launch(found.all[0], {0.3, -0.5, 5}, {1, 2, -3});
  Movers::launch(found.all[1], {0, 0.1, 0.2}, {-1, 0.5, 2});
  found.find();
  ASSERT_EQ(found.set.points.size(), 1U);
  EXPECT_TRUE(found.set.blocked.empty());
  const PairContact& c = found.set.points[0];
  EXPECT_EQ(c.a, 0);
  EXPECT_EQ(c.b, 1);
  EXPECT_LT(difference(c.normal, n), 1e-12);
  EXPECT_NEAR(c.depth, 1e-3, 1e-12);
  EXPECT_LT(difference(c.arm_a, -(0.05 - 0.5e-3) * n), 1e-12);
  EXPECT_LT(difference(c.arm_b, (0.12 - 0.5e-3) * n), 1e-12);
  EXPECT_LT(difference(c.point, Vec3d{1, 2, 3} + c.arm_b), 1e-12);
  EXPECT_LT(difference(c.velocity_a, Vec3d{0.3, -0.5, 5} + cross(Vec3d{1, 2, -3}, c.arm_a)), 1e-12);
  EXPECT_LT(difference(c.velocity_b, Vec3d{0, 0.1, 0.2} + cross(Vec3d{-1, 0.5, 2}, c.arm_b)), 1e-12);
  EXPECT_LT(difference(c.velocity, c.velocity_a - c.velocity_b), 1e-15);
}

TEST(PairFinder, NobodyNearNoContactAndOneTestOfVolumes) {
  Found found;
  found.add("a", ball(0.1, 1));
  found.add("b", ball(0.1, 1), {0, 0.2001, 0});
  found.find();
  EXPECT_TRUE(found.set.points.empty());
  EXPECT_EQ(found.set.tests.volumes, 1);
  EXPECT_EQ(found.set.tests.objects, 0);
  Movers::place(found.all[1], {0, 0.1999, 0});
  found.find();
  EXPECT_EQ(found.set.points.size(), 1U);
  EXPECT_EQ(found.set.tests.objects, 1);
  found.find();
  EXPECT_EQ(found.set.tests.objects, 1) << "of this step";
}

// Rule: trees have a margin and are kept while nothing moves farther, and contacts are exact all the same.
TEST(PairFinder, SmallStepsMissNothing) {
  Found found;
  found.add("a", ball(0.1, 1));
  found.add("b", ball(0.07, 1), {0.3, 0, 0});
  for (int i = 0; i < 200; ++i) {
    const double x = 0.3 - 1e-3 * i;
    Movers::place(found.all[1], {x, 0, 0});
    found.find();
    ASSERT_EQ(found.set.points.size(), x < 0.17 ? 1U : 0U) << x;
    for (const PairContact& c : found.set.points) EXPECT_NEAR(c.depth, 0.17 - x, 1e-12);
  }
  EXPECT_LT(found.all[1].fits(), 40U) << "its tree is not new in every step";
}

// Three in a row, given in another order: contacts come by the places of the list.
// Rule: what is remembered of a step spares tests of volumes, and changes nothing else.
TEST(PairFinder, ForgettingNeighborsFindsTheSameWithMoreTests) {
  Found pair;
  pair.add("a", two_arms());
  pair.add("b", two_arms(), {0.05, 0, 0});
  pair.find();
  pair.find();
  const TestCounts kept = pair.set.tests;
  const std::size_t points = pair.set.points.size();
  pair.finder->forget_neighbors();
  pair.find();
  EXPECT_GT(points, 0U);
  EXPECT_EQ(pair.set.points.size(), points);
  EXPECT_EQ(pair.set.tests.objects, kept.objects);
  EXPECT_GT(pair.set.tests.volumes, kept.volumes);
  pair.find();
  EXPECT_EQ(pair.set.tests.volumes, kept.volumes);
}

TEST(PairFinder, ContactsComeInTheOrderOfTheList) {
  Found found;
  found.add("middle", ball(0.1, 1));
  found.add("right", ball(0.1, 2), {0.199, 0, 0});
  found.add("left", ball(0.1, 3), {-0.198, 0, 0});
  found.find();
  ASSERT_EQ(found.set.points.size(), 2U);
  EXPECT_EQ(found.set.points[0].b, 1);
  EXPECT_EQ(found.set.points[1].b, 2);
  EXPECT_LT(found.set.points[0].shapes, found.set.points[1].shapes);
  EXPECT_LT(difference(found.set.points[1].normal, {1, 0, 0}), 1e-12);
}

// Rule: however many there are and however they move, pairs are those that testing all with all finds, and few more are tested.
TEST(PairFinder, CrowdIsComparedWithNeighborsOnly) {
  fixtures::Dice dice("crowd");
  Found found;
  for (int i = 0; i < 60; ++i) {
    found.add("ball" + std::to_string(i), ball(0.05 + 0.002 * i, 1), {0.3 * (i * 17 % 60), dice.uniform(0, 0.8), 0});
  }
  found.all[31].entity->freeze("test");
  std::size_t contacts = 0;
  for (int step = 0; step < 50; ++step) {
    for (MovingEntity& one : found.all) Movers::place(one, one.r[0] + dice.vector(0.05));
    if (step == 20) Movers::place(found.all[7], {std::nan(""), 0, 0});
    found.find();
    std::vector<std::pair<int, int>> expected, touching;
    for (int a = 0; a < 60; ++a) {
      for (int b = a + 1; b < 60; ++b) {
        const bool met = overlap(found.all[a].sphere(0), found.all[b].sphere(0));
        if (met && a != 31 && b != 31) expected.emplace_back(a, b);
      }
    }
    for (const PairContact& c : found.set.points) touching.emplace_back(c.a, c.b);
    ASSERT_EQ(touching, expected) << step;
    contacts += touching.size();
    EXPECT_LT(found.set.tests.volumes, 600) << "not 1770";
  }
  EXPECT_GT(contacts, 200U);
}

// Many shapes that touch, in a tree that has its own order: contacts come by shapes, as the memory needs it.
TEST(PairFinder, ContactsComeInTheOrderOfShapes) {
  Found found;
  Shapes beads;
  for (const double x : {0.5, -0.3, 0.1, -0.5, 0.3, -0.1, 0.7}) beads.push_back(placed(Sphere{0.05}, {x, 0, 0}));
  found.add("beads",
            std::make_shared<const Model>("beads",
                                          Chain{}.base().with(properties::mass, 1.0).with(properties::shapes, beads)));
  found.add("plate", box({1, 0.2, 0.1}, 5), {0, 0, -0.149});
  found.find();
  ASSERT_EQ(found.set.points.size(), 7U);
  for (std::size_t i = 1; i < 7; ++i) EXPECT_LT(found.set.points[i - 1].shapes, found.set.points[i].shapes);
  EXPECT_NEAR(found.set.points[3].point.x, -0.5, 1e-9);
}

// Rule: constants are those of the two models, whatever their order, with the surfaces of both.
TEST(PairFinder, ConstantsAreThoseOfBoth) {
  for (const bool light_first : {true, false}) {
    Found found;
    found.materials.set("felt", "steel", {.friction = 0.37, .restitution = 0.3});
    const ModelPtr light = ball(0.1, 0.3, {"felt"}), heavy = box({0.1, 0.2, 0.3}, 7, {"steel"});
    found.add("one", light_first ? light : heavy);
    found.add("other", light_first ? heavy : light, {0.19, 0.02, 0.01});
    found.find();
    ASSERT_EQ(found.set.points.size(), 1U);
    const ContactParameters& p = found.set.parameters[found.set.points[0].surface];
    const PairSurface pair = found.materials.find({"felt"}, {"steel"});
    const ContactParameters expected = contact_parameters(*light, *heavy, pair, {});
    EXPECT_EQ(p.stiffness, expected.stiffness) << light_first;
    EXPECT_EQ(p.damping, expected.damping) << light_first;
    EXPECT_EQ(p.friction, 0.37);
  }
}

// What has no mass can only be moved kinematically: the constants are those of the other one.
TEST(PairFinder, WhatHasNoMassGivesNoConstants) {
  const auto ghost = std::make_shared<const Model>("ghost", Chain{}.base("ghost").with(properties::shapes,
                                                                                       Shapes{placed(Sphere{0.1})}));
  for (const bool ghost_first : {true, false}) {
    Found found;
    const ModelPtr real = box({0.1, 0.2, 0.3}, 7);
    found.add("one", ghost_first ? ghost : real);
    found.add("other", ghost_first ? real : ghost, {0.19, 0.02, 0.01});
    Movers::stand_fast(found.all[ghost_first ? 0 : 1]);
    found.find();
    ASSERT_EQ(found.set.points.size(), 1U);
    const ContactParameters expected = contact_parameters(*ghost, *real, found.materials.find({}, {}), {});
    EXPECT_EQ(found.set.parameters[found.set.points[0].surface].stiffness, expected.stiffness) << ghost_first;
  }
}

// Surfaces of one model that differ in name or friction alone are told apart; equal ones of equal models are not.
TEST(PairFinder, SurfacesAreToldApart) {
  Found found;
  const ModelPtr same = ball(0.1, 1, {"felt", 0.2});
  found.add("a", same);
  found.add("b", same, {1, 0, 0});
  found.find();
  EXPECT_EQ(found.set.parameters.size(), 1U);
  Found others;
  Shapes shapes{placed(Sphere{0.1}), placed(Sphere{0.1}), placed(Sphere{0.1})};
  shapes[0].surface = {"felt", 0.2};
  shapes[1].surface = {"felt", 0.3};
  shapes[2].surface = {"steel", 0.2};
  others.add("a", std::make_shared<const Model>(
                      "three", Chain{}.base().with(properties::mass, 1.0).with(properties::shapes, shapes)));
  others.add("b", same, {1, 0, 0});
  others.find();
  EXPECT_EQ(others.set.parameters.size(), 16U) << "three kinds of one model and one of the other";
  EXPECT_EQ(others.set.parameters[4 * 1 + 3].friction, 0.3);
  EXPECT_EQ(others.set.parameters[4 * 0 + 3].friction, 0.2);
}

// The second shape of the first, the second of the other: `surface` is that of these two.
TEST(PairFinder, SurfaceIsThatOfTheShapesThatTouch) {
  Found found;
  Shapes shapes{placed(Sphere{0.05}), placed(Sphere{0.05}, {0, 0, 0.3})};
  shapes[0].surface.friction = 0.1;
  shapes[1].surface.friction = 0.25;
  const auto model = std::make_shared<const Model>("two", Chain{}
                                                              .base()
                                                              .with(properties::mass, 1.0)
                                                              .with(properties::inertia, diagonal(0.1))
                                                              .with(properties::shapes, shapes));
  found.add("low", model);
  found.add("high", ball(0.05, 1, {"", 0.2}), {0.099, 0, 0.3});
  found.find();
  ASSERT_EQ(found.set.points.size(), 1U);
  EXPECT_EQ(found.set.parameters[found.set.points[0].surface].friction, 0.25) << "the larger one of the two surfaces";
  Movers::place(found.all[1], {0.099, 0, 0});
  found.find();
  ASSERT_EQ(found.set.points.size(), 1U);
  EXPECT_EQ(found.set.parameters[found.set.points[0].surface].friction, 0.2);
}

// Rule: a contact keeps its memory as long as it lasts, and only that.
TEST(PairFinder, MemoryGoesOnWithTheContact) {
  Found found;
  found.add("a", box({0.1, 0.1, 0.1}, 1));
  found.add("b", box({0.2, 0.3, 0.1}, 2), {0.01, 0.02, 0.199});
  found.add("c", ball(0.1, 1), {0, 0.199, -0.05});
  found.find();
  ASSERT_EQ(found.set.points.size(), 5U) << "four corners and a ball";
  for (std::size_t i = 0; i < 5; ++i) found.set.points[i].stretch = {1.0 + static_cast<double>(i), 0, 0};
  found.find();
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(found.set.points[i].stretch.x, 1.0 + static_cast<double>(i));
  // the ball goes and comes back: its contact is a new one, those of the boxes last
  Movers::place(found.all[2], {0, 0.3, -0.05});
  found.find();
  ASSERT_EQ(found.set.points.size(), 4U);
  EXPECT_EQ(found.set.points[3].stretch.x, 4);
  Movers::place(found.all[2], {0, 0.199, -0.05});
  found.find();
  ASSERT_EQ(found.set.points.size(), 5U);
  EXPECT_EQ(found.set.points[4].stretch.x, 0);
  EXPECT_EQ(found.set.points[2].stretch.x, 3);
  // now the boxes part, and the ball stays
  found.set.points[4].stretch.x = 7;
  Movers::place(found.all[1], {0, 0, 5});
  found.find();
  ASSERT_EQ(found.set.points.size(), 1U);
  EXPECT_EQ(found.set.points[0].stretch.x, 7);
  Movers::place(found.all[1], {0.01, 0.02, 0.199});
  found.find();
  ASSERT_EQ(found.set.points.size(), 5U);
  EXPECT_EQ(found.set.points[0].stretch.x, 0);
  EXPECT_EQ(found.set.points[4].stretch.x, 7);
}

// A frozen entity touches no other, on either side.
TEST(PairFinder, FrozenOnesAreLeftOut) {
  for (const std::size_t frozen : {0U, 1U}) {
    Found found;
    found.add("a", ball(0.1, 1));
    found.add("b", ball(0.1, 1), {0.19, 0, 0});
    found.find();
    EXPECT_EQ(found.set.points.size(), 1U);
    found.all[frozen].entity->freeze("test");
    found.find();
    EXPECT_TRUE(found.set.points.empty()) << frozen;
  }
}

// Two that cannot be pushed block each other: no point of force, and nothing to push.
TEST(PairFinder, WhoCannotBePushedIsBlocked) {
  Found found;
  found.add("a", ball(0.1, 1));
  found.add("b", ball(0.1, 1), {0.19, 0, 0});
  Movers::stand_fast(found.all[0]);
  found.find();
  EXPECT_EQ(found.set.points.size(), 1U) << "the other one can";
  EXPECT_TRUE(found.set.blocked.empty());
  Movers::stand_fast(found.all[1]);
  found.find();
  EXPECT_TRUE(found.set.points.empty());
  ASSERT_EQ(found.set.blocked.size(), 1U);
  EXPECT_NEAR(found.set.blocked[0].depth, 0.01, 1e-12);
  found.find();
  EXPECT_EQ(found.set.blocked.size(), 1U);
}

// Rule: what stands fast pushes with 3 m/s at most, as its standing foot may change within a step; what is pushed is as fast as
// it is.
TEST(PairFinder, AStandingFootThatChangesDoesNotShoot) {
  Found found;
  found.add("walker", ball(0.1, 1));
  found.add("ball", ball(0.1, 1), {0.19, 0, 0});
  Movers::stand_fast(found.all[0]);
  Movers::launch(found.all[0], {6, 8, 0});
  Movers::launch(found.all[1], {-6, 8, 1});
  found.find();
  ASSERT_EQ(found.set.points.size(), 1U);
  EXPECT_LT(difference(found.set.points[0].velocity_a, {1.8, 2.4, 0}), 1e-12);
  EXPECT_LT(difference(found.set.points[0].velocity_b, {-6, 8, 1}), 1e-12);
  Movers::launch(found.all[0], {1.2, -0.5, 2});
  found.find();
  EXPECT_LT(difference(found.set.points[0].velocity_a, {1.2, -0.5, 2}), 1e-12) << "slower ones as they are";
}

// Limbs of one robot: only if wanted, and only if joints can give way.
TEST(PairFinder, LimbsOfOneRobot) {
  const EntityOptions wanted{.collision = {.self_collision = true}};
  Found found;
  found.add("robot", two_arms(), {0, 0, 1}, wanted);
  found.answers[0].count = 8;
  const Model& model = found.all[0].model();
  found.all[0].entity->column(properties::position).values[model.object_index("left")].y -= 0.022;
  found.find();
  ASSERT_EQ(found.set.points.size(), 1U) << "the hands are smaller";
  const PairContact& c = found.set.points[0];
  EXPECT_EQ(c.a, 0);
  EXPECT_EQ(c.b, 0);
  EXPECT_EQ(c.object, model.object_index("left"));
  EXPECT_EQ(c.object_b, model.object_index("right"));
  EXPECT_LT(difference(c.normal, {0, 1, 0}), 1e-12);
  EXPECT_NEAR(c.arm_b.y, 0.049, 1e-12);
  found.answers[0].count = 6;
  found.find();
  EXPECT_TRUE(found.set.points.empty()) << "a rigid body";
  Found others;
  others.add("robot", two_arms());
  others.answers[0].count = 8;
  others.all[0].entity->column(properties::position).values[model.object_index("left")].y -= 0.022;
  others.find();
  EXPECT_TRUE(others.set.points.empty()) << "not wanted";
}

// A plate on a plate has eight corners at most; four points carry them.
TEST(PairFinder, FourPointsAreKept) {
  Found found;
  found.add("a", box({0.1, 0.1, 0.1}, 1));
  found.add("b", box({0.1, 0.1, 0.1}, 1));
  Movers::place(found.all[1], {0, 0, 0.199}, rotation_z(0.7));
  found.find();
  ASSERT_EQ(found.set.points.size(), 4U);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_LT(found.set.points[i - 1].feature, found.set.points[i].feature);
}

}  // namespace
}  // namespace murosimf::collision
