// Needs MUROSIMF_HAS_CAIRO and cairo; without them there are no pictures to look at.
#include "murosimf/render/scene_view.h"

#include <gtest/gtest.h>

#ifdef MUROSIMF_HAS_CAIRO

#include <limits>

#include <unistd.h>

#include "murosimf/files/output_file.h"
#include "murosimf/model/error.h"
#include "murosimf/scene/field.h"
#include "tests/render/picture.h"
#include "tests/temp_folder.h"

namespace murosimf::render {
namespace {

constexpr Color red{0.85, 0.15, 0.15}, blue{0.15, 0.4, 0.85};

TEST(View, SidesAreWhereTheyBelong) {
  const auto expect_axes = [](const View& view, const Vec3d& right, const Vec3d& up) {
    EXPECT_LT(norm(view.right - right), 1e-12);
    EXPECT_LT(norm(view.up - up), 1e-12);
    EXPECT_LT(norm(cross(view.right, view.up) - view.toward), 1e-12);
  };
  expect_axes(view_from(-pi / 2, 0), {1, 0, 0}, {0, 0, 1});       // from the right
  expect_axes(view_from(0, 0), {0, 1, 0}, {0, 0, 1});             // from the front: left is on the right
  expect_axes(view_from(-pi / 2, pi / 2), {1, 0, 0}, {0, 1, 0});  // from above
  const View oblique = view_from(-pi / 3, pi / 6);
  EXPECT_NEAR(oblique.toward.z, 0.5, 1e-12);
  EXPECT_NEAR(oblique.toward.x, std::cos(pi / 6) * 0.5, 1e-12);
  EXPECT_LT(norm(cross(oblique.right, oblique.up) - oblique.toward), 1e-12);
}

TEST(View, MeasuresPixelsRightAndDownAndDepthTowardsTheEye) {
  View view = view_from(-pi / 2, 0);
  view.center = {1, 2, 3};
  view.scale = 10;
  view.columns = 200;
  view.rows = 100;
  const Vec3d p = view({1.5, 1, 4});
  EXPECT_NEAR(p.x, 105, 1e-9);
  EXPECT_NEAR(p.y, 40, 1e-9);
  EXPECT_NEAR(p.z, 1, 1e-9);
}

class SceneView : public testing::Test {
 protected:
  void SetUp() override {
    file_ = fixtures::temp_folder() / ("scene_view_test." + std::to_string(::getpid()) + ".png");
  }
  void TearDown() override { std::filesystem::remove(file_); }

