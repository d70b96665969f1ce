// A fan of rays that are cast at once finds what each of them finds alone.
#include "murosimf/collision/scan.h"

#include <limits>

#include "murosimf/collision/queries.h"
#include "tests/collision/pitch.h"
#include "tests/law.h"

namespace murosimf::collision {
namespace {

using fixtures::Dice;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Fans of all openings: full circles, narrow ones, single rays, and rays that are all the same.
Fan random_fan(Dice& dice) {
  const double fov = dice.chance(0.2) ? 2 * pi : dice.chance(0.2) ? 0 : dice.uniform(0, 2 * pi);
  return {1 + dice.pick(300), dice.uniform(-10, 10), fov};
}

std::vector<double> one_by_one(QueryScene& scene, const Fan& fan, const Transformd& at, const RayLimits& limits) {
  std::vector<double> distances;
  for (std::size_t i = 0; i < fan.size(); ++i) {
    const auto hit = scene.cast(fan.ray(i, at), limits);
    distances.push_back(hit ? hit->distance : infinity);
  }
  return distances;
}

/// How many rays hit something, and how many do not find the same as alone.
struct Comparison {
  int hits = 0, rays = 0, different = 0;

  void see(const std::vector<double>& together, const std::vector<double>& alone) {
    for (std::size_t i = 0; i < alone.size(); ++i) {
      ++rays;
      if (alone[i] < infinity) ++hits;
      if (together[i] != alone[i]) ++different;
    }
  }
};

TEST(Scan, FindsWhatEachRayFindsAlone) {
  for (const auto volume : geometry::volume_names()) {
    Dice dice("scans");
    fixtures::Pitch pitch;
    QueryScene scene(pitch.world, std::string(volume));
    Comparison comparison;
    for (int i = 0; i < 200; ++i) {
      pitch.shake(dice);
      scene.refresh();
      const Fan fan = random_fan(dice);
      const Transformd at{dice.vector(1.5) + Vec3d{0, 0, 1.2}, dice.turn()};
      RayLimits limits;
      if (i % 3 == 0) limits.range = dice.uniform(0.5, 2);
      if (i % 2 == 0) limits.without = pitch.world.find("red");
      std::vector<double> distances(fan.size());
      scene.cast(fan, at, limits, distances);
      comparison.see(distances, one_by_one(scene, fan, at, limits));
    }
    EXPECT_GT(comparison.hits, 5000);
    EXPECT_LT(comparison.hits, comparison.rays - 5000);
    law::expect_equal({.law = "a scan: rays that find something else than each alone",
                       .level = std::string(volume),
                       .source = "rays cast one by one"},
                      comparison.different, 0, "rays");
  }
}

TEST(Scan, RaysGoCounterclockwiseFromTheFirstToTheLast) {
  const Fan fan(5, pi / 2, pi);
  const Transformd at{{1, 2, 3}, {}};
  EXPECT_EQ(fan.size(), 5u);
  EXPECT_LT(norm(fan.ray(0, at).direction - Vec3d{0, 1, 0}), 1e-15);
  EXPECT_LT(norm(fan.ray(2, at).direction - Vec3d{-1, 0, 0}), 1e-15);
  EXPECT_LT(norm(fan.ray(4, at).direction - Vec3d{0, -1, 0}), 1e-15);
  EXPECT_EQ(norm(fan.ray(4, at).origin - at.position), 0);
  EXPECT_LT(norm(Fan(2, 0, pi / 2).ray(1, at).direction - Vec3d{0, 1, 0}), 1e-15) << "of two the second is the last";
}

}  // namespace
}  // namespace murosimf::collision
