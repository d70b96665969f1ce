// Ways around obstacles against tangents and arcs, and against a fine grid; the map of obstacles.
#include "murosimf/soccer/tangent_path.h"

#include <limits>
#include <queue>
#include <tuple>

#include <gtest/gtest.h>

#include "murosimf/soccer/obstacle_map.h"
#include "tests/fixtures.h"
#include "tests/law.h"
#include "tests/soccer/vision_rig.h"

namespace murosimf::soccer {
namespace {

double length_of(std::span<const Vec3d> way) {
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += norm(Vec3d(way[i] - way[i - 1]));
  return length;
}

/// [m] of the nearest sample of the way to any disk's edge.
double clearance(std::span<const Vec3d> way, std::span<const Disk> disks) {
  double least = 1e9;
  for (std::size_t i = 1; i < way.size(); ++i) {
    for (int k = 0; k <= 100; ++k) {
      const Vec3d p = way[i - 1] + 0.01 * k * (way[i] - way[i - 1]);
      for (const Disk& disk : disks) least = std::min(least, norm(Vec3d(p - disk.center)) - disk.radius);
    }
  }
  return least;
}

TEST(WayAround, IsStraightWhereNothingStands) {
  WayAround around(4);
  const auto way = around.find({-1, 0, 0}, {2, 1, 0}, {});
  ASSERT_EQ(way.size(), 2u);
  EXPECT_DOUBLE_EQ(length_of(way), std::hypot(3, 1));
}

TEST(WayAround, IsTangentsAndAnArcAroundOneDisk) {
  const Disk disk{{0, 0, 0}, 0.4};
  WayAround around(4);
  const auto way = around.find({-1.5, 0, 0}, {1.2, 0, 0}, std::span(&disk, 1));
  const auto tangent = [&](double d) { return std::sqrt(d * d - 0.16); };
  const double arc = pi - std::acos(0.4 / 1.5) - std::acos(0.4 / 1.2);
  const double shortest = tangent(1.5) + tangent(1.2) + 0.4 * arc;
  EXPECT_GE(length_of(way), shortest - 1e-9);
  EXPECT_LT(length_of(way), 1.02 * shortest);
  EXPECT_GT(clearance(way, std::span(&disk, 1)), -1e-6);
}

TEST(WayAround, DoesNotLeaveItsBounds) {
  const Disk disk{{0, 0.2, 0}, 0.4};  // below it is shorter
  WayAround around(4);
  for (const Vec3d& p : around.find({-1, 0, 0}, {1, 0, 0}, std::span(&disk, 1))) EXPECT_LE(p.y, 0.01);
  bool above = false;
  for (const Vec3d& p : around.find({-1, 0, 0}, {1, 0, 0}, std::span(&disk, 1), {.lowest_y = -0.1})) {
    EXPECT_GE(p.y, -0.1);
    above = above || p.y > 0.5;
  }
  EXPECT_TRUE(above);
}

TEST(WayAround, IsNoneThroughAWall) {
  std::vector<Disk> wall;
  for (int i = -4; i <= 4; ++i) wall.push_back({{0, 0.25 * i, 0}, 0.3});
  WayAround around(16);
  EXPECT_TRUE(around.find({-1, 0, 0}, {1, 0, 0}, wall, {.lowest_y = -1, .highest_y = 1}).empty());
  EXPECT_FALSE(around.find({-1, 0, 0}, {1, 0, 0}, wall).empty());
}

TEST(WayAround, LeadsOutOfADisk) {
  const Disk disk{{0, 0, 0}, 0.4};
  WayAround around(4);
  const auto way = around.find({-0.3, 0, 0}, {1, 0, 0}, std::span(&disk, 1));
  ASSERT_FALSE(way.empty());
  const Disk smaller{{0, 0, 0}, 0.98 * 0.3};
  EXPECT_GT(clearance(way, std::span(&smaller, 1)), -1e-6);
}

/// [m] of the shortest way on a grid of 40 mm with 16 directions; infinite if there is none.
double grid_length(const Vec3d& start, const Vec3d& goal, std::span<const Disk> disks) {
  constexpr int n = 101;
  constexpr double cell = 0.04;
  const auto place = [&](int i) { return Vec3d{cell * (i % n) - 2, cell * (i / n) - 2, 0}; };
  const auto index = [&](const Vec3d& p) {
    return static_cast<int>(std::lround((p.y + 2) / cell)) * n + static_cast<int>(std::lround((p.x + 2) / cell));
  };
  const auto is_free = [&](const Vec3d& p) {
    return std::all_of(disks.begin(), disks.end(),
                       [&](const Disk& d) { return norm(Vec3d(p - d.center)) >= d.radius; });
  };
  std::vector<double> cost(n * n, std::numeric_limits<double>::infinity());
  std::priority_queue<std::pair<double, int>> open;
  open.emplace(0, index(start));
  cost[static_cast<std::size_t>(index(start))] = 0;
  constexpr std::array steps{1, 0, 1, 1, 1, 2, 2, 1};
  while (!open.empty()) {
    const auto [c, i] = open.top();
    open.pop();
    if (-c > cost[static_cast<std::size_t>(i)]) continue;
    for (int k = 0; k < 16; ++k) {
      int dx = steps[2 * (k % 4)], dy = steps[2 * (k % 4) + 1];
      for (int turn = 0; turn < k / 4; ++turn) std::tie(dx, dy) = std::pair(-dy, dx);
      const int x = i % n + dx, y = i / n + dy, to = y * n + x;
      if (x < 0 || y < 0 || x >= n || y >= n || !is_free(place(to)) || !is_free(0.5 * (place(i) + place(to)))) continue;
      const double next = -c + cell * std::hypot(dx, dy);
      if (next >= cost[static_cast<std::size_t>(to)]) continue;
      cost[static_cast<std::size_t>(to)] = next;
      open.emplace(-next, to);
    }
  }
  return cost[static_cast<std::size_t>(index(goal))];
}

TEST(WayAround, IsAboutAsShortAsOnAGrid) {
  fixtures::Dice dice("ways");
  WayAround around(8);
  law::Worst longer;
  for (int round = 0; round < 15; ++round) {
    std::vector<Disk> disks;
    while (disks.size() < 6)
      disks.push_back({{dice.uniform(-1.3, 1.3), dice.uniform(-1, 1), 0}, dice.uniform(0.1, 0.4)});
    const Vec3d start{-2, 0, 0}, goal{2, 0, 0};
    const auto way = around.find(start, goal, disks, {-2, 2, -2, 2});
    const double grid = grid_length(start, goal, disks);
    ASSERT_EQ(way.empty(), !std::isfinite(grid)) << round;
    if (way.empty()) continue;
    EXPECT_GT(clearance(way, disks), -1e-6) << round;
    longer.see(length_of(way) / grid, round);
  }
  law::expect_below({.law = "length of the way around six disks over the shortest on a fine grid",
                     .level = "visibility graph of polygons of 16 corners",
                     .source = "Dijkstra on a grid of 40 mm with 16 directions, whose ways are up to 2.8 % too long"},
                    longer, 1.02, "1");
}

TEST(ObstacleMap, IsTheMeanAtFirstAndFollowsLater) {
  soccer::ObstacleMap map;
  map.see({1, 0, 0}, true, 0.3);
  map.see({1.1, 0, 0}, true, 0.3);
  ASSERT_EQ(map.all().size(), 1u);
  EXPECT_NEAR(map.all()[0].place.x, 1.05, 1e-12);
  for (int i = 0; i < 40; ++i) map.see({1.2, 0, 0}, true, 0.3);
  EXPECT_NEAR(map.all()[0].place.x, 1.2, 1e-3);
  map.see({1.2, 0.4, 0}, true, 0.3);
  EXPECT_EQ(map.all().size(), 2u);
}

TEST(ObstacleMap, IsNotMovedByWhatIsCutOff) {
  soccer::ObstacleMap map;
  map.see({1, 0, 0}, false, 0.3);
  map.see({1.2, 0, 0}, false, 0.3);
  ASSERT_EQ(map.all().size(), 1u);
  EXPECT_EQ(map.all()[0].place.x, 1);
  EXPECT_EQ(map.all()[0].sightings, 2);
}

TEST(ObstacleMap, HasRoomForSoManyAndNoMore) {
  soccer::ObstacleMap map;
  for (std::size_t i = 0; i < 2 * soccer::most_obstacles; ++i) map.see({static_cast<double>(i), 0, 0}, true, 0.3);
  EXPECT_EQ(map.all().size(), soccer::most_obstacles);
}

TEST(ObstacleOfABlob, StandsWhereItsFootIsSeen) {
  const imaging::Lens lens = test::plain_lens();
  const soccer::CameraPose camera = test::looking_down(0.45, 0.3);
  const Vec3d middle{1.5, 0.4, 0};
  const double distance = norm(middle), radius = 0.1;
  const Vec3d foot = (1 - radius / distance) * middle;
  const auto pixel = soccer::in_picture(lens, camera, foot);
  ASSERT_TRUE(pixel);
  soccer::Blob blob;
  blob.left = 50, blob.right = 80, blob.bottom = static_cast<int>(pixel->v);
  blob.lowest = {pixel->u, pixel->v - 0.5};
  const auto seen = soccer::obstacle_of(blob, lens, camera, radius, 3);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(norm(Vec3d(seen->place - middle)), 0, 1e-9);
  EXPECT_TRUE(seen->whole);
  EXPECT_FALSE(soccer::obstacle_of(blob, lens, camera, radius, 1));
  blob.left = 0;
  EXPECT_FALSE(soccer::obstacle_of(blob, lens, camera, radius, 3)->whole);
  blob.bottom = 239;
  EXPECT_FALSE(soccer::obstacle_of(blob, lens, camera, radius, 3));
}

}  // namespace
}  // namespace murosimf::soccer
