#include <limits>

#include "murosimf/dataset/normals.h"

#include <gtest/gtest.h>

namespace murosimf::dataset {
namespace {

constexpr int side = 20;

/// Depths of the plane n . p = n . (0, 0, 1).
imaging::DepthImage plane(const imaging::Image<Vec3d>& rays, const Vec3d& n) {
  imaging::DepthImage depth(side, side);
  for (int v = 0; v < side; ++v) {
    for (int u = 0; u < side; ++u) depth(u, v) = static_cast<float>(n.z / dot(n, rays(u, v)));
  }
  return depth;
}

TEST(Normals, OfAPlaneAreItsOwnTowardTheCamera) {
  const imaging::Lens lens({.width = side, .height = side, .fx = 30, .fy = 30, .cx = 9.5, .cy = 9.5});
  const auto rays = rays_of(lens);
  const Vec3d n{0.36, -0.48, -0.8};
  const imaging::ColorImage normals = normals_of(plane(rays, n), imaging::LabelImage(side, side, 1), rays);
  for (const imaging::Rgb& one : normals.pixels()) {
    EXPECT_NEAR(one.red, 127.5 * (n.x + 1), 1);
    EXPECT_NEAR(one.green, 127.5 * (n.y + 1), 1);
    EXPECT_NEAR(one.blue, 127.5 * (n.z + 1), 1);
  }
}

TEST(Normals, NothingIsBlack) {
  const imaging::Lens lens({.width = side, .height = side, .fx = 30, .fy = 30, .cx = 9.5, .cy = 9.5});
  const imaging::DepthImage nothing(side, side, std::numeric_limits<float>::infinity());
  const auto normals = normals_of(nothing, imaging::LabelImage(side, side), rays_of(lens));
  EXPECT_EQ(normals(3, 3), imaging::Rgb{});
}

}  // namespace
}  // namespace murosimf::dataset
