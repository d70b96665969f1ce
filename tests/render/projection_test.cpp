/// projection_test - directions of parallel rays, and the scale of their pictures.
#include "murosimf/render/projection.h"

#include <cmath>

#include <gtest/gtest.h>

namespace murosimf::test {
namespace {

using render::axes_from;
using render::ParallelView;
using render::Projection;
using render::view_of;

TEST(ParallelAxes, SidesAreWhereTheyBelong) {
  const auto expect_axes = [](const Mat3d& axes, const Vec3d& right, const Vec3d& up) {
    EXPECT_LT(norm(axes.x - right), 1e-12);
    EXPECT_LT(norm(axes.y + up), 1e-12);
    EXPECT_LT(norm(cross(axes.x, axes.y) - axes.z), 1e-12);
  };
  expect_axes(axes_from(-pi / 2, 0), {1, 0, 0}, {0, 0, 1});       // from the right
  expect_axes(axes_from(0, 0), {0, 1, 0}, {0, 0, 1});             // from the front: left is on the right
  expect_axes(axes_from(-pi / 2, pi / 2), {1, 0, 0}, {0, 1, 0});  // from above
  const Mat3d oblique = axes_from(-pi / 3, pi / 6);
  EXPECT_NEAR(oblique.z.z, -0.5, 1e-12);
  EXPECT_NEAR(oblique.z.x, -std::cos(pi / 6) * 0.5, 1e-12);
  EXPECT_LT(norm(cross(oblique.x, oblique.y) - oblique.z), 1e-12);
}

TEST(ParallelView, HasAllPointsInItAndNoRoomToSpare) {
  const std::vector<Vec3d> points{{1, 2, 3}, {2, 2, 3.5}, {1.2, -4, 2.9}};
  for (const auto& [width, height] : {std::pair{400, 300}, std::pair{1000, 20}, std::pair{20, 1000}}) {
    const ParallelView view = view_of(points, axes_from(0.7, 0.4), width, height);
    double across = 0, down = 0;  // [1] of half of the picture
    for (const Vec3d& point : points) {
      const Vec3d p = transposed_times(view.axes, point - view.center);
      across = std::max(across, std::abs(p.x) / (0.5 * width * view.pixel));
      down = std::max(down, std::abs(p.y) / (0.5 * height * view.pixel));
    }
    EXPECT_NEAR(std::max(across, down), 0.88, 1e-9) << width << " x " << height;
  }
}

TEST(ParallelView, OfOnePointOrNoneCanBeDrawn) {
  EXPECT_GT(view_of({}, {}, 100, 100).pixel, 0);
  const std::vector<Vec3d> one{{1, 2, 3}};
  const ParallelView view = view_of(one, axes_from(1, 1), 100, 100);
  EXPECT_GT(view.pixel, 0);
  EXPECT_LT(norm(view.center - one[0]), 1e-12);
}

TEST(Projection, CountsThePictureOfParallelRaysInMeters) {
  const Projection projection = ParallelView{.center = {1, 2, 3}, .pixel = 0.02, .width = 200, .height = 50};
  EXPECT_TRUE(projection.parallel);
  EXPECT_NEAR(projection.window.right, 2, 1e-12);
  EXPECT_NEAR(projection.window.left, -2, 1e-12);
  EXPECT_NEAR(projection.window.bottom, 0.5, 1e-12);
  EXPECT_NEAR(projection.window.top, -0.5, 1e-12);
  EXPECT_FALSE(Projection(sensors::Perspective{}).parallel);
}

}  // namespace
}  // namespace murosimf::test
