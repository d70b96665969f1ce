// Which entities are solved together and which alone, the rows of the ground, and the results for members of an island.
#include "murosimf/collision/contact_laws/body_island_law.h"

#include <gtest/gtest.h>

#include "murosimf/collision/contact_laws/contact_law_parts.h"
#include "murosimf/collision/contact_laws/implicit_stick_law.h"
#include "murosimf/collision/contact_laws/kelvin_voigt_law.h"
#include "tests/collision/balls.h"

namespace murosimf::collision {
namespace {

using fixtures::difference;

constexpr double dt = Balls::dt;

// Two that come together: the force that the law says for the velocities afterwards, told to both as a push.
TEST(BodyIslandLaw, AnIslandOfTwo) {
  Balls balls({{0, 0, 1}, {0.199, 0, 1}});
  balls.launch(0, {0.05, 0, 0});
  balls.launch(1, {-0.04, 0, 0});  // too slow for a bounce
  balls.step();
  ASSERT_EQ(balls.set().points.size(), 1U);
  const PairContact& c = balls.set().points[0];
  const ContactParameters& p = balls.set().parameters[c.surface];
  const double v = balls.answers[1].next.x - balls.answers[0].next.x;
  const double f = p.stiffness * (1e-3 - p.theta * dt * v) - p.damping * v;
  ASSERT_GT(f, 1);
  EXPECT_LT(difference(c.force, {-f, 0, 0}), 1e-6 * f);
  EXPECT_NEAR(balls.answers[0].next.x, 0.05 - dt * f, 1e-9);
  EXPECT_NEAR(balls.answers[1].next.x, -0.04 + dt * f / 2, 1e-9);
  for (const auto& property : {properties::interaction_force, properties::external_force}) {
    EXPECT_LT(difference(balls.column(0, property).f, c.force), 1e-12);
    EXPECT_LT(difference(balls.column(1, property).f, -c.force), 1e-12);
  }
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_TRUE(balls.column(i, contacts).solved);
    EXPECT_FALSE(balls.column(i, contacts).island_stands);
    EXPECT_EQ(balls.answers[i].passes, 1);
  }
  // they part: nothing of that stays
  balls.column(1, properties::position) = {2, 0, 1};
  balls.column(0, contacts).solved = false;
  balls.step();
  EXPECT_EQ(norm(balls.column(0, properties::interaction_force).f), 0);
  EXPECT_EQ(norm(balls.column(0, properties::external_force).f), 0);
  EXPECT_EQ(balls.answers[0].passes, 1) << "no island";
  EXPECT_FALSE(balls.column(0, contacts).solved);
}

// Two pairs are two islands: an entity of one is not in the other.
TEST(BodyIslandLaw, IslandsKnowNothingOfEachOther) {
  const ImplicitStick law;
  Balls balls({{0, 0, 1}, {5, 0, 1}, {0.199, 0, 1}, {5.199, 0, 1}});
  balls.stand(2, law);
  balls.step();
  EXPECT_EQ(balls.set().points.size(), 2U);
  EXPECT_TRUE(balls.column(0, contacts).island_stands);
  EXPECT_TRUE(balls.column(2, contacts).island_stands);
  EXPECT_FALSE(balls.column(1, contacts).island_stands);
  EXPECT_FALSE(balls.column(3, contacts).island_stands);
  for (const std::size_t i : {0U, 1U, 2U, 3U}) EXPECT_EQ(balls.answers[i].passes, 1);
}

// Rule: contacts with the ground become rows of the island, and only rolling resistance and pushes of users are left
// for the free pass.
TEST(BodyIslandLaw, GroundOfAMemberBecomesRows) {
  const ImplicitStick law;
  Balls balls({{0, 0, 0.099}, {0.199, 0, 0.099}});
  balls.column(0, contacts).rest_force[0] = {{0, 0, 0.5}, {0, 3, 0}};
  balls.launch(0, {0.02, 0, -0.05});
  balls.stand(0, law);
  const double moment = balls.column(0, contacts).points[0].moment.y;
  ASSERT_LT(moment, 0);
  balls.step();
  const ContactPoint& ground = balls.column(0, contacts).points[0];
  const ContactParameters p = Balls::ground();
  const Vec3d v = balls.answers[0].next;
  EXPECT_NEAR(ground.force.z, p.stiffness * (1e-3 - dt * v.z) - p.damping * v.z, 1e-4);
  EXPECT_NEAR(ground.force.y, -p.tangent_stiffness * ground.stretch.y - p.tangent_damping * v.y, 1e-6);
  // what the level hears of: pushes, ground, the other ball
  const Vec3d pair = balls.set().points[0].force;
  const Wrenchd& felt = balls.column(0, properties::external_force);
  EXPECT_LT(difference(felt.f, Vec3d{0, 3, 0} + ground.force + pair), 1e-9);
  EXPECT_LT(difference(felt.n, Vec3d{0, moment, 0.5} + cross(Vec3d{0, 0, -0.099}, ground.force) +
                                   cross(balls.set().points[0].arm_a, pair)),
            1e-9);
  EXPECT_EQ(balls.column(0, properties::external_damping).M.xx, 0);
  EXPECT_EQ(balls.column(0, properties::external_damping).J.xx, 0);
  EXPECT_TRUE(balls.column(1, contacts).island_stands) << "for the one beside it, too";
  // momentum of the two: what ground and user gave
  EXPECT_LT(difference(1.0 * v + 2.0 * balls.answers[1].next,
                       Vec3d{0.02, 0, -0.05} + dt * (Vec3d{0, 3, 0} + ground.force)),
            1e-9);
}

// The free pass of such a member meets its rolling resistance, as a moment that falls with the rotation.
TEST(BodyIslandLaw, FreePassKnowsRollingResistance) {
  struct Witness final : ImpulseResponse {
    bool free_pass(double h) noexcept override {
      seen_force = force[0];
      seen_damping = damping[0];
      seen_dt = h;
      return true;
    }
    [[nodiscard]] std::size_t coordinates() const noexcept override { return 0; }
    [[nodiscard]] Vec3d free_velocity(int, const Vec3d&, const Vec3d&) const noexcept override { return {}; }
    void respond(int, const Vec3d&, const Mat3d&, ResponseRows&) const noexcept override {}
    void apply(std::span<const double>) noexcept override {}
    std::span<const Wrenchd> force;
    std::span<const Sym6d> damping;
    Wrenchd seen_force;
    Sym6d seen_damping;
    double seen_dt = 0;
  };
  const IslandGaussSeidel law;
  Balls balls({{0, 0, 0.099}});
  Witness witness;
  witness.force = balls.column_of(0, properties::external_force);
  witness.damping = balls.column_of(0, properties::external_damping);
  balls.interface(0).response = &witness;
  balls.column(0, contacts).rest_force[0] = {{0, 0, 0.5}, {0, 3, 0}};
  balls.stand(0, law);
  const ContactPoint before = balls.column(0, contacts).points[0];
  balls.step();
  EXPECT_EQ(witness.seen_dt, dt);
  EXPECT_LT(difference(witness.seen_force.f, {0, 3, 0}), 1e-12) << "the ground is a row";
  EXPECT_LT(difference(witness.seen_force.n, Vec3d{0, 0, 0.5} + before.moment), 1e-12);
  ASSERT_GT(before.angular_damping, 0);
  EXPECT_LT(difference(witness.seen_damping.J, angular_damping_matrix(before)), 1e-15);
  EXPECT_EQ(witness.seen_damping.M.xx, 0);
  EXPECT_TRUE(balls.column(0, contacts).solved) << "a law that wants an island has one, touching others or not";
  EXPECT_TRUE(balls.column(0, contacts).island_stands);
}

// A law that is no rows keeps its force in the free pass, and its memory goes on with the velocity after the step.
TEST(BodyIslandLaw, ExplicitLawKeepsItsForceAndMemory) {
  const KelvinVoigt law;
  Balls balls({{0, 0, 0.099}, {0.199, 0, 0.099}});
  balls.launch(0, {0, 0.04, 0});
  balls.stand(0, law);
  const Vec3d force = balls.column(0, contacts).points[0].force;
  balls.step();
  const ContactPoint& ground = balls.column(0, contacts).points[0];
  EXPECT_LT(difference(ground.force, force), 1e-12);
  const Vec3d pair = balls.set().points[0].force, next = balls.answers[0].next;
  EXPECT_LT(difference(next, Vec3d{0, 0.04, 0} + dt * (force + pair)), 1e-9);
  EXPECT_LT(difference(ground.stretch, {dt * next.x, dt * next.y, 0}), 1e-12);
  EXPECT_LT(difference(balls.column(0, properties::external_force).f, force + pair), 1e-9);
  EXPECT_EQ(balls.column(0, properties::external_damping).M.xx, 0);
}

// A level that cannot answer is pushed by an explicit force, and so is what it touches.
TEST(BodyIslandLaw, WhoCannotAnswerIsPushedExplicitly) {
  Balls balls({{0, 0, 1}, {0.199, 0, 1}});
  balls.interface(0).response = balls.interface(1).response = nullptr;
  for (ContactParameters& p : balls.set().parameters) p.mass = 0.1;
  balls.launch(0, {0.3, 0, 0});
  balls.step();
  const PairContact& c = balls.set().points[0];
  const ContactParameters p = for_explicit_step(balls.set().parameters[c.surface], dt);
  EXPECT_NEAR(c.force.x, -(p.stiffness * 1e-3 + p.damping * 0.3), 1e-9);
  EXPECT_LT(difference(balls.column(0, properties::external_force).f, c.force), 1e-12);
  EXPECT_LT(difference(balls.column(1, properties::external_force).f, -c.force), 1e-12);
  EXPECT_FALSE(balls.column(0, contacts).solved);
}

// Rule: entities whose numbers are not sane touch no other in that step.
TEST(BodyIslandLaw, BadNumbersAreNoRows) {
  const ImplicitStick law;
  for (const std::size_t bad : {0U, 1U}) {
    Balls balls({{0, 0, 0.099}, {0.199, 0, 0.099}});
    balls.stand(bad, law);
    balls.launch(0, {0.3, 0, 0});
    balls.answers[bad].sane = false;
    balls.step();
    EXPECT_EQ(balls.answers[1 - bad].next.x, bad == 0 ? 0 : 0.3) << bad;
    EXPECT_EQ(norm(balls.column(1 - bad, properties::external_force).f), 0);
    EXPECT_TRUE(balls.column(bad, contacts).solved) << "its level still takes its step";
  }
}

// More sweeps, more exactly: a row of balls, of which the first is pushed by the last but through all others.
TEST(BodyIslandLaw, TakesAsManySweepsAsItIsTold) {
  const auto error_after = [](int sweeps) {
    Balls balls({{0, 0, 1}, {0.199, 0, 1}, {0.398, 0, 1}, {0.597, 0, 1}},
                std::make_unique<BodyIslandLaw>(BodyIslandOptions{.sweeps = sweeps}));
    balls.launch(3, {-0.09, 0, 0});  // too slow for a bounce
    balls.step();
    double error = 0;
    for (const PairContact& c : balls.set().points) {
      const ContactParameters& p = balls.set().parameters[c.surface];
      const double v =
          balls.answers[static_cast<std::size_t>(c.b)].next.x - balls.answers[static_cast<std::size_t>(c.a)].next.x;
      error = std::max(error, std::abs(-c.force.x - (p.stiffness * (c.depth - p.theta * dt * v) - p.damping * v)));
    }
    return error;
  };
  EXPECT_GT(error_after(1), 1e-2);
  EXPECT_LT(error_after(10), 0.3 * error_after(1));
  EXPECT_LT(error_after(60), 5e-3);
}

}  // namespace
}  // namespace murosimf::collision
