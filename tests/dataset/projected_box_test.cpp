#include "murosimf/dataset/projected_box.h"

#include <gtest/gtest.h>

namespace murosimf::dataset {
namespace {

constexpr double f = 500, c = 319.5;  // [px]

Viewpoint ahead() { return {imaging::Lens({.width = 640, .height = 640, .fx = f, .fy = f, .cx = c, .cy = c}), {}, {}}; }

PixelBox box_of(const render::Drawable& piece, const Vec3d& at) {
  const Viewpoint view = ahead();
  ProjectedBox projected(view);
  projected.add(piece, {at, {}}, {});
  return projected.box().value_or(PixelBox{});
}

render::Drawable piece(render::Form form, const Vec3d& scale) {
  render::Drawable one;
  one.form = form;
  one.scale = scale;
  return one;
}

// A sphere on the axis is seen under the angle asin(r / d).
TEST(ProjectedBox, OfABallIsItsConeOfRays) {
  const PixelBox box = box_of(piece(render::Form::sphere, {0.1, 0.1, 0.1}), {0, 0, 1});
  const double half = f * std::tan(std::asin(0.1));
  EXPECT_NEAR(box.right, c + 0.5 + half, 0.003 * half);
  EXPECT_NEAR(box.top, c + 0.5 - half, 0.003 * half);
}

TEST(ProjectedBox, OfABoxIsThatOfItsNearCorners) {
  const PixelBox box = box_of(piece(render::Form::box, {0.1, 0.2, 0.5}), {0, 0, 2});
  EXPECT_DOUBLE_EQ(box.left, c + 0.5 - f * 0.1 / 1.5);
  EXPECT_DOUBLE_EQ(box.bottom, c + 0.5 + f * 0.2 / 1.5);
}

TEST(ProjectedBox, ThereIsNoneOfWhatIsPartlyBehindTheCamera) {
  const Viewpoint view = ahead();
  ProjectedBox projected(view);
  projected.add(piece(render::Form::box, {0.1, 0.1, 3}), {{0, 0, 2}, {}}, {});
  EXPECT_FALSE(projected.box());
  EXPECT_FALSE(ProjectedBox(view).box());
}

}  // namespace
}  // namespace murosimf::dataset
