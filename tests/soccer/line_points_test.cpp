// Points on lines, and where pixels are on the ground: closed forms, and pictures drawn by the definition.
#include "murosimf/soccer/line_points.h"

#include <gtest/gtest.h>

#include "murosimf/scene_file/field.h"
#include "murosimf/soccer/planar.h"
#include "tests/fixtures.h"
#include "tests/law.h"
#include "tests/soccer/vision_rig.h"

namespace murosimf::soccer {
namespace {

using test::looking_down;
using test::picture_of;
using test::plain_lens;

const Markings field = scene_file::field_markings(scene_file::kid_size_2008);

TEST(GroundProjection, IsTheClosedFormOfAPinhole) {
  const imaging::Lens lens = plain_lens();
  const double pitch = 0.3, height = 0.5;
  const auto middle = on_ground(lens, looking_down(height, pitch), {159.5, 119.5});
  ASSERT_TRUE(middle);
  EXPECT_NEAR(middle->x, height / std::tan(pitch), 1e-12);
  EXPECT_NEAR(middle->y, 0, 1e-12);
  const auto side = on_ground(lens, looking_down(height, pitch), {159.5 - 175, 119.5});  // 45 deg to the left
  ASSERT_TRUE(side);
  EXPECT_NEAR(side->y, height / std::sin(pitch), 1e-12);
}

TEST(GroundProjection, HasNoPlaceAboveTheHorizon) {
  const imaging::Lens lens = plain_lens();
  const double horizon = 119.5 - 175 * std::tan(0.3);
  EXPECT_TRUE(on_ground(lens, looking_down(0.5, 0.3), {159.5, horizon + 1}));
  EXPECT_FALSE(on_ground(lens, looking_down(0.5, 0.3), {159.5, horizon - 1}));
}

TEST(GroundProjection, GoesBackThroughADistortedLens) {
  const imaging::Lens lens({.model = "plumb_bob",
                            .width = 640,
                            .height = 480,
                            .fx = 349,
                            .fy = 349,
                            .cx = 320,
                            .cy = 240,
                            .coefficients = {-0.2, 0.03, 0.001, -0.001}});
  fixtures::Dice dice("ground");
  law::Worst error;
  for (int i = 0; i < 1000; ++i) {
    const CameraPose camera = looking_down(dice.uniform(0.3, 0.8), dice.uniform(0.1, 0.5));
    const Vec3d place{dice.uniform(0.6, 4), dice.uniform(-1, 1), 0};
    const auto pixel = in_picture(lens, camera, place);
    if (!pixel || pixel->v > 479 || pixel->u < 0 || pixel->u > 639) continue;
    const auto back = on_ground(lens, camera, *pixel);
    ASSERT_TRUE(back);
    error.see(norm(Vec3d(*back - place)));
  }
  law::expect_below({.law = "pixel of a place on the ground, and back: error of the place",
                     .level = "ground projection",
                     .source = "one is the inverse of the other"},
                    error, 1e-6, "m");
}

/// Distances of the points from the nearest line of the field, seen from `pose`.
law::Worst errors_of(const std::vector<LinePoint>& points, const Vec3d& pose) {
  law::Worst worst;
  for (const LinePoint& point : points) {
    const Vec3d place = from_frame(pose, point.place);
    worst.see(distance_to_lines(field, place.x, place.y), place.x, place.y);
  }
  return worst;
}

TEST(LinePoints, LieOnTheLines) {
  const imaging::Lens lens = plain_lens();
  const CameraPose camera = looking_down(0.45, 0.3);
  law::Worst worst;
  for (const Vec3d& pose : {Vec3d{-1.5, 0, 0}, Vec3d{0.5, -1, 2}, Vec3d{-2, 1, -0.7}, Vec3d{2, 0.5, 1.2}}) {
    std::vector<LinePoint> points;
    find_line_points(picture_of(field, lens, camera, pose), lens, camera, {.spacing = 5, .farthest = 1.5}, points);
    EXPECT_GT(points.size(), 5u) << pose.x;
    const law::Measured error = errors_of(points, pose);
    worst.see(error.value, pose.x, pose.y, error.where);
  }
  law::expect_below({.law = "points on lines up to 1.5 m away: distance from the line's middle",
                     .level = "line points, 320 x 240",
                     .source = "picture drawn by its definition; lines are 50 mm wide, pixels up to 10 mm"},
                    worst, 0.03, "m");
}

TEST(LinePoints, AreNoneOnPlainGroundAndInTheSky) {
  const imaging::Lens lens = plain_lens();
  std::vector<LinePoint> points(3);
  find_line_points(imaging::ColorImage(320, 240, test::grass), lens, looking_down(0.45, 0.3), {}, points);
  EXPECT_TRUE(points.empty());
  find_line_points(imaging::ColorImage(320, 240, test::white), lens, looking_down(0.45, 0.3), {}, points);
  EXPECT_TRUE(points.empty());
}

TEST(LinePoints, AreNoneOnWhatIsTooWide) {
  Markings wide = field;
  wide.strokes = {{{{-5, -5, 0}, {-5, 5, 0}}, 0.05}};
  const imaging::Lens lens = plain_lens();
  const CameraPose camera = looking_down(0.45, 0.3);
  imaging::ColorImage picture = picture_of(wide, lens, camera, {});
  for (int v = 150; v < 200; ++v) {  // a white box, 0.4 m and more
    for (int u = 100; u < 220; ++u) picture(u, v) = test::white;
  }
  std::vector<LinePoint> points;
  find_line_points(picture, lens, camera, {.spacing = 5}, points);
  EXPECT_TRUE(points.empty());
}

TEST(LinePoints, AreNotOnLinesOfAnotherColor) {
  const imaging::Lens lens = plain_lens();
  const CameraPose camera = looking_down(0.45, 0.3);
  imaging::ColorImage picture = picture_of(field, lens, camera, {-1.5, 0, 0});
  for (imaging::Rgb& pixel : picture.pixels()) {
    if (pixel == test::white) pixel = {230, 40, 40};
  }
  std::vector<LinePoint> points;
  find_line_points(picture, lens, camera, {.spacing = 5}, points);
  EXPECT_TRUE(points.empty());
}

}  // namespace
}  // namespace murosimf::soccer
