#include "murosimf/dataset/field_points.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace murosimf::dataset {
namespace {

using scene_file::FieldSize;

std::vector<FieldPoint> points_of(const FieldSize& field) {
  return crossings_of(scene_file::field_markings(field), field);
}

int count(const std::vector<FieldPoint>& points, char kind) {
  return static_cast<int>(std::ranges::count(points, kind, &FieldPoint::kind));
}

const FieldPoint* at(const std::vector<FieldPoint>& points, const Vec3d& place) {
  const auto found = std::ranges::find_if(points, [&](const FieldPoint& p) { return norm(p.place - place) < 1e-6; });
  return found == points.end() ? nullptr : &*found;
}

// Without penalty areas: four corners and four of goal areas; half line and goal areas meet the outer lines; circle and marks.
TEST(FieldPoints, OfTheFieldOf2008) {
  const auto points = points_of(scene_file::kid_size_2008);
  EXPECT_EQ(count(points, 'L'), 8);
  EXPECT_EQ(count(points, 'T'), 6);
  EXPECT_EQ(count(points, 'X'), 5);
  ASSERT_NE(at(points, {2.975, 1.975, 0}), nullptr);
  EXPECT_EQ(at(points, {2.975, 1.975, 0})->kind, 'L');
  ASSERT_NE(at(points, {0, 0.6, 0}), nullptr);
  EXPECT_EQ(at(points, {0, 0.6, 0})->kind, 'X');
}

TEST(FieldPoints, PenaltyAreasAddFourCornersAndFourEnds) {
  const auto points = points_of(scene_file::kid_size_2023);
  EXPECT_EQ(count(points, 'L'), 12);
  EXPECT_EQ(count(points, 'T'), 10);
  EXPECT_EQ(count(points, 'X'), 5);
}

TEST(FieldPoints, GoalsAreNoLines) {
  const FieldSize& field = scene_file::kid_size_2023;
  EXPECT_EQ(crossings_of(scene_file::field_markings(field, false), field).size(), points_of(field).size());
}

TEST(FieldPoints, LeftOfAGoalIsLeftAsSeenFromTheField) {
  const GoalPoints right = goal_points(scene_file::kid_size_2008, 1), left = goal_points(scene_file::kid_size_2008, -1);
  EXPECT_GT(right.places[0].y, 0);  // looking along x, left is y > 0
  EXPECT_LT(left.places[0].y, 0);
  EXPECT_DOUBLE_EQ(right.places[2].z, 0.9);
}

}  // namespace
}  // namespace murosimf::dataset
