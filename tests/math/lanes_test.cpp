// Numbers of several things in the lanes of packs, and back.
#include "murosimf/math/lanes.h"

#include <bit>
#include <numeric>

#include <gtest/gtest.h>

#include "murosimf/math/spatial.h"

namespace murosimf {
namespace {

/// Every number of every lane is another one.
std::vector<std::vector<double>> different_columns(std::size_t count) {
  std::vector<std::vector<double>> columns(Pack8::lanes, std::vector<double>(count));
  double next = 1;
  for (auto& column : columns) {
    for (double& number : column) number = next++;
  }
  return columns;
}

TEST(Lanes, MasksNameLanes) {
  const LaneMask mask = lane_bit(0) | lane_bit(5) | lane_bit(7);
  std::vector<int> visited;
  for_lanes(mask, [&](int lane) { visited.push_back(lane); });
  EXPECT_EQ(visited, (std::vector<int>{0, 5, 7}));
  const Pack8 chosen = select(where(mask), Pack8(1.0), Pack8(-1.0));
  for (int lane = 0; lane < Pack8::lanes; ++lane) EXPECT_EQ(chosen.lane(lane), has_lane(mask, lane) ? 1 : -1);
  EXPECT_TRUE(all(where(0xff)));
  EXPECT_FALSE(all(where(0xfe)));
  EXPECT_TRUE(all(where(~LaneMask{0}))) << "bits beyond the lanes do not matter";
}

TEST(Lanes, RowsGoIntoPacksAndBack) {
  const auto columns = different_columns(30);
  const std::vector<std::size_t> rows{0, 3, 4, 9};  // of three numbers each
  std::vector<Vec3<Pack8>> packs(rows.size());
  LaneRows<const double> from;
  for (std::size_t lane = 0; lane < from.size(); ++lane) from[lane] = columns[lane].data();
  gather(from, rows, [&](std::size_t k) -> Vec3<Pack8>& { return packs[k]; });
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (int lane = 0; lane < Pack8::lanes; ++lane) {
      const auto& column = columns[static_cast<std::size_t>(lane)];
      EXPECT_EQ(packs[k].x.lane(lane), column[3 * rows[k]]);
      EXPECT_EQ(packs[k].z.lane(lane), column[3 * rows[k] + 2]);
    }
  }
  auto back = std::vector<std::vector<double>>(Pack8::lanes, std::vector<double>(30, -1));
  LaneRows<double> to;
  for (std::size_t lane = 0; lane < to.size(); ++lane) to[lane] = back[lane].data();
  scatter([&](std::size_t k) -> const Vec3<Pack8>& { return packs[k]; }, rows, to);
  for (std::size_t lane = 0; lane < back.size(); ++lane) {
    for (std::size_t n = 0; n < 30; ++n) {
      const bool named = std::ranges::find(rows, n / 3) != rows.end();
      EXPECT_EQ(back[lane][n], named ? columns[lane][n] : -1) << "rows that were not named are left alone";
    }
  }
}

TEST(Lanes, StructuresGoIntoOneLaneAndBack) {
  Wrench<Pack8> packs;
  for (int lane = 0; lane < Pack8::lanes; ++lane) {
    const double first = 10.0 * lane;
    set_lane(packs, lane, Wrenchd{{first, first + 1, first + 2}, {first + 3, first + 4, -0.0}});
  }
  for (int lane = 0; lane < Pack8::lanes; ++lane) {
    const Wrenchd one = lane_of(packs, lane);
    EXPECT_EQ(one.n.y, 10.0 * lane + 1);
    EXPECT_EQ(one.f.x, 10.0 * lane + 3);
    EXPECT_TRUE(std::signbit(one.f.z)) << "bits, not values";
  }
  Wrench<Pack8> other;
  assign_where(where(lane_bit(2)), packs, other);
  EXPECT_EQ(lane_of(other, 2).n.z, 22);
  EXPECT_EQ(lane_of(other, 3).n.z, 0);
}

}  // namespace
}  // namespace murosimf
