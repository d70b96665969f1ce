#include "murosimf/collision/queries.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <thread>

#include "murosimf/geometry/collide.h"
#include "tests/collision/pitch.h"

namespace murosimf::collision {
namespace {

using fixtures::Dice;
using fixtures::InWorld;
using fixtures::Pitch;
using geometry::Ray;

Ray random_ray(Dice& dice) { return {dice.vector(1.5) + Vec3d{0, 0, 1.2}, dice.unit()}; }

/// Every shape that the ray meets, the nearest first.
std::vector<RayHit> by_force(const Pitch& pitch, const Ray& ray, const RayLimits& limits) {
  std::vector<RayHit> hits;
  for (const InWorld& it : pitch.all()) {
    const auto met = geometry::meet(ray, it.shape, it.at);
    if (it.entity == limits.without || !met || met->distance > limits.range) continue;
    hits.push_back(
        {{it.entity, it.object}, it.index, met->distance, ray.origin + met->distance * ray.direction, met->normal});
  }
  std::sort(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) { return a.distance < b.distance; });
  return hits;
}

// Law: rays find what a walk over all shapes finds, for all kinds of volumes; the robot left out is not hit.
TEST(Queries, RaysAgreeWithBruteForce) {
  Dice dice("rays");
  std::size_t found = 0;
  for (const auto volume : geometry::volume_names()) {
    Pitch pitch;
    QueryScene scene(pitch.world, std::string(volume));
    for (int i = 0; i < 200; ++i) {
      pitch.shake(dice);
      scene.refresh();
      const Ray ray = random_ray(dice);
      RayLimits limits;
      if (i % 3 == 0) limits.range = dice.uniform(0.5, 2);
      if (i % 2 == 0) limits.without = pitch.world.find("red");
      const auto expected = by_force(pitch, ray, limits);
      const auto hits = scene.cast_all(ray, limits);
      ASSERT_EQ(hits.size(), expected.size()) << volume;
      for (std::size_t k = 0; k < hits.size(); ++k) EXPECT_EQ(hits[k].distance, expected[k].distance);
      const auto first = scene.cast(ray, limits);
      ASSERT_EQ(first.has_value(), !expected.empty());
      if (!first) continue;
      EXPECT_EQ(first->distance, expected[0].distance);
      // rounding of some products and sums of numbers up to ten meters, 2e-15 each
      EXPECT_LT(norm(first->point - ray.origin - first->distance * ray.direction), 5e-14);
      if (expected.size() > 1 && expected[1].distance == expected[0].distance) continue;
      EXPECT_EQ(first->body, expected[0].body);
      EXPECT_EQ(first->shape, expected[0].shape);
      EXPECT_EQ(norm(first->normal - expected[0].normal), 0);
      found += hits.size();
    }
  }
  EXPECT_GT(found, 200u);
}

// Law: a shape of any kind, a plane too, finds the bodies that it overlaps.
TEST(Queries, OverlapsAgreeWithBruteForce) {
  Dice dice("overlaps");
  auto kinds = fixtures::shapes_of_all_kinds();
  kinds.push_back(Plane{});
  int found = 0;
  for (const auto volume : geometry::volume_names()) {
    Pitch pitch;
    QueryScene scene(pitch.world, std::string(volume));
    for (int i = 0; i < 1000; ++i) {
      if (i % 20 == 0) pitch.shake(dice);
      scene.refresh();
      const Shape shape = kinds[static_cast<std::size_t>(i) % kinds.size()];
      const auto near = pitch.all()[static_cast<std::size_t>(dice.pick(12))];
      const Transformd at{near.at.position + dice.vector(0.2), dice.turn()};
      std::vector<BodyRef> expected;
      for (const InWorld& it : pitch.all()) {
        const BodyRef body{it.entity, it.object};
        const bool again = std::find(expected.begin(), expected.end(), body) != expected.end();
        geometry::Manifold overlap;
        if (!again && geometry::collide(shape, at, it.shape, it.at, overlap)) expected.push_back(body);
      }
      EXPECT_EQ(scene.overlapping(shape, at), expected) << volume;
      found += static_cast<int>(expected.size());
    }
  }
  EXPECT_GT(found, 500);
}

/// The least distance of two bodies' shapes; below 0, the deepest overlap.
double least_distance(const Pitch& pitch, const BodyRef& a, const BodyRef& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const InWorld& one : pitch.all()) {
    for (const InWorld& other : pitch.all()) {
      const bool first = one.entity == a.entity && (a.object == BodyRef::all || a.object == one.object);
      const bool second = other.entity == b.entity && (b.object == BodyRef::all || b.object == other.object);
      const bool planes = std::holds_alternative<Plane>(one.shape) && std::holds_alternative<Plane>(other.shape);
      if (first && second && !planes) {
        least = std::fmin(least, geometry::distance(one.shape, one.at, other.shape, other.at).distance);
      }
    }
  }
  return least;
}

