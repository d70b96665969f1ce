/// parallel_view_test - pictures by parallel rays: places, sizes, occlusion, ground and shadows.
#include <cmath>
#include <limits>

#include "tests/render/drawn.h"

namespace murosimf::test {
namespace {

using render::axes_from;
using sensors::View;

class ParallelPicture : public DrawnBy {};
INSTANTIATE_TEST_SUITE_P(Devices, ParallelPicture, all_devices, name_of_device);

constexpr std::uint16_t first = sensors::label_moving_entity, second = first + 1;

render::ParallelView looking(const Mat3d& axes, const Vec3d& center, double pixel = 0.01, int width = 200,
                             int height = 160) {
  return {.center = center, .axes = axes, .pixel = pixel, .width = width, .height = height};
}

/// Pixel of a point of the world [px].
std::pair<int, int> pixel_of(const render::ParallelView& view, const Vec3d& point) {
  const Vec3d p = transposed_times(view.axes, point - view.center);
  return {static_cast<int>(std::floor(0.5 * view.width + p.x / view.pixel)),
          static_cast<int>(std::floor(0.5 * view.height + p.y / view.pixel))};
}

ModelPtr box_model(const Vec3d& half_size) {
  const Shapes shapes{{.shape = Box{half_size}, .position = {}, .orientation = {}, .surface = {}, .color = {}}};
  return std::make_shared<const Model>("box", Chain{}.base("box").with(properties::shapes, shapes));
}

/// All pixels with their middles in the rectangle, no others.
void expect_rectangle(const View& drawn, std::uint16_t label, int left, int right, int top, int bottom) {
  int wrong = 0;
  for (int v = 0; v < drawn.labels.height(); ++v) {
    for (int u = 0; u < drawn.labels.width(); ++u) {
      const bool inside = u >= left && u < right && v >= top && v < bottom;
      if ((drawn.labels(u, v) == label) != inside) ++wrong;
    }
  }
  EXPECT_EQ(wrong, 0) << "pixels of " << (right - left) * (bottom - top);
}

TEST_P(ParallelPicture, ABoxCoversThePixelsOfItsSize) {
  DrawnWorld world(GetParam());
  const Vec3d place{1, -0.5, 1.6};
  world.add("box", box_model({0.3, 0.2, 0.1}), place);
  // 0.25 m to the right and 0.15 m above the middle of a picture of 200 x 160 px of 10 mm
  const auto draw = [&](double azimuth, double elevation) {
    const Mat3d axes = axes_from(azimuth, elevation);
    return world.draw(looking(axes, place - 0.25 * axes.x + 0.15 * axes.y));
  };
  expect_rectangle(draw(-pi / 2, 0), first, 125 - 30, 125 + 30, 65 - 10, 65 + 10);       // from the right: x and z
  expect_rectangle(draw(0, 0), first, 125 - 20, 125 + 20, 65 - 10, 65 + 10);             // from the front: y and z
  expect_rectangle(draw(-pi / 2, pi / 2), first, 125 - 30, 125 + 30, 65 - 20, 65 + 20);  // from above: x and y
}

TEST_P(ParallelPicture, WhatIsNearHidesWhatIsFar) {
  DrawnWorld world(GetParam());
  world.add("near", box_model({0.2, 0.1, 0.2}), {0, -3, 1});
  world.add("far", box_model({0.4, 0.1, 0.1}), {0, 5, 1});
  const View front = world.draw(looking(axes_from(-pi / 2, 0), {0, 0, 1}));
  expect_rectangle(front, first, 80, 120, 60, 100);
  EXPECT_EQ(front.labels(65, 80), second) << "beside it";
  EXPECT_EQ(front.labels(135, 80), second);
  const View back = world.draw(looking(axes_from(pi / 2, 0), {0, 0, 1}));
  expect_rectangle(back, second, 60, 140, 70, 90);
  EXPECT_EQ(back.labels(100, 65), first) << "above it";
}

TEST_P(ParallelPicture, SizesDoNotDependOnDistance) {
  const Mat3d axes = axes_from(-1.1, 0.4);
  const auto size = [&](double distance) {
    DrawnWorld world(GetParam());
    world.add_ball("ball", 0.3, Vec3d{2, 1, 60} + distance * axes.z);
    const View drawn = world.draw(looking(axes, {2, 1, 60}), {.labels = true});
    int count = 0;
    double u_sum = 0, v_sum = 0;
    for (int v = 0; v < 160; ++v) {
      for (int u = 0; u < 200; ++u) {
        if (drawn.labels(u, v) != first) continue;
        ++count;
        u_sum += u;
        v_sum += v;
      }
    }
    EXPECT_NEAR(u_sum / count, 99.5, 0.1) << distance;
    EXPECT_NEAR(v_sum / count, 79.5, 0.1) << distance;
    return count;
  };
  const int here = size(0);
  EXPECT_NEAR(here, pi * 30 * 30, 30) << "its area in pixels";
  // the rays of the processor meet 500 widths of the picture away
  const double meet = GetParam() == Device::opengl ? 1e300 : 500 * 200 * 0.01;
  for (const double distance : {-100.0, -1.0, 3.0, 100.0})
    EXPECT_NEAR(size(distance), here * std::pow(1 + distance / meet, -2), 15) << distance;
}

TEST_P(ParallelPicture, DepthsCountFromItsMiddle) {
  DrawnWorld world(GetParam());
  world.add_ball("ball", 0.3, {1, 2, 3});
  const Mat3d axes = axes_from(0.3, 0.8);
  const View drawn = world.draw(looking(axes, Vec3d{1, 2, 3} - 0.7 * axes.z));
  EXPECT_NEAR(drawn.depth(100, 80), 0.4, 1e-3);
}

TEST_P(ParallelPicture, ShowsTheFieldFromAnySideAbove) {
  DrawnWorld world(GetParam());
  world.add_field(false);
  for (const double azimuth : {-2.0, -1.0, 0.5, 2.5}) {
    for (const double elevation : {0.5, 0.8, pi / 2}) {
      const auto view = looking(axes_from(azimuth, elevation), {}, 0.005, 1600, 1200);
      const View drawn = world.draw(view);
      const auto label = [&](const Vec3d& p) {
        const auto [u, v] = pixel_of(view, p);
        return drawn.labels(u, v);
      };
      EXPECT_EQ(label({0, 1.2, 0}), sensors::label_line) << "half line";
      EXPECT_EQ(label({0.6, 0, 0}), sensors::label_line) << "center circle";
      EXPECT_EQ(label({0.08, 1.2, 0}), sensors::label_ground) << "beside it";
      const auto [u, v] = pixel_of(view, {1, 1, 0});
      EXPECT_GT(drawn.color(u, v).green, 1.3 * drawn.color(u, v).red) << "grass";
      const auto [s, t] = pixel_of(view, {0, 1.2, 0});
      EXPECT_GT(drawn.color(s, t).red, 200) << "paint";
    }
  }
}

TEST_P(ParallelPicture, ALineIsAsBrightAsItIsWide) {
  // a pixel that a line covers in part shows that part: the sum over a column is the line's width in pixels
  DrawnWorld world(GetParam());
  world.add_field(false);
  constexpr double elevation = 0.5, pixel = 0.02;
  const View drawn = world.draw(looking(axes_from(0, elevation), {}, pixel, 200, 160));
  const int u = 100 + static_cast<int>(1.2 / pixel);  // beside the center circle; the half line goes across the picture
  const double green = drawn.color(u, 90).red, white = 251;
  double sum = 0;
  for (int v = 70; v < 90; ++v) sum += (drawn.color(u, v).red - green) / (white - green);
  const double width = 0.05 * std::sin(elevation) / pixel;
  EXPECT_NEAR(sum, width, 0.15 * width);
}

TEST_P(ParallelPicture, BodiesThrowShadows) {
  const Vec3d at{1.0, 0.9, 0};
  const auto green = [&](bool shadows, const Mat3d& axes) {
    DrawnWorld world(GetParam());
    world.add_field(false);
    world.add_ball("ball", 0.2, at + Vec3d{-0.4, 0.4, 0.7});
    render::RendererOptions options{.light = {.toward = {-0.4, 0.4, 0.7}, .shadows = shadows}};
    const View drawn = world.draw(looking(axes, at, 0.01, 200, 200), {}, options);
    return static_cast<double>(drawn.color(100, 100).green);
  };
  for (const Mat3d& axes : {axes_from(-pi / 2, pi / 2), axes_from(0.4, 0.6)}) {
    EXPECT_LT(green(true, axes), 0.85 * green(false, axes));
  }
}

TEST_P(ParallelPicture, WhoLooksLevelSeesTheGroundCutOpen) {
  DrawnWorld world(GetParam());
  world.add_field(false);
  world.add("box", box_model({0.2, 0.2, 0.2}), {1.5, 0, 0.2});
  for (const double azimuth : {-pi / 2, 0.0, 2.2}) {
    const Mat3d axes = axes_from(azimuth, 0);
    const auto view = looking(axes, {0, 0, 0.25}, 0.01, 600, 160);
    const View drawn = world.draw(view);
    for (const int u : {0, 599}) {  // z = 0 is 25 px below the middle
      EXPECT_EQ(drawn.labels(u, 104), sensors::label_background);
      EXPECT_EQ(drawn.labels(u, 105), sensors::label_ground);
      EXPECT_EQ(drawn.labels(u, 159), sensors::label_ground);
    }
    const auto [u, v] = pixel_of(view, {1.5, 0, 0.2});
    EXPECT_EQ(drawn.labels(u, v), first);
  }
}

TEST_P(ParallelPicture, GroundIsLeftOutIfNobodyWantsIt) {
  DrawnWorld world(GetParam());
  world.add_ball("ball", 0.2, {0, 0, -0.5});
  const auto label = [&](const Mat3d& axes, bool ground, int u) {
    return world.draw(looking(axes, {0, 0, -0.5}), {.labels = true}, {.ground = ground}).labels(u, 80);
  };
  EXPECT_EQ(label(axes_from(0, 0.7), true, 100), sensors::label_ground) << "the ball is below it";
  EXPECT_EQ(label(axes_from(0, 0.7), false, 100), first);
  for (const double elevation : {0.0, 0.7})
    EXPECT_EQ(label(axes_from(0, elevation), false, 3), sensors::label_background);
}

TEST_P(ParallelPicture, LeavesOutWhatIsNowhere) {
  DrawnWorld world(GetParam());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  world.add_ball("lost", 0.2, {nan, 0, 0});
  world.add_ball("here", 0.2, {0, 0, 0.3});
  const View drawn = world.draw(looking(axes_from(-pi / 2, 1), {0, 0, 0.3}));
  EXPECT_EQ(drawn.labels(100, 80), second);
}

}  // namespace
}  // namespace murosimf::test
