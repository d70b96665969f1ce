// Who is solved together and who by itself, what the ground's rows are, and what members of an island are told afterwards.
#include "murosimf/collision/body_contact.h"

#include <gtest/gtest.h>

#include "murosimf/collision/contact_law_parts.h"
#include "murosimf/collision/implicit_stick_law.h"
#include "murosimf/collision/kelvin_voigt_law.h"
#include "tests/collision/movers.h"

namespace murosimf::collision {
namespace {

using fixtures::difference;

constexpr double dt = 1e-3;

/// Balls of 0.1 m under `body_contact`. Masses are 1, 2, 3 kg ..., velocities zero.
struct Balls {
  explicit Balls(const std::vector<Vec3d>& places, const BodyContactOptions& options = {}) {
    field = &world.add("field", std::make_shared<const Model>("field", Chain{}.base("ground")));
    std::vector<Entity*> entities;
    for (std::size_t i = 0; i < places.size(); ++i) {
      balls.push_back(&world.add("ball" + std::to_string(i), ball(0.1, static_cast<double>(i + 1))));
      entities.push_back(balls[i]);
    }
    Setup setup(world, *field, access);
    contact = std::make_unique<BodyContact>(setup, entities, MaterialTable{}, options);
    for (std::size_t i = 0; i < places.size(); ++i) {
      column(i, properties::dynamic) = 1;
      column(i, properties::position) = places[i];
      column(i, properties::orientation) = {};
      column(i, properties::linear_velocity) = column(i, properties::angular_velocity) = {};
      column(i, properties::external_force) = column(i, properties::interaction_force) = {{1, 2, 3}, {4, 5, 6}};
      column(i, properties::external_damping).M = diagonal(7.0);
      column(i, properties::absorbed_impulse) = {{1, 2, 3}, {4, 5, 6}};
      column(i, properties::separation) = {1, 2, 3};
      column(i, contacts).rest_force.resize(1);
      answers.emplace_back();
      answers[i].mass = static_cast<double>(i + 1);
      answers[i].force = column_of(i, properties::external_force);
      seam(i).response = &answers[i];
    }
    contact->initialize();
  }
  template <class T>
  std::vector<T>& column_of(std::size_t i, const Property<T>& property) {
    return balls[i]->column(property).values;
  }
  template <class T>
  T& column(std::size_t i, const Property<T>& property) {
    return column_of(i, property)[0];
  }
  ContactSeam& seam(std::size_t i) { return column(i, contact_seam); }
  PairSet& set() { return field->column(pair_contacts).values[0]; }
  void step() { contact->step({{}, std::chrono::milliseconds(1)}); }
  void launch(std::size_t i, const Vec3d& v) { column(i, properties::linear_velocity) = answers[i].now = v; }
  /// A ground contact of ball i as ground_contact leaves it, with `law`, below the ball, pressed by 1 mm.
  void stand(std::size_t i, const ContactLaw& law) {
    seam(i).law = &law;
    seam(i).terms.parameters = {ground()};
    ContactPoint point;
    point.normal = {0, 0, 1};
    point.point = column(i, properties::position) - Vec3d{0, 0, 0.099};
    point.depth = 1e-3;
    point.radius = 0.1;
    point.velocity = column(i, properties::linear_velocity);
    point.angular_velocity = {0, 10, 0};
    ContactSet& set = column(i, contacts);
    set.points = {point};
    set.loaded = {0};
    law.prepare(set.points, seam(i).terms);
    const std::vector<Vec3d> r{column(i, properties::position)};
    write_loads(set, r, column_of(i, properties::external_force), column_of(i, properties::external_damping));
  }
  static ContactParameters ground() {
    return {.stiffness = 1e4,
            .damping = 50,
            .tangent_stiffness = 8e3,
            .tangent_damping = 25,
            .friction = 0.5,
            .rolling = 0.03};
  }

