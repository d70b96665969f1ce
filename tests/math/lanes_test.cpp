// Numbers of several things in the lanes of packs, and back.
#include "murosimf/math/lanes.h"

#include <algorithm>
#include <cmath>
#include <vector>

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

TEST(Lanes, EveryMaskIsToldFromTheOthers) {
  for (LaneMask mask = 0; mask < 0x100; ++mask) {
    Pack8 numbers = 1.0;
    for_lanes(mask, [&](int lane) { numbers.set_lane(lane, -1); });
    const Pack8::Mask negative = numbers < Pack8(0.0);
    EXPECT_EQ(lanes_of(negative), mask);
    EXPECT_EQ(any(negative), mask != 0) << mask;
    EXPECT_EQ(all(negative), mask == 0xff) << mask;
  }
}

/// Rows of one structure each, out of columns and back into others.
template <template <class> class T>
class Rows : public testing::Test {
 protected:
  static constexpr std::size_t numbers = numbers_of<T>, count = 10 * numbers;
  const std::vector<std::size_t> rows{0, 3, 4, 9};
  std::vector<std::vector<double>> columns = different_columns(count);
  std::vector<T<Pack8>> packs = std::vector<T<Pack8>>(rows.size());

  void gather_all() {
    LaneRows<const double> from;
    for (std::size_t lane = 0; lane < from.size(); ++lane) from[lane] = columns[lane].data();
    gather(from, rows, [&](std::size_t k) -> T<Pack8>& { return packs[k]; });
  }

  void expect_packs() const {
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const auto* pack = reinterpret_cast<const Pack8*>(&packs[k]);
      for (std::size_t n = 0; n < numbers; ++n) {
        for (int lane = 0; lane < Pack8::lanes; ++lane)
          EXPECT_EQ(pack[n].lane(lane), columns[static_cast<std::size_t>(lane)][numbers * rows[k] + n]);
      }
    }
  }

  void expect_scattered() const {
    auto back = std::vector<std::vector<double>>(Pack8::lanes, std::vector<double>(count, -1));
    LaneRows<double> to;
    for (std::size_t lane = 0; lane < to.size(); ++lane) to[lane] = back[lane].data();
    scatter([&](std::size_t k) -> const T<Pack8>& { return packs[k]; }, rows, to);
    for (std::size_t lane = 0; lane < back.size(); ++lane) {
      for (std::size_t n = 0; n < count; ++n) {
        const bool named = std::ranges::find(rows, n / numbers) != rows.end();
        EXPECT_EQ(back[lane][n], named ? columns[lane][n] : -1) << "rows that were not named are left alone";
      }
    }
  }

  void go_into_packs_and_back() {
    gather_all();
    expect_packs();
    expect_scattered();
  }
};

template <class S>
struct One {
  S number;
};

using RowsOfOne = Rows<One>;
using RowsOfThree = Rows<Vec3>;
using RowsOfSix = Rows<Twist>;
using RowsOfNine = Rows<Mat3>;
TEST_F(RowsOfOne, GoIntoPacksAndBack) { go_into_packs_and_back(); }
TEST_F(RowsOfThree, GoIntoPacksAndBack) { go_into_packs_and_back(); }
TEST_F(RowsOfSix, GoIntoPacksAndBack) { go_into_packs_and_back(); }
TEST_F(RowsOfNine, GoIntoPacksAndBack) { go_into_packs_and_back(); }

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
