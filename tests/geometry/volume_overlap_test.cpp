#include "murosimf/geometry/volume_overlap.h"

#include <gtest/gtest.h>

#include "tests/geometry/volume_fixtures.h"

namespace murosimf::geometry {
namespace {

using fixtures::Dice;

template <class V, class W>
constexpr bool boxes_of_different_axes = (std::is_same_v<V, Obb> &&
                                          (std::is_same_v<W, Obb> || std::is_same_v<W, Aabb>)) ||
                                         (std::is_same_v<V, Aabb> && std::is_same_v<W, Obb>);

// Law: two volumes that share a point overlap, and their gap is zero. One is moved until a point of it, often of its
// surface, is a picometer inside the other.
TEST(VolumeOverlap, IsNeverMissed) {
  Dice dice("shared points");
  fixtures::for_all_pairs_of_kinds([&]<class V, class W>(const V&, const W&) {
    for (int i = 0; i < 2000; ++i) {
      const V v = fixtures::random_volume<V>(dice);
      W w = fixtures::random_volume<W>(dice);
      const Vec3d shared = fixtures::point_in(v, dice);
      const Vec3d inside = shared + 1e-12 * (fixtures::middle(v) - shared);
      fixtures::shift(w, inside - fixtures::point_in(w, dice));
      EXPECT_TRUE(overlap(v, w)) << typeid(V).name() << ' ' << typeid(W).name();
      EXPECT_LT(gap(v, w), 1e-12);
    }
  });
}

// Law: every combination is exact, against the distance found by alternating projections. So is the gap, but of two
// boxes of different axes, where it may be less.
TEST(VolumeOverlap, AgreesWithTheDistance) {
  Dice dice("distances");
  fixtures::for_all_pairs_of_kinds([&]<class V, class W>(const V&, const W&) {
    int apart = 0, together = 0;
    for (int i = 0; i < 200; ++i) {
      const V v = fixtures::random_volume<V>(dice);
      const W w = fixtures::random_volume<W>(dice);
      const double distance = fixtures::distance_by_projections(v, w);
      const auto what = [&] { return std::string(typeid(V).name()) + ' ' + typeid(W).name(); };
      EXPECT_LE(gap(v, w), distance + 1e-12) << what();
      // projections come to a corner within their number of turns, but creep where volumes touch
      if (distance > 1e-3) {
        ++apart;
        EXPECT_FALSE(overlap(v, w)) << what() << ' ' << distance;
        EXPECT_GE(gap(v, w), (boxes_of_different_axes<V, W> ? 0 : distance - 1e-6)) << what();
      } else if (distance < 1e-12) {
        ++together;
        EXPECT_TRUE(overlap(v, w)) << what();
      }
    }
    EXPECT_GT(apart, 20);
    EXPECT_GT(together, 5);
  });
}

// Law: a ray enters a volume if and only if a finely walked ray has a point in it.
TEST(VolumeRay, AgreesWithWalking) {
  Dice dice("walk the ray");
  fixtures::for_all_kinds([&]<class V>(const V&) {
    int hits = 0;
    for (int i = 0; i < 1500; ++i) {
      const V v = fixtures::random_volume<V>(dice);
      const Ray ray{dice.vector(1.5), i % 5 == 0 ? Vec3d{0, 0, -1} : dice.unit()};
      const double limit = dice.uniform(0.1, 3);
      double nearest = 1e300;
      for (int k = 0; k <= 200; ++k) {
        nearest = std::fmin(nearest, fixtures::outside(v, ray.origin + (k * limit / 200) * ray.direction));
      }
      if (nearest <= 0) {
        ++hits;
        EXPECT_TRUE(ray_enters(v, ray, limit)) << typeid(V).name();
      } else if (nearest > limit / 400) {
        EXPECT_FALSE(ray_enters(v, ray, limit)) << typeid(V).name();
      }
      EXPECT_EQ(ray_enters(v, ray, std::numeric_limits<double>::infinity()), ray_enters(v, ray, 10));
    }
    EXPECT_GT(hits, 10);
  });
}

}  // namespace
}  // namespace murosimf::geometry
