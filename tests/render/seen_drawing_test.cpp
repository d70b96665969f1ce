// Drawings for observers in a picture: at the places where a pinhole camera sees them, and in pixels.
#include "murosimf/render/seen_drawing.h"

#include <cmath>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"

namespace murosimf::render {
namespace {

/// At the origin, along x of the world; y of the world is to the left, z up. 100 px to the tangent 1.
sensors::Perspective eye() {
  sensors::Perspective view;
  view.axes = {{0, -1, 0}, {0, 0, -1}, {1, 0, 0}};
  view.width = view.height = 200;
  return view;
}

std::vector<SeenShape> seen(const DrawnShape& shape, const Transformd& frame = {}) {
  std::vector<SeenShape> shapes;
  see(shape, frame, eye(), shapes);
  return shapes;
}

// A place 2 m ahead, 1 m to the left and 0.5 m up is seen at 100 - 100 / 2, 100 - 50 / 2.
TEST(SeenDrawing, IsWhereAPinholeSeesIt) {
  const auto shapes = seen({.kind = DrawnShape::text, .points = {{2, 1, 0.5}}, .size = 0.4, .words = "a"});
  ASSERT_EQ(shapes.size(), 1U);
  EXPECT_EQ(shapes[0].kind, SeenShape::Kind::words);
  EXPECT_NEAR(shapes[0].points[0].x, 50, 1e-9);
  EXPECT_NEAR(shapes[0].points[0].y, 75, 1e-9);
  EXPECT_NEAR(shapes[0].size, 20, 1e-9) << "0.4 m at 2 m";
}

TEST(SeenDrawing, StandsInTheFrameOfItsRobot) {
  const Transformd robot{{3, 0, 0}, {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}};  // looks along y
  const auto shapes = seen({.kind = DrawnShape::line, .points = {{0, 0, 0}, {1.5, 0, 0}}, .size = 0.3}, robot);
  ASSERT_EQ(shapes.size(), 1U);
  EXPECT_NEAR(shapes[0].points[0].x, 100, 1e-9);
  EXPECT_NEAR(shapes[0].points[1].x, 50, 1e-9) << "1.5 m to the left, 3 m ahead";
  EXPECT_NEAR(shapes[0].size, 10, 1e-9);
}

TEST(SeenDrawing, WhatIsBehindTheEyeIsCutOff) {
  EXPECT_TRUE(seen({.kind = DrawnShape::dots, .points = {{-1, 0, 0}}}).empty());
  EXPECT_TRUE(seen({.kind = DrawnShape::sphere, .points = {{-1, 0, 0}}, .size = 0.5}).empty());
  EXPECT_TRUE(seen({.kind = DrawnShape::text, .points = {{-1, 0, 0}}, .words = "a"}).empty());
  EXPECT_TRUE(seen({.kind = DrawnShape::line, .points = {{-1, 0, 0}, {-2, 1, 0}}}).empty());
  EXPECT_TRUE(seen({.kind = DrawnShape::polygon, .points = {{-1, 0, 0}, {-2, 1, 0}, {-1, 1, 1}}}).empty());
  const auto line = seen({.kind = DrawnShape::line, .points = {{-1, 1, 0}, {1, 1, 0}}});
  ASSERT_EQ(line.size(), 1U);
  EXPECT_NEAR(line[0].points[0].x, 100 - 100 / 0.02, 1e-6) << "at 0.02 m in front of the eye";
  EXPECT_NEAR(line[0].points[1].x, 0, 1e-9);
  const auto half = seen({.kind = DrawnShape::polygon, .points = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}});
  ASSERT_EQ(half.size(), 1U);
  EXPECT_EQ(half[0].points.size(), 4U);
  for (const Vec3d& p : half[0].points) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
}

TEST(SeenDrawing, CirclesAndSpheres) {
  const auto ring = seen({.kind = DrawnShape::circle, .points = {{2, 0, -1}}, .size = 0.5});
  ASSERT_GT(ring.size(), 20U);
  double left = 200, right = 0;
  for (const SeenShape& piece : ring) {
    EXPECT_EQ(piece.kind, SeenShape::Kind::line);
    for (const Vec3d& p : piece.points) {
      left = std::min(left, p.x);
      right = std::max(right, p.x);
    }
  }
  // tangents to a circle about (2, 0) of radius 0.5 from the origin: sin = 1/4
  const double tangent = std::tan(std::asin(0.25));
  EXPECT_NEAR(right - 100, 100 * tangent, 0.2);
  EXPECT_NEAR(100 - left, 100 * tangent, 0.2);
  const auto ball = seen({.kind = DrawnShape::sphere, .points = {{2, 0, 0}}, .size = 0.5, .opacity = 0.5});
  ASSERT_EQ(ball.size(), 2U) << "what it covers, and its edge";
  EXPECT_EQ(ball[0].kind, SeenShape::Kind::area);
  EXPECT_LT(ball[0].opacity, 0.5);
  EXPECT_NEAR(std::hypot(ball[0].points[3].x - 100, ball[0].points[3].y - 100), 25, 1e-9);
}

bool has_pictures() {
  imaging::ColorImage picture(8, 8);
  try {
    draw_over(picture, {{.points = {{0, 0, 0}, {8, 8, 0}}}});
    return true;
  } catch (const SetupError&) {
    return false;
  }
}

TEST(DrawOver, MixesWithThePictureByItsOpacity) {
  if (!has_pictures()) GTEST_SKIP() << "this build has no pictures";
  imaging::ColorImage picture(20, 10, {100, 100, 100});
  const imaging::ColorImage before = picture;
  draw_over(picture, {});
  EXPECT_TRUE(std::ranges::equal(picture.pixels(), before.pixels()));
  draw_over(picture, {{.kind = SeenShape::Kind::area,
                       .points = {{5, 2, 0}, {15, 2, 0}, {15, 8, 0}, {5, 8, 0}},
                       .color = {1, 0, 0},
                       .opacity = 0.5}});
  EXPECT_EQ(picture(2, 5), (imaging::Rgb{100, 100, 100}));
  EXPECT_NEAR(picture(10, 5).red, 177, 2);
  EXPECT_NEAR(picture(10, 5).green, 50, 2);
  draw_over(picture, {{.points = {{0, 5, 0}, {20, 5, 0}}, .size = 2, .color = {0, 0, 1}}});
  EXPECT_EQ(picture(10, 5), (imaging::Rgb{0, 0, 255}));
  EXPECT_NEAR(picture(10, 7).red, 177, 2);
  draw_over(picture, {{.kind = SeenShape::Kind::words, .points = {{10, 5, 0}}, .size = 8, .words = "W"}});
  EXPECT_FALSE(picture(10, 5) == (imaging::Rgb{0, 0, 255}));
}

}  // namespace
}  // namespace murosimf::render