  World world;
  AccessSet access;
  Entity* field = nullptr;
  std::vector<Entity*> balls;
  std::deque<PointMass> answers;
  std::unique_ptr<BodyContact> contact;
};

TEST(BodyContact, BeginsWithNothing) {
  Balls balls({{0, 0, 1}, {2, 0, 1}}, {.law = BodyContactLaw::carry});
  EXPECT_EQ(balls.set().entities, (std::vector<int>{1, 2}));
  EXPECT_FALSE(balls.set().parameters.empty());
  for (const std::size_t i : {0U, 1U}) {
    for (const auto& property :
         {properties::interaction_force, properties::external_force, properties::absorbed_impulse})
      EXPECT_EQ(norm(balls.column(i, property).f) + norm(balls.column(i, property).n), 0);
    EXPECT_EQ(balls.column(i, properties::external_damping).M.xx, 0);
    EXPECT_EQ(norm(balls.column(i, properties::separation)), 0);
    EXPECT_EQ(balls.seam(i).terms.dt, 1e-3);
    EXPECT_TRUE(balls.seam(i).damped_by_others);
  }
  Balls others({{0, 0, 1}});
  EXPECT_FALSE(others.seam(0).damped_by_others);
}

// Two that come together: the force that the law says for the velocities afterwards, told to both as a push.
TEST(BodyContact, AnIslandOfTwo) {
  Balls balls({{0, 0, 1}, {0.199, 0, 1}});
  balls.launch(0, {0.3, 0, 0});
  balls.launch(1, {-0.1, 0, 0});
  balls.step();
  ASSERT_EQ(balls.set().points.size(), 1U);
  const PairContact& c = balls.set().points[0];
  const ContactParameters& p = balls.set().parameters[c.surface];
  const double v = balls.answers[1].next.x - balls.answers[0].next.x;
  const double f = p.stiffness * (1e-3 - p.theta * dt * v) - p.damping * v;
  ASSERT_GT(f, 1);
  EXPECT_LT(difference(c.force, {-f, 0, 0}), 1e-6 * f);
  EXPECT_NEAR(balls.answers[0].next.x, 0.3 - dt * f, 1e-9);
  EXPECT_NEAR(balls.answers[1].next.x, -0.1 + dt * f / 2, 1e-9);
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

// Two pairs are two islands: whoever stands in one, the other does not.
TEST(BodyContact, IslandsKnowNothingOfEachOther) {
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
TEST(BodyContact, GroundOfAMemberBecomesRows) {
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
TEST(BodyContact, FreePassKnowsRollingResistance) {
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
  balls.seam(0).response = &witness;
  balls.column(0, contacts).rest_force[0] = {{0, 0, 0.5}, {0, 3, 0}};
  balls.stand(0, law);
  const ContactPoint before = balls.column(0, contacts).points[0];
  balls.step();
  EXPECT_EQ(witness.seen_dt, dt);
  EXPECT_LT(difference(witness.seen_force.f, {0, 3, 0}), 1e-12) << "the ground is a row";
  EXPECT_LT(difference(witness.seen_force.n, Vec3d{0, 0, 0.5} + before.moment), 1e-12);
  ASSERT_GT(before.angular_damping, 0);
  EXPECT_LT(difference(witness.seen_damping.J, diagonal(before.angular_damping)), 1e-15);
  EXPECT_EQ(witness.seen_damping.M.xx, 0);
  EXPECT_TRUE(balls.column(0, contacts).solved) << "a law that wants an island has one, touching others or not";
  EXPECT_TRUE(balls.column(0, contacts).island_stands);
}

// A law that is no rows keeps its force in the free pass, and its memory goes on with the velocity after the step.
TEST(BodyContact, ExplicitLawKeepsItsForceAndMemory) {
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
TEST(BodyContact, WhoCannotAnswerIsPushedExplicitly) {
  Balls balls({{0, 0, 1}, {0.199, 0, 1}});
  balls.seam(0).response = balls.seam(1).response = nullptr;
  balls.launch(0, {0.3, 0, 0});
  balls.step();
  const PairContact& c = balls.set().points[0];
  const ContactParameters& p = balls.set().parameters[c.surface];
  EXPECT_NEAR(c.force.x, -(p.stiffness * 1e-3 + p.damping * 0.3), 1e-9);
  EXPECT_LT(difference(balls.column(0, properties::external_force).f, c.force), 1e-12);
  EXPECT_LT(difference(balls.column(1, properties::external_force).f, -c.force), 1e-12);
  EXPECT_FALSE(balls.column(0, contacts).solved);
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

// Rule: numbers that have gone bad touch nobody in that step.
TEST(BodyContact, BadNumbersAreNoRows) {
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
TEST(BodyContact, TakesAsManySweepsAsItIsTold) {
  const auto error_after = [](int sweeps) {
    Balls balls({{0, 0, 1}, {0.199, 0, 1}, {0.398, 0, 1}, {0.597, 0, 1}}, {.sweeps = sweeps});
    balls.launch(3, {-2, 0, 0});
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
  EXPECT_LT(error_after(60), 1e-3);
}

TEST(BodyContact, OtherLaws) {
  for (const BodyContactLaw law : {BodyContactLaw::kelvin_voigt, BodyContactLaw::carry}) {
    Balls balls({{0, 0, 1}, {0.199, 0, 1}}, {.law = law});
    balls.launch(0, {0.3, 0, 0});
    balls.step();
    const PairContact& c = balls.set().points[0];
    EXPECT_LT(c.force.x, -1);
    EXPECT_LT(difference(balls.column(0, properties::external_force).f, c.force), 1e-12);
    EXPECT_EQ(balls.column(0, properties::external_damping).M.xx > 0, law == BodyContactLaw::carry);
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

}  // namespace
}  // namespace murosimf::collision
