// Contact between bodies independent of its law: first values, separation of walkers, ledger of entities that cannot be pushed.
#include "murosimf/collision/body_contact.h"

#include <gtest/gtest.h>

#include "murosimf/collision/contact_laws/contact_parameters.h"
#include "murosimf/collision/contact_laws/deferred_impulse_law.h"
#include "tests/collision/balls.h"
#include "tests/collision/meeting.h"
#include "tests/physics/rig.h"

namespace murosimf::collision {
namespace {

using fixtures::difference;

constexpr double dt = Balls::dt;

TEST(BodyContact, BeginsWithNothing) {
  Balls balls({{0, 0, 1}, {2, 0, 1}}, std::make_unique<DeferredImpulseLaw>());
  EXPECT_EQ(balls.set().entities, (std::vector<int>{1, 2}));
  EXPECT_FALSE(balls.set().parameters.empty());
  for (const std::size_t i : {0U, 1U}) {
    for (const auto& property :
         {properties::interaction_force, properties::external_force, properties::absorbed_impulse})
      EXPECT_EQ(norm(balls.column(i, property).f) + norm(balls.column(i, property).n), 0);
    EXPECT_EQ(balls.column(i, properties::external_damping).M.xx, 0);
    EXPECT_EQ(norm(balls.column(i, properties::separation)), 0);
    EXPECT_EQ(balls.interface(i).terms.dt, 1e-3);
    EXPECT_TRUE(balls.interface(i).damped_by_others);
  }
  Balls others({{0, 0, 1}});
  EXPECT_FALSE(others.interface(0).damped_by_others);
}

// What cannot be pushed is the end of an island: it has the impulse in its ledger.
TEST(BodyContact, WhatCannotBePushedKeepsTheImpulse) {
  Balls balls({{0, 0, 1}, {0.199, 0, 1}});
  balls.column(1, properties::dynamic) = 0;
  balls.launch(1, {-0.4, 0, 0});
  balls.step();
  const PairContact& c = balls.set().points[0];
  ASSERT_LT(c.force.x, -1);
  EXPECT_NEAR(balls.answers[0].next.x, dt * c.force.x, 1e-9);
  EXPECT_LT(difference(balls.column(1, properties::absorbed_impulse).f, -dt * c.force), 1e-12);
  EXPECT_LT(difference(balls.column(1, properties::absorbed_impulse).n, cross(c.point, -dt * c.force)), 1e-12);
  EXPECT_EQ(balls.answers[1].passes, 0);
  EXPECT_FALSE(balls.column(1, contacts).solved);
}

TEST(BodyContact, OtherLaws) {
  for (const std::string law : {"kelvin_voigt", "carry"}) {
    Balls balls({{0, 0, 1}, {0.199, 0, 1}}, test::body_law_named(law));
    balls.launch(0, {0.3, 0, 0});
    balls.step();
    const PairContact& c = balls.set().points[0];
    EXPECT_LT(c.force.x, -1);
    EXPECT_LT(difference(balls.column(0, properties::external_force).f, c.force), 1e-12);
    EXPECT_EQ(balls.column(0, properties::external_damping).M.xx > 0, law == "carry");
    EXPECT_EQ(balls.answers[0].passes, 0);
    EXPECT_FALSE(balls.column(0, contacts).solved);
  }
}

// Two walkers whose shapes overlap go apart: their levels are told the way.
TEST(BodyContact, KeepsWalkersApart) {
  Balls balls({{0, 0, 1}, {0.199, 0, 1}});
  balls.column(0, properties::dynamic) = balls.column(1, properties::dynamic) = 0;
  balls.step();
  EXPECT_LT(difference(balls.column(0, properties::separation), {-0.5e-3, 0, 0}), 1e-9);
  EXPECT_LT(difference(balls.column(1, properties::separation), {0.5e-3, 0, 0}), 1e-9);
}

// Constants of a pair are those of both models, for a law that is explicit.
TEST(BodyContact, ConstantsAreThoseOfTheLaw) {
  Meeting meeting("kelvin_voigt");
  meeting.rig.simulation.step();
  const ContactParameters& found = meeting.set().parameters[meeting.set().points[0].surface];
  const PairSurface pair = meeting.rig.materials.find({"", 0.4}, {"", 0.6});
  const ContactParameters expected =
      contact_parameters(meeting.small->model(), meeting.big->model(), pair, {1e-3, false});
  EXPECT_EQ(found.stiffness, expected.stiffness);
  EXPECT_EQ(found.damping, expected.damping);
  EXPECT_EQ(found.friction, expected.friction);
}

}  // namespace
}  // namespace murosimf::collision