  [[nodiscard]] Picture draw(const std::vector<ViewedShape>& shapes, const View& view,
                             const std::string& title = {}) const {
    files::write_file(file_, scene_view_png(markings_, shapes, view, title));
    return Picture(file_);
  }
  /// What is seen at a point of the world.
  [[nodiscard]] static Color at(const Picture& picture, const View& view, const Vec3d& p) {
    const Vec3d pixel = view(p);
    return picture.pixel(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
  }
  [[nodiscard]] std::string refusal(View view) const {
    try {
      (void)scene_view_png(markings_, {}, view);
    } catch (const SetupError& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path file_;
  Markings markings_ = scene::field_markings(scene::kid_size_2008);
};

TEST_F(SceneView, ShowsTheFieldFromAnySideAbove) {
  for (const double azimuth : {-2.0, -1.0, 0.5, 2.5}) {
    for (const double elevation : {0.5, 0.8, pi / 2}) {
      // lines are some pixels wide
      const View view = view_of(view_from(azimuth, elevation), markings_, 1600, 1200);
      const Picture picture = draw({}, view);
      EXPECT_TRUE(is_white(at(picture, view, {0, 1.2, 0}))) << "half line";
      EXPECT_TRUE(is_white(at(picture, view, {0.6, 0, 0}))) << "center circle";
      EXPECT_TRUE(is_white(at(picture, view, {-2.975, 1.6, 0}))) << "goal line";
      EXPECT_TRUE(is_green(at(picture, view, {1, 1, 0})));
      EXPECT_FALSE(is_green(picture.pixel(1, 1))) << "the ground has an end";
    }
  }
}

TEST_F(SceneView, NearBodiesHideFarOnes) {
  const View view = view_of(view_from(-pi / 2, 0.5), markings_, 640, 480);
  const Vec3d near{0, -0.5, 0.2}, far{0, 0.5, 0.2};
  const Vec3d behind = near - 1.5 * view.toward;
  const std::vector<ViewedShape> shapes{{Box{{0.3, 0.1, 0.2}}, near, {}, red},
                                        {Box{{0.1, 0.1, 0.2}}, behind, {}, blue},
                                        {Sphere{0.2}, far + Vec3d{1, 0, 0}, {}, blue}};
  const Picture picture = draw(shapes, view);
  EXPECT_TRUE(is_reddish(at(picture, view, near)));
  EXPECT_TRUE(is_reddish(at(picture, view, behind))) << "hidden";
  EXPECT_TRUE(is_bluish(at(picture, view, far + Vec3d{1, 0, 0})));
}

TEST_F(SceneView, SidesThatLookToTheLightAreBrighter) {
  const View view = view_of(view_from(-pi / 2, 0.5), markings_, 640, 480);
  const Picture picture = draw({{Box{{0.3, 0.3, 0.3}}, {0, 0, 0.3}, {}, red}}, view);
  EXPECT_GT(at(picture, view, {0, 0, 0.6}).red, 1.2 * at(picture, view, {0, -0.3, 0.3}).red);
}

TEST_F(SceneView, BodiesThrowShadows) {
  const View view = view_of(view_from(-pi / 2, pi / 2), markings_, 640, 480);
  const Color before = at(draw({}, view), view, {1.0, 0.9, 0});
  // the light comes from the left and from above the picture
  const Vec3d place = Vec3d{1.0, 0.9, 0} + Vec3d{-0.5, 0.55, 0.65};
  const Color after = at(draw({{Sphere{0.2}, place, {}, red}}, view), view, {1.0, 0.9, 0});
  EXPECT_LT(after.green, 0.8 * before.green);
}

TEST_F(SceneView, FromTheSideThereIsNoGround) {
  const ViewedShape sphere{Sphere{0.2}, {0, 0, 0.2}, {}, blue};
  const View view = view_of(view_from(-pi / 2, 0), {sphere}, 300, 300);
  const Picture picture = draw({sphere}, view, "side");
  EXPECT_TRUE(is_bluish(picture.pixel(150, 150)));
  EXPECT_FALSE(is_green(picture.pixel(10, 290)));
  EXPECT_TRUE(is_green(at(picture, view, {-0.22, 0, 0}))) << "but a line where it would be";
  // it fills the picture but for its margin
  EXPECT_TRUE(is_bluish(picture.pixel(30, 150)));
  EXPECT_FALSE(is_bluish(picture.pixel(10, 150)));
}

TEST_F(SceneView, LeavesOutWhatIsNowhere) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const View view = view_of(view_from(-pi / 2, 1), markings_, 320, 240);
  const Picture picture = draw({{Sphere{0.2}, {nan, 0, 0}, {}, red}, {Sphere{0.3}, {0, 0, 0.3}, {}, blue}}, view);
  EXPECT_TRUE(is_bluish(at(picture, view, {0, 0, 0.3})));
}

TEST_F(SceneView, RefusesImpossibleViews) {
  View view = view_of(view_from(0, 1), markings_, 320, 240);
  EXPECT_EQ(refusal(view), "");
  view.columns = 0;
  EXPECT_NE(refusal(view).find("cannot draw the picture"), std::string::npos);
  view.columns = 100000;
  EXPECT_NE(refusal(view).find("too many pixels"), std::string::npos);
  view.columns = 320;
  view.scale = 0;
  EXPECT_NE(refusal(view).find("nothing would be seen"), std::string::npos);
}

}  // namespace
}  // namespace murosimf::render

#endif