// Law: the least distance over all shapes, of whole entities and of single bodies, with planes.
TEST(Queries, DistancesAgreeWithBruteForce) {
  Dice dice("distances");
  int overlapping = 0, apart = 0;
  for (const auto volume : geometry::volume_names()) {
    Pitch pitch;
    QueryScene scene(pitch.world, std::string(volume));
    const auto& entities = pitch.world.entities();
    for (int i = 0; i < 200; ++i) {
      pitch.shake(dice);
      scene.refresh();
      BodyRef a{entities[static_cast<std::size_t>(i) % entities.size()].get(), BodyRef::all};
      BodyRef b{entities[static_cast<std::size_t>(i + 1 + i % 3) % entities.size()].get(), BodyRef::all};
      if (a.entity == b.entity) continue;
      if (i % 2)
        a.object =
            a.entity->model()
                .bodies()[static_cast<std::size_t>(dice.pick(static_cast<int>(a.entity->model().bodies().size())))];
      const auto found = scene.distance(a, b);
      ASSERT_TRUE(found);
      EXPECT_EQ(found->distance, least_distance(pitch, a, b)) << volume;
      EXPECT_NEAR(norm(found->on_a - found->on_b), std::fabs(found->distance), 1e-6);
      (found->distance < 0 ? overlapping : apart) += 1;
      EXPECT_EQ(found->a.entity, a.entity);
      EXPECT_EQ(found->b.entity, b.entity);
      EXPECT_TRUE(a.object == BodyRef::all || found->a.object == a.object);
    }
  }
  EXPECT_GT(overlapping, 20);
  EXPECT_GT(apart, 20);
}

// Law: for a crowd, with some absent entities, the same as a loop over all of it; also if several threads ask at once.
TEST(Queries, CrowdsAgreeWithBruteForce) {
  Dice dice("crowd");
  World world;
  const auto ball = std::make_shared<const Model>(fixtures::ball_model(0.1, 1));
  std::vector<Vec3d*> places;
  for (int i = 0; i < 80; ++i) {
    Entity& entity = world.add("ball" + std::to_string(i), ball);
    places.push_back(&entity.column(properties::position).values[0]);
    entity.column(properties::orientation).values[0] = {};
  }
  QueryScene scene(world);
  std::size_t found = 0;
  for (int i = 0; i < 100; ++i) {
    for (Vec3d* place : places) *place = dice.vector(0.6);
    places[11]->y = std::nan("");
    places[12]->x = std::numeric_limits<double>::infinity();
    scene.refresh();
    std::vector<Ray> rays;
    for (int k = 0; k < 8; ++k) rays.push_back({dice.vector(0.6), dice.unit()});
    std::vector<std::vector<RayHit>> hits(rays.size());
    std::vector<std::thread> askers;
    for (std::size_t k = 0; k < rays.size(); k += 2) {
      askers.emplace_back([&, k] {
        for (const std::size_t ray : {k, k + 1}) hits[ray] = scene.cast_all(rays[ray], {.range = 2});
      });
    }
    for (std::thread& asker : askers) asker.join();
    for (std::size_t k = 0; k < rays.size(); ++k) {
      std::vector<double> expected;
      for (const Vec3d* place : places) {
        const auto met = geometry::meet(rays[k], Sphere{0.1}, {*place, {}});
        if (met && met->distance <= 2) expected.push_back(met->distance);
      }
      std::sort(expected.begin(), expected.end());
      ASSERT_EQ(hits[k].size(), expected.size());
      for (std::size_t h = 0; h < expected.size(); ++h) EXPECT_EQ(hits[k][h].distance, expected[h]);
      found += expected.size();
    }
  }
  EXPECT_GT(found, 500U);
}

