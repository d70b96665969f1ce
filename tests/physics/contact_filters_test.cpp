// Which shapes touch by their kinds: everywhere, against the rule spelled out bit by bit.
#include <array>

#include <gtest/gtest.h>

#include "tests/fixtures.h"
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

using fixtures::placed;

/// A shape of some kinds, that touches some kinds.
PlacedShape of_kinds(PlacedShape shape, std::uint32_t type, std::uint32_t affinity) {
  shape.contact_type = type;
  shape.contact_affinity = affinity;
  return shape;
}

/// Some kind is what one shape is and the other one touches.
bool share_a_kind(const PlacedShape& a, const PlacedShape& b) {
  for (int kind = 0; kind < 32; ++kind) {
    const auto has = [&](std::uint32_t kinds) { return kinds / (std::uint32_t{1} << kind) % 2 == 1; };
    if (has(a.contact_type) && has(b.contact_affinity)) return true;
    if (has(b.contact_type) && has(a.contact_affinity)) return true;
  }
  return false;
}

TEST(ContactKinds, AreComparedBitByBit) {
  fixtures::Dice dice("kinds");
  const auto bits = [&] {
    const std::array<std::uint32_t, 6> some{0, 1, 2, 3, 0x80000000u, 0xffffffffu};
    return some[static_cast<std::size_t>(dice.uniform(0, 5.999))];
  };
  int touching = 0;
  for (int i = 0; i < 2000; ++i) {
    const PlacedShape a = of_kinds({}, bits(), bits()), b = of_kinds({}, bits(), bits());
    EXPECT_EQ(may_touch(a, b), share_a_kind(a, b));
    EXPECT_EQ(may_touch(a, b), may_touch(b, a));
    touching += may_touch(a, b);
  }
  EXPECT_GT(touching, 200);
  EXPECT_LT(touching, 1800);
}

/// Calls test(shape, other) for all pairs of kinds of two bits; `test` returns whether they touched.
template <class Test>
void for_kinds(const PlacedShape& shape, const PlacedShape& other, const Test& test) {
  for (std::uint32_t kinds = 0; kinds < 256; kinds += 3) {
    const PlacedShape a = of_kinds(shape, kinds % 4, kinds / 4 % 4);
    const PlacedShape b = of_kinds(other, kinds / 16 % 4, kinds / 64);
    EXPECT_EQ(test(a, b), share_a_kind(a, b)) << "kinds " << kinds;
  }
}

ModelPtr body(const std::string& name, const Shapes& shapes) {
  return std::make_shared<const Model>(name, Chain{}
                                                 .base(name)
                                                 .with(properties::mass, 1.0)
                                                 .with(properties::inertia, diagonal(0.01))
                                                 .with(properties::shapes, shapes));
}

// Rule: robots that keep their own limbs apart by kinds (type 1, affinity 0) still meet each other.
TEST(ContactKinds, AreNotComparedBetweenEntities) {
  for (const std::uint32_t affinity : {0u, 1u, 2u}) {
    Rig rig;
    Entity& one = rig.add("one", body("one", {of_kinds(placed(Sphere{0.1}), 1, affinity)}), {.position = {0, 0, 1}});
    Entity& other =
        rig.add("other", body("other", {of_kinds(placed(Sphere{0.1}), 1, affinity)}), {.position = {0.19, 0, 1}});
    rig.attach_together({{&one, {}}, {&other, {}}});
    rig.simulation.initialize();
    rig.simulation.step();
    EXPECT_FALSE(rig.simulation.world().common().find(collision::pair_contacts)->values[0].points.empty()) << affinity;
  }
}

/// Contacts with an environment after one step, of a body whose lowest shape is a ball of 0.1 m in its middle.
std::vector<collision::ContactPoint> contacts_with(const Shapes& environment, const Shapes& shapes) {
  Simulation simulation;
  Entity& ground = simulation.world().add(
      "ground", std::make_shared<const Model>("ground", Chain{}.base("ground").with(properties::shapes, environment)));
  Entity& robot = simulation.world().add("robot", body("robot", shapes), {.position = {0, 0, -0.1}});
  simulation.attach<collision::GroundContact>("ground_contact", robot, 1000, &ground, law_named("implicit_stick"),
                                              MaterialTable{});
  simulation.attach<dynamics::ArticulatedDynamics>("articulated_dynamics", robot, 1000);
  simulation.initialize();
  simulation.step();
  return robot.find(collision::contacts)->values[0].points;
}

TEST(ContactKinds, DecideOnPlanesAndStaticShapes) {
  for (const Shape& obstacle : {Shape{Plane{}}, Shape{Box{{0.5, 0.5, 0.05}}}}) {
    SCOPED_TRACE(shape_name(obstacle));
    for_kinds(placed(Sphere{0.1}), placed(obstacle),
              [](const PlacedShape& a, const PlacedShape& b) { return !contacts_with({b}, {a}).empty(); });
  }
}

// Rule: leaving a shape out changes nothing for the others.
TEST(ContactKinds, OtherContactsStayAsTheyAre) {
  const Shapes environment{placed(Plane{}), of_kinds(placed(Plane{}, {0, 0, 0.01}), 2, 2),
                           placed(Box{{0.5, 0.5, 0.02}})};
  Shapes shapes{placed(Sphere{0.1}), placed(Box{{0.1, 0.1, 0.05}}, {0.2, 0, 0}), placed(Sphere{0.05}, {0, 0.2, 0})};
  for (PlacedShape& shape : shapes) shape = of_kinds(shape, 3, 3);
  const auto all = contacts_with(environment, shapes);
  for (const std::size_t only_one : {0, 1, 2}) {
    Shapes some = shapes;
    some[only_one] = of_kinds(some[only_one], 2, 2);
    std::vector<std::uint64_t> kept;
    for (const auto& found : contacts_with(environment, some)) {
      const auto same = std::find_if(all.begin(), all.end(), [&](const auto& c) { return c.feature == found.feature; });
      ASSERT_NE(same, all.end());
      EXPECT_EQ(same->surface, found.surface);
      EXPECT_EQ(norm(same->point - found.point), 0);
      kept.push_back(found.feature);
    }
    EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
    EXPECT_LT(kept.size(), all.size());
    EXPECT_GT(kept.size(), 0u);
  }
}

}  // namespace
}  // namespace murosimf::test
