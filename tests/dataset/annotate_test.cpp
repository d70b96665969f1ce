#include "murosimf/dataset/annotate.h"

#include <algorithm>
#include <fstream>
#include <memory>

#include <gtest/gtest.h>

#include "murosimf/dataset/frame_record.h"
#include "murosimf/dataset/summary.h"
#include "tests/temp_folder.h"

namespace murosimf::dataset {
namespace {

constexpr int width = 64, height = 48;
constexpr double focal_length = 50;  // [px]
constexpr std::uint64_t least_pixels = 2;

/// 2 m before the origin and 0.5 m above the ground, along x.
Viewpoint level_camera() {
  const imaging::LensSpec lens{
      .width = width, .height = height, .fx = focal_length, .fy = focal_length, .cx = 31.5, .cy = 23.5};
  return {imaging::Lens(lens), {-2, 0, 0.5}, {{0, -1, 0}, {0, 0, -1}, {1, 0, 0}}};
}

/// A ball 2 m in front of the camera and 0.2 m below its axis: its middle is seen at (31.5, 28.5), and 4 x 4 pixels show it.
class AnnotatedBall : public testing::Test {
 protected:
  AnnotatedBall() {
    const auto file = folder_.path() / "scene.toml";
    std::ofstream(file) << "[ball]\nradius = 0.1\n";
    Randomisation ranges;
    ranges.robots.recorded = 0;
    stage_ = std::make_unique<Stage>(file, scene::SceneOptions{}, ranges);
    arrangement_.frame = stage_->at_start();
    put_ball({0, 0, 0.3});
    view_.labels = imaging::LabelImage(width, height, sensors::label_ground);
    view_.depth = imaging::DepthImage(width, height, 3);
    for (int v = 27; v < 31; ++v) {
      for (int u = 30; u < 34; ++u) show(u, v, ball().label, 1.9F);
    }
  }
  [[nodiscard]] const Actor& ball() const { return stage_->actors()[0]; }
  void put_ball(const Vec3d& at) { arrangement_.frame.position[arrangement_.frame.first[ball().place]] = at; }
  void show(int u, int v, std::uint16_t label, float depth) {
    view_.labels(u, v) = label;
    view_.depth(u, v) = depth;
  }
  [[nodiscard]] Annotated annotated() const {
    render::RenderScene drawn(stage_->world(), stage_->scene().moving_entities());
    const render::ShownMoment moment{.frame = &arrangement_.frame, .standing_feet = {}};
    drawn.locate();
    drawn.show(&moment);
    return annotate(*stage_, arrangement_, view_, level_camera(), drawn, least_pixels);
  }
  static const Annotation* find(const Annotated& in, std::uint16_t category) {
    const auto found = std::ranges::find(in.annotations, category, &Annotation::category);
    return found == in.annotations.end() ? nullptr : &*found;
  }

  fixtures::TempFolder folder_;
  std::unique_ptr<Stage> stage_;
  Arrangement arrangement_;
  sensors::View view_;
};

TEST_F(AnnotatedBall, HasBoxesAndAMask) {
  const Annotated all = annotated();
  const Annotation* one = find(all, class_ball);
  ASSERT_NE(one, nullptr);
  EXPECT_EQ(one->area, 16U);
  EXPECT_EQ(one->box.left, 30);
  EXPECT_EQ(one->box.right, 34);
  EXPECT_EQ(one->box.top, 27);
  EXPECT_EQ(one->box.bottom, 31);
  ASSERT_TRUE(one->full);
  EXPECT_NEAR(0.5 * (one->full->left + one->full->right), 32, 0.02);
  EXPECT_NEAR(one->full->right - one->full->left, 2 * focal_length * 0.1 / 2, 0.1);
  EXPECT_EQ(all.classes(30, 27), class_ball);
  EXPECT_EQ(all.classes(29, 27), class_ground);
  EXPECT_EQ(all.instances(33, 30), instance_first_actor);
  EXPECT_EQ(all.instances(34, 30), 0);
}

TEST_F(AnnotatedBall, ItsMiddleIsSeen) {
  const Annotated all = annotated();
  const Keypoint& middle = find(all, class_ball)->keypoints.at(0);
  EXPECT_EQ(middle.seen, Seen::seen);
  EXPECT_NEAR(middle.pixel.u, 31.5, 1e-9);
  EXPECT_NEAR(middle.pixel.v, 28.5, 1e-9);
}

TEST_F(AnnotatedBall, ItsMiddleIsHiddenBehindSomething) {
  for (int v = 28; v < 30; ++v) {
    for (int u = 31; u < 33; ++u) show(u, v, sensors::label_goal, 1);
  }
  const Annotated all = annotated();
  EXPECT_EQ(find(all, class_ball)->keypoints.at(0).seen, Seen::hidden);
  EXPECT_EQ(find(all, class_ball)->area, 12U);
  EXPECT_EQ(all.classes(31, 28), class_thing);  // it is where no goal is
}

TEST_F(AnnotatedBall, ItsMiddleIsOutside) {
  put_ball({0, 3, 0.3});
  const Annotated all = annotated();
  EXPECT_EQ(find(all, class_ball)->keypoints.at(0).seen, Seen::not_at_all);
}

TEST_F(AnnotatedBall, TooFewPixelsAreNoAnnotation) {
  for (int v = 27; v < 31; ++v) {
    for (int u = 30; u < 34; ++u) show(u, v, sensors::label_ground, 3);
  }
  show(30, 27, ball().label, 1.9F);
  EXPECT_EQ(find(annotated(), class_ball), nullptr);
}

TEST_F(AnnotatedBall, YoloHasItAsSharesOfThePicture) {
  const std::vector<int> numbers = yolo_classes(stage_->categories());
  std::vector<Annotation> all = annotated().annotations;
  all.push_back({.category = class_person, .name = "camera's", .own = true});
  EXPECT_EQ(yolo_text(all, numbers, width, height), "0 0.500000 0.604167 0.062500 0.083333\n");
}

}  // namespace
}  // namespace murosimf::dataset
