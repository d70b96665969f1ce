// Where robots with a penalty wait.
#include "murosimf/league/side_line.h"

#include <gtest/gtest.h>

#include "tests/fixtures.h"

namespace murosimf::league {
namespace {

const scene_file::FieldSize& field = scene_file::kid_size_2008;  // 6 m x 4 m, penalty marks at 1.8 m

TEST(SideLine, IsOutsideOfTheOwnHalfAndFacesTheField) {
  const scene::Placement left = place_at_side_line(field, 1, 1, {}), right = place_at_side_line(field, -1, -1, {});
  EXPECT_LT(fixtures::difference(left.position, {-1.2, 2.35, 0}), 1e-12);
  EXPECT_NEAR(left.heading, -pi / 2, 1e-12);
  EXPECT_LT(fixtures::difference(right.position, {1.2, -2.35, 0}), 1e-12);
  EXPECT_NEAR(right.heading, pi / 2, 1e-12);
}

TEST(SideLine, HasRoomForAll) {
  std::vector<Vec3d> others;
  for (int i = 0; i < 5; ++i) others.push_back(place_at_side_line(field, 1, 1, others).position);
  const double expected[] = {-1.2, -0.6, -1.8, 0.0, -2.4};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(others[i].x, expected[i], 1e-12);
}

}  // namespace
}  // namespace murosimf::league
