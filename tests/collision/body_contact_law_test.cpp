// Two unequal bodies in empty space that meet off their centers and slide past each other: force, arms, memory, momentum.
#include "murosimf/collision/body_contact_law.h"

#include <gtest/gtest.h>

#include "murosimf/collision/body_pairs.h"
#include "murosimf/collision/contact_parameters.h"
#include "murosimf/collision/touches.h"
#include "tests/collision/movers.h"
#include "tests/fixtures.h"
#include "tests/physics/mechanics.h"
#include "tests/physics/rig.h"

namespace murosimf::collision {
namespace {

using fixtures::difference;
using test::Rig;

ModelPtr rough_ball(double radius, double mass, double friction) {
  PlacedShape sphere;
  sphere.shape = Sphere{radius};
  sphere.surface = {"", friction};
  sphere.position = {0.02, 0, 0.01};
  return std::make_shared<const Model>("ball", Chain{}
                                                   .base("ball")
                                                   .with(properties::mass, mass)
                                                   .with(properties::inertia, diagonal(0.4 * mass * radius * radius))
                                                   .with(properties::shapes, Shapes{sphere}));
}

/// They overlap by a millimeter or so along a slanted normal from the second one to the first one.
struct Meeting {
  explicit Meeting(BodyContactLaw law, const Vec3d& velocity = {0.3, -0.5, -0.4},
                   const std::string& level = "simplified_dynamics") {
    rig.simulation.world().gravity = {};
    const Vec3d n{0.48, 0.6, 0.64};
    small = &rig.add("small", rough_ball(0.05, 0.3, 0.4), {.position = (0.05 + 0.12 - 1e-3) * n + Vec3d{0, 0, 3}});
    big = &rig.add("big", rough_ball(0.12, 2.0, 0.6), {.position = {0, 0, 3.07}});
    rig.attach_together({{small, {.level = level, .on_ground = false}}, {big, {.level = level, .on_ground = false}}},
                        {.law = law});
    rig.simulation.initialize();
    Rig::launch(*small, velocity, {1, 2, -3});
    Rig::launch(*big, {0, 0.1, 0.2}, {-1, 0.5, 2});
    place(*small, (0.05 + 0.12 - 1e-3) * n);
    place(*big, {});
  }
  /// The center of its sphere.
  static void place(Entity& entity, const Vec3d& center) {
    entity.base().set(properties::position, center - Vec3d{0.02, 0, 0.01});
  }
  [[nodiscard]] const PairSet& set() const { return rig.ground->find(pair_contacts)->values[0]; }
  [[nodiscard]] Wrenchd total() {
    Wrenchd sum;
    for (Entity* entity : {small, big}) {
      for (const auto& body : test::moving_bodies(*entity)) {
        const Vec3d p = body.mass * body.velocity;
        sum += Wrenchd{cross(body.center, p) + body.inertia * body.angular_velocity, p};
      }
    }
    return sum;
  }
  Rig rig;
  Entity *small = nullptr, *big = nullptr;
};

// f_n = k depth - d v_n, f_t = -min(mu f_n, ct |v_t|) along v_t, at the velocities of the material points.
TEST(PairLawKelvinVoigt, ForceIsThatOfItsFormula) {
  for (const Vec3d& v : {Vec3d{0.3, -0.5, -0.4}, {-0.05, 0.09, 0.2}}) {
    Meeting meeting(BodyContactLaw::kelvin_voigt, v);
    const auto r_small = Rig::place(*meeting.small), r_big = Rig::place(*meeting.big);
    meeting.rig.simulation.step();
    ASSERT_EQ(meeting.set().points.size(), 1U);
    const PairContact& c = meeting.set().points[0];
    const ContactParameters& p = meeting.set().parameters[c.surface];
    EXPECT_LT(difference(c.normal, {0.48, 0.6, 0.64}), 1e-12);
    EXPECT_NEAR(c.depth, 1e-3, 1e-12);
    const Vec3d at_small = v + cross(Vec3d{1, 2, -3}, c.point - r_small);
    const Vec3d at_big = Vec3d{0, 0.1, 0.2} + cross(Vec3d{-1, 0.5, 2}, c.point - r_big);
    EXPECT_LT(difference(c.velocity, at_small - at_big), 1e-12);
    const double v_n = dot(c.velocity, c.normal);
    const Vec3d v_t = c.velocity - v_n * c.normal;
    const double f_n = std::max(0.0, p.stiffness * 1e-3 - p.damping * v_n);
    ASSERT_GT(f_n, 0);
    const Vec3d expected =
        f_n * c.normal - (std::min(p.friction * f_n, p.tangent_damping * norm(v_t)) / norm(v_t)) * v_t;
    EXPECT_LT(difference(c.force, expected), 1e-9);
  }
}

// Constants of a pair are those of the lighter one, on a body.
TEST(PairFinder, ConstantsAreThoseOfTheLighterBody) {
  Meeting meeting(BodyContactLaw::kelvin_voigt);
  meeting.rig.simulation.step();
  const ContactParameters& found = meeting.set().parameters[meeting.set().points[0].surface];
  const PairSurface pair = meeting.rig.materials.find({"", 0.4}, {"", 0.6});
  const ContactParameters expected = contact_parameters(meeting.small->model(), pair, 0, 1e-3, Partner::body);
  EXPECT_EQ(found.stiffness, expected.stiffness);
  EXPECT_EQ(found.damping, expected.damping);
  EXPECT_EQ(found.friction, expected.friction);
}

class PairLawByName : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Laws, PairLawByName, testing::Values("island_gauss_seidel", "carry", "kelvin_voigt"),
                         test::level_name);

BodyContactLaw law_of(const std::string& name) {
  for (const PairLawEntry& entry : body_contact_laws()) {
    if (entry.name == name) return entry.law;
  }
  throw std::runtime_error(name);
}

// Nothing from outside: momentum and its moment about the origin are afterwards what they were, and the bodies have parted.
TEST_P(PairLawByName, MeetingKeepsMomentum) {
  Meeting meeting(law_of(GetParam()));
  const Wrenchd before = [&] {
    Meeting untouched(law_of(GetParam()));
    Meeting::place(*untouched.small, {9, 9, 9});
    untouched.rig.simulation.step();
    Wrenchd sum = untouched.total();
    // where it is now does not count, its momentum does
    return Wrenchd{{}, sum.f};
  }();
  bool touched = false;
  for (int i = 0; i < 400; ++i) {
    meeting.rig.simulation.step();
    touched |= !meeting.set().points.empty();
  }
  EXPECT_TRUE(touched);
  EXPECT_TRUE(meeting.set().points.empty());
  EXPECT_LT(difference(meeting.total().f, before.f), 1e-3 * norm(before.f));
}

// Rule: it comes off slower than it came, and friction slows what slides.
TEST_P(PairLawByName, MeetingLosesEnergy) {
  Meeting meeting(law_of(GetParam()));
  double before = 0, after = 0;
  for (Entity* entity : {meeting.small, meeting.big}) {
    const double m = entity->model().tree().mass;
    const Vec3d v = entity == meeting.small ? Vec3d{0.3, -0.5, -0.4} : Vec3d{0, 0.1, 0.2};
    const Vec3d w = entity == meeting.small ? Vec3d{1, 2, -3} : Vec3d{-1, 0.5, 2};
    const double radius = entity == meeting.small ? 0.05 : 0.12;
    before += 0.5 * m * dot(v, v) + 0.5 * 0.4 * m * radius * radius * dot(w, w);
  }
  meeting.rig.run(0.4);
  for (Entity* entity : {meeting.small, meeting.big}) after += test::kinetic_energy(*entity);
  EXPECT_LT(after, before);
  EXPECT_GT(after, 0.2 * before);
}

// Rule: friction that is just as large as the cone allows sticks; numbers are powers of two, so that nothing is rounded.
TEST(PairLawCarry, SticksOnTheEdgeOfItsCone) {
  ContactParameters p;
  p.stiffness = 8192;
  p.tangent_stiffness = 4096;
  p.tangent_damping = 3;
  p.friction = 0.5;
  for (const double beyond : {0.0, 1e-6}) {
    Movers movers;
    movers.add("light", ball(0.1, 1));
    movers.add("heavy", ball(0.1, 2), {0, 0, -0.199});
    PairContact c = joint_of(0, 1);
    c.normal = {0, 0, 1};
    c.depth = 0x1p-10;                     // 8 N
    c.stretch = {0, 0x1p-10 + beyond, 0};  // 4 N
    movers.set.points = {c};
    movers.set.parameters = {p};
    push_by_carry(movers.all, movers.set, 1e-3);
    const PairContact& after = movers.set.points[0];
    EXPECT_LT(difference(after.force, {0, -4, 8}), 1e-12) << beyond;
    EXPECT_EQ(after.state, beyond > 0 ? ContactState::slip : ContactState::stick);
    EXPECT_EQ(after.tangent_damping, beyond > 0 ? 0 : 3 + 1e-3 * 4096);
  }
}

TEST(Touches, AreSeenFromBothSides) {
  Meeting meeting(BodyContactLaw::kelvin_voigt);
  meeting.rig.simulation.step();
  const auto small = touches(meeting.rig.simulation.world(), *meeting.small);
  const auto big = touches(meeting.rig.simulation.world(), *meeting.big);
  ASSERT_EQ(small.size(), 1U);
  ASSERT_EQ(big.size(), 1U);
  EXPECT_EQ(small[0].other, meeting.big);
  EXPECT_EQ(big[0].other, meeting.small);
  EXPECT_EQ(big[0].entity, meeting.big);
  EXPECT_LT(difference(small[0].normal, {0.48, 0.6, 0.64}), 1e-12);
  EXPECT_LT(difference(small[0].normal + big[0].normal, {}), 1e-15);
  EXPECT_LT(difference(small[0].force + big[0].force, {}), 1e-15);
  EXPECT_GT(dot(small[0].force, small[0].normal), 1);
  EXPECT_EQ(small[0].depth, big[0].depth);
  meeting.small->freeze("test");
  EXPECT_TRUE(touches(meeting.rig.simulation.world(), *meeting.small).empty());
}

}  // namespace
}  // namespace murosimf::collision
