// Where a body touches planes and static shapes: every contact with its object, surface, radius and a number of its own.
#include "murosimf/collision/ground_finder.h"

#include <gtest/gtest.h>

#include <set>

#include "murosimf/collision/body_pairs.h"
#include "murosimf/model/properties.h"
#include "tests/fixtures.h"
#include "tests/physics/rig.h"

namespace murosimf::collision {
namespace {

using fixtures::difference;
using fixtures::placed;

/// A plane at z = 0 and a pedestal whose top is at z = 0.5.
const Entity& pedestal() {
  static const Entity entity(
      "field",
      std::make_shared<const Model>("field", Chain{}
                                                 .base("ground")
                                                 .with(properties::shapes, Shapes{placed(Plane{})})
                                                 .translation({2, 1, 0.25}, "pedestal")
                                                 .with(properties::shapes, Shapes{placed(Box{{0.4, 0.3, 0.25}})})));
  return entity;
}

struct Found {
  std::vector<ContactPoint> points;
  TestCounts tests;
};

/// Contacts of one shape, 20 mm beside its body's origin, whose lowest point is `z` [m] high at (x, y).
Found find(GroundFinder& finder, const Vec3d& r) {
  Found found;
  const std::vector<Vec3d> places{r};
  const std::vector<Mat3d> turns{Mat3d{}};
  finder.find(places, turns, found.points, found.tests);
  return found;
}

Entity body(const Shape& shape) {
  return {"body",
          std::make_shared<const Model>("body", Chain{}
                                                    .base("body")
                                                    .with(properties::mass, 1.0)
                                                    .with(properties::shapes, Shapes{placed(shape, {0.02, 0, 0})}))};
}

TEST(GroundFinder, BallTouchesPlaneAndPedestalWithItsRadius) {
  const Entity ball = body(Sphere{0.1});
  GroundFinder finder(ball, &pedestal());
  EXPECT_TRUE(find(finder, {0, 0, 0.11}).points.empty());
  const auto plane = find(finder, {0, 0, 0.098}).points;
  ASSERT_EQ(plane.size(), 1U);
  EXPECT_NEAR(plane[0].depth, 0.002, 1e-12);
  EXPECT_EQ(plane[0].radius, 0.1);
  const auto top = find(finder, {2.1, 1, 0.597}).points;
  ASSERT_EQ(top.size(), 1U);
  EXPECT_NEAR(top[0].depth, 0.003, 1e-12);
  EXPECT_EQ(top[0].radius, 0.1);
  EXPECT_LT(difference(top[0].normal, {0, 0, 1}), 1e-12);
  EXPECT_NEAR(top[0].point.x, 2.12, 1e-12);
  EXPECT_NE(top[0].surface, plane[0].surface);
  EXPECT_NE(top[0].feature, plane[0].feature);
}

TEST(GroundFinder, BoxStandsOnItsCornersWithoutARadius) {
  const Entity box = body(Box{{0.05, 0.04, 0.03}});
  GroundFinder finder(box, &pedestal());
  for (const Vec3d& r : {Vec3d{0, 0, 0.029}, Vec3d{2, 1, 0.529}}) {
    const auto points = find(finder, r).points;
    ASSERT_EQ(points.size(), 4U);
    std::set<std::uint64_t> features;
    for (const ContactPoint& c : points) {
      EXPECT_NEAR(c.depth, 0.001, 1e-12);
      EXPECT_EQ(c.radius, 0);
      EXPECT_EQ(c.object, 0);
      EXPECT_NEAR(std::abs(c.point.x - r.x - 0.02), 0.05, 1e-9);
      EXPECT_NEAR(std::abs(c.point.y - r.y), 0.04, 1e-9);
      features.insert(c.feature);
    }
    EXPECT_EQ(features.size(), 4U);
  }
}

// The answer whether static shapes are near holds for 5 cm: a body that comes slowly must meet them all the same.
TEST(GroundFinder, MeetsWhatItComesToInSmallSteps) {
  const Entity ball = body(Sphere{0.1});
  GroundFinder finder(ball, &pedestal());
  double met = 0;
  for (double x = 0; x < 2 && met == 0; x += 0.004) {
    if (!find(finder, {x, 1, 0.3}).points.empty()) met = x;
  }
  EXPECT_NEAR(met, 2 - 0.4 - 0.1 - 0.02, 0.005);
}

// Many shapes on several static ones, in trees that have their own order: contacts come by feature, as the memory needs it.
TEST(GroundFinder, ContactsComeInTheOrderOfTheirFeatures) {
  Shapes beads, plates;
  for (const double x : {0.5, -0.3, 0.1, -0.5, 0.3, -0.1, 0.7}) beads.push_back(placed(Sphere{0.05}, {x, 0, 0}));
  for (const double x : {0.6, -0.6, 0.2, -0.2}) plates.push_back(placed(Box{{0.19, 0.2, 0.1}}, {x, 0, 0}));
  const Entity necklace("necklace",
                        std::make_shared<const Model>("necklace", Chain{}.base().with(properties::shapes, beads)));
  const Entity path("path", std::make_shared<const Model>("path", Chain{}.base().with(properties::shapes, plates)));
  GroundFinder finder(necklace, &path);
  const auto points = find(finder, {0.02, 0, 0.149}).points;
  ASSERT_EQ(points.size(), 7U);
  for (std::size_t i = 1; i < 7; ++i) EXPECT_LT(points[i - 1].feature, points[i].feature);
}

// A corner of two planes: each has features and a surface of its own.
TEST(GroundFinder, PlanesAreToldApart) {
  const Entity corner("corner", std::make_shared<const Model>(
                                    "corner", Chain{}.base().with(properties::shapes,
                                                                  Shapes{placed(Plane{}),
                                                                         placed(Plane{}, {}, rotation_y(pi / 2))})));
  const Entity ball = body(Sphere{0.1});
  GroundFinder finder(ball, &corner);
  const auto points = find(finder, {0.078, 0, 0.099}).points;
  ASSERT_EQ(points.size(), 2U);
  EXPECT_LT(points[0].feature, points[1].feature);
  EXPECT_EQ(points[0].surface, 0U);
  EXPECT_EQ(points[1].surface, 1U);
  EXPECT_LT(difference(points[0].normal, {0, 0, 1}), 1e-12);
  EXPECT_LT(difference(points[1].normal, {1, 0, 0}), 1e-12);
  EXPECT_NEAR(points[1].depth, 0.002, 1e-12);
}

// Three planes and two boxes: contacts come plane by plane, and within one shape by shape, each with a number of its own.
TEST(GroundFinder, EveryShapeHasItsNumbersOnEveryPlane) {
  const Entity corner("corner",
                      std::make_shared<const Model>(
                          "corner", Chain{}.base().with(properties::shapes,
                                                        Shapes{placed(Plane{}), placed(Plane{}, {}, rotation_y(pi / 2)),
                                                               placed(Plane{}, {}, rotation_x(-pi / 2))})));
  const Box box{{0.05, 0.04, 0.03}};
  const Entity boxes("boxes", std::make_shared<const Model>(
                                  "boxes", Chain{}.base("boxes").with(properties::shapes,
                                                                      Shapes{placed(box), placed(box, {0, 0.1, 0})})));
  GroundFinder finder(boxes, &corner);
  const auto points = find(finder, {0.049, 0.038, 0.027}).points;
  ASSERT_EQ(points.size(), 4U + 4U + 4U + 4U + 4U) << "one of the boxes is not at the plane y = 0";
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_LT(points[i - 1].feature, points[i].feature) << i;
    EXPECT_LE(points[i - 1].surface, points[i].surface) << i;
  }
  EXPECT_EQ(points.back().surface, 2U) << "both boxes have the same surface";
  EXPECT_LT(difference(points.back().normal, {0, 1, 0}), 1e-12);
}

// Memory for the points is taken once: as many as there are when everything is under all planes. A box has eight.
TEST(GroundFinder, KnowsHowManyPointsThereMayBe) {
  const Entity box = body(Box{{0.05, 0.04, 0.03}});
  GroundFinder finder(box, &pedestal());
  EXPECT_EQ(finder.most_on_planes(), 8U);
  EXPECT_EQ(find(finder, {0, 0, -1}).points.size(), 8U);
  EXPECT_EQ(GroundFinder(box, nullptr).most_on_planes(), 0U);
}

TEST(GroundFinder, WithoutEnvironmentThereIsNothing) {
  const Entity ball = body(Sphere{0.1});
  GroundFinder finder(ball, nullptr);
  EXPECT_TRUE(find(finder, {0, 0, 0}).points.empty());
}

/// Two balls of 0.1 m that overlap by 2 mm and come together, `height` [m] above the ground.
ContactSet set_after_a_step(double height) {
  test::Rig rig;
  rig.simulation.world().gravity = {};
  const auto model = std::make_shared<const Model>("ball", Chain{}
                                                               .base("ball")
                                                               .with(properties::mass, 1.0)
                                                               .with(properties::inertia, diagonal(0.004))
                                                               .with(properties::shapes, Shapes{placed(Sphere{0.1})}));
  Entity& low = rig.add("low", model, {.position = {0, 0, height}});
  Entity& high = rig.add("high", model, {.position = {0, 0, height + 0.198}});
  rig.attach_together({{&low, {}}, {&high, {}}});
  rig.simulation.initialize();
  test::Rig::launch(high, {0, 0, -0.09});  // too slow for a bounce
  rig.simulation.step();
  const auto& points = rig.simulation.world().common().find(pair_contacts)->values[0].points;
  EXPECT_EQ(points.size(), 1U);
  if (points.size() != 1) return {};
  // the force is the law's at the end of the step: k (depth - theta h v) - d v
  const ContactParameters& p =
      rig.simulation.world().common().find(pair_contacts)->values[0].parameters[points[0].surface];
  const double v = test::Rig::velocity(high).z - test::Rig::velocity(low).z;
  EXPECT_NEAR(norm(points[0].force), p.stiffness * (points[0].depth - p.theta * 1e-3 * v) - p.damping * v,
              1e-3 * norm(points[0].force));
  return high.find(contacts)->values[0];
}

// Rule: an island stands if any of its entities touches the ground.
TEST(BodyContactIsland, StandsIfSomebodyInItDoes) {
  EXPECT_TRUE(set_after_a_step(-1e-3).island_stands);
  EXPECT_FALSE(set_after_a_step(1).island_stands);
}

}  // namespace
}  // namespace murosimf::collision