TEST(Queries, ShapesAreThoseThatCollide) {
  Pitch pitch;
  QueryScene scene(pitch.world);
  EXPECT_EQ(scene.shapes(*pitch.world.find("red")).size(), colliding_shapes(pitch.world.find("red")->model()).size());
  EXPECT_EQ(scene.shapes(*pitch.world.find("field")).size(), 1U) << "the wall";
}

// Rule: after a refresh, bodies are where they are now.
TEST(Queries, RefreshFollowsMotion) {
  Dice dice("refresh");
  Pitch pitch;
  pitch.shake(dice);
  Entity& ball = *pitch.world.find("ball");
  ball.column(properties::position).values[0] = {7, 7, 5};
  QueryScene scene(pitch.world);
  const Ray down{{7, 7, 9}, {0, 0, -1}};
  EXPECT_NEAR(scene.cast(down)->distance, 3.9, 1e-14);
  ball.column(properties::position).values[0] = {7, 7, 7};
  scene.refresh();
  EXPECT_NEAR(scene.cast(down)->distance, 1.9, 1e-14);
  EXPECT_EQ(scene.cast(down)->body, (BodyRef{&ball, 0}));
}

TEST(Queries, EntityAddedLaterIsAMistakeWithAName) {
  Pitch pitch;
  QueryScene scene(pitch.world);
  const auto& late = pitch.world.add("late", std::make_shared<const Model>(fixtures::ball_model(0.1, 1)));
  const BodyRef ball{pitch.world.find("ball"), 0};
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { (void)scene.distance({&late, 0}, ball); }), {"'late'"}));
}

TEST(Queries, BodiesWithoutShapesHaveNoDistance) {
  Pitch pitch;
  pitch.world.add("ghost", std::make_shared<const Model>("ghost", Chain{}.base().with(properties::mass, 1.0)));
  QueryScene scene(pitch.world);
  EXPECT_FALSE(scene.distance({pitch.world.find("ghost")}, {pitch.world.find("ball")}));
}

// Rule: of shapes at the same distance a ray hits the one whose entity was added first, which also leads the list of all.
TEST(Queries, OfEqualDistancesTheEntityAddedFirstCounts) {
  World world;
  const auto box =
      std::make_shared<const Model>("box", Chain{}.base("box").with(properties::shapes,
                                                                    Shapes{fixtures::placed(Box{{0.1, 0.2, 0.3}})}));
  for (const char* name : {"one", "two", "three"}) {
    Entity& entity = world.add(name, box);
    entity.column(properties::position).values[0] = {1, 2, 3};
    entity.column(properties::orientation).values[0] = {};
  }
  QueryScene scene(world);
  const Ray ray{{-4, 2.03, 2.96}, {1, 0, 0}};
  const auto all = scene.cast_all(ray);
  ASSERT_EQ(all.size(), 3U);
  ASSERT_EQ(all[0].distance, all[2].distance);
  const auto first = scene.cast(ray);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->body.entity, world.find("one"));
  EXPECT_EQ(all[0].body.entity, world.find("one"));
  EXPECT_EQ(scene.cast(ray, {.without = world.find("one")})->body.entity, world.find("two"));
}

}  // namespace
}  // namespace murosimf::collision
