#include "murosimf/viewer/orbit_camera.h"

#include <cmath>

#include <gtest/gtest.h>

namespace murosimf::viewer {
namespace {

// What is in the middle stays there while the eye turns about it and comes nearer.
TEST(OrbitCamera, TargetStaysInTheMiddle) {
  OrbitCamera camera{.target = {1, -2, 0.3}, .azimuth = 0.4, .elevation = 0.7, .distance = 3};
  camera.orbit(120, -45, 480);
  camera.zoom(3);
  const auto view = camera.view(640, 480);
  const auto pixel = pixel_of(view, camera.target);
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x, 320, 1e-9);
  EXPECT_NEAR(pixel->y, 240, 1e-9);
  EXPECT_NEAR(norm(view.eye - camera.target), 3 * std::pow(0.88, 3), 1e-12);
}

TEST(OrbitCamera, PixelsAndRaysAreInverse) {
  const auto view = OrbitCamera{.target = {0.5, 1, 0.2}, .azimuth = 2, .elevation = 0.3}.view(1000, 700);
  for (const Pixel pixel : {Pixel{0, 0}, Pixel{999, 3}, Pixel{400.5, 650}}) {
    const Ray ray = ray_of(view, pixel);
    EXPECT_NEAR(norm(ray.direction), 1, 1e-12);
    const auto back = pixel_of(view, ray.from + 2.5 * ray.direction);
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->x, pixel.x, 1e-8);
    EXPECT_NEAR(back->y, pixel.y, 1e-8);
  }
}

TEST(OrbitCamera, APixelOnAPlaneIsSeenThere) {
  const auto view = OrbitCamera{}.view(1280, 720);
  const auto place = on_plane(view, {800, 500}, {0, 0, 0.1}, {0, 0, 1});
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->z, 0.1, 1e-12);
  const auto pixel = pixel_of(view, *place);
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x, 800, 1e-8);
  EXPECT_NEAR(pixel->y, 500, 1e-8);
  EXPECT_FALSE(on_plane(view, {640, 1}, {0, 0, 50}, {0, 0, 1}).has_value() && view.axes.z.z < 0);
}

TEST(OrbitCamera, WhatIsBehindTheEyeHasNoPixel) {
  const auto view = look({0, 0, 1}, {1, 0, 1}, 1, 100, 100);
  EXPECT_FALSE(pixel_of(view, {-1, 0, 1}));
  EXPECT_TRUE(pixel_of(view, {1, 0, 1}));
}

// A drag moves what is in the middle along with the mouse.
TEST(OrbitCamera, PanMovesThePictureWithTheMouse) {
  OrbitCamera camera{.target = {0, 0, 0}, .elevation = 0.8, .distance = 4};
  const Vec3d before = camera.target;
  camera.pan(50, -30, 600);
  const auto pixel = pixel_of(camera.view(600, 600), before);
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x, 350, 1e-6);
  EXPECT_NEAR(pixel->y, 270, 1e-6);
}

TEST(OrbitCamera, TakesOverAView) {
  const auto view = look({3, -4, 2.5}, {0.2, 0.1, 0}, 0.9, 800, 600);
  OrbitCamera camera;
  camera.take_over(view);
  const auto mine = camera.view(800, 600);
  EXPECT_NEAR(norm(mine.eye - view.eye), 0, 1e-9);
  EXPECT_NEAR(norm(mine.axes.z - view.axes.z), 0, 1e-9);
  EXPECT_NEAR(mine.right, view.right, 1e-12);
  camera.take_over(look({0, 0, 9}, {0, 0, 0}, 0.9, 800, 600));  // straight down
  EXPECT_NEAR(camera.eye().z, 9, 1e-2);
}

}  // namespace
}  // namespace murosimf::viewer
