// Overlays in the pixels of a picture: marks where a pinhole sees them, labels that do not cover each other.
#include "murosimf/viewer/overlay_shapes.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "murosimf/viewer/orbit_camera.h"

namespace murosimf::viewer {
namespace {

using render::SeenShape;

constexpr int side = 400;  // [px]

/// Along y from y = -4, with x to the right and z up; the middle is at the origin.
sensors::Perspective from_front() { return look({0, -4, 0}, {0, 0, 0}, 1.0, side, side); }

std::vector<SeenShape> of_kind(const std::vector<SeenShape>& shapes, SeenShape::Kind kind) {
  std::vector<SeenShape> found;
  for (const SeenShape& shape : shapes) {
    if (shape.kind == kind) found.push_back(shape);
  }
  return found;
}

class OverlayShapes : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      (void)render::width_of_words("a", 10);
    } catch (const SetupError& error) {
      GTEST_SKIP() << error.what();
    }
  }
};

TEST_F(OverlayShapes, AnArrowHasAHeadAtItsEnd) {
  const Overlays overlays{.marks = {{.points = {{0, 0, 0}, {0, 0, 1}}, .color = {1, 0, 0}, .width = 2, .arrow = true}},
                          .labels = {}};
  const auto shapes = shapes_of(overlays, from_front(), {.width = 3});
  ASSERT_EQ(shapes.size(), 2U);
  EXPECT_EQ(shapes[0].kind, SeenShape::Kind::line);
  EXPECT_EQ(shapes[0].size, 6) << "2 times 3";
  EXPECT_EQ(shapes[1].kind, SeenShape::Kind::area);
  EXPECT_NEAR(shapes[1].points[0].x, 0.5 * side, 1e-9);
  EXPECT_NEAR(shapes[1].points[0].y, shapes[0].points[1].y, 1e-9) << "its tip";
  EXPECT_LT(shapes[0].points[1].y, shapes[0].points[0].y) << "up";
}

TEST_F(OverlayShapes, AFilledPolygonIsAnAreaWithItsBorder) {
  const Mark polygon{.points = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, .color = {0, 1, 0}, .closed = true, .filled = true};
  const auto shapes = shapes_of({.marks = {polygon}, .labels = {}}, from_front(), {});
  EXPECT_EQ(of_kind(shapes, SeenShape::Kind::area).size(), 1U);
  EXPECT_EQ(of_kind(shapes, SeenShape::Kind::line).size(), 3U);
}

bool cover_each_other(const SeenShape& a, const SeenShape& b) {
  const auto half = [](const SeenShape& one) {
    return 0.5 * render::width_of_words(one.words, one.size) + 0.25 * one.size;
  };
  return std::abs(a.points[0].x - b.points[0].x) < half(a) + half(b) &&
         std::abs(a.points[0].y - b.points[0].y) < 0.7 * (a.size + b.size);
}

TEST_F(OverlayShapes, LabelsDoNotCoverEachOther) {
  Overlays overlays;
  for (int i = 0; i < 12; ++i) {
    overlays.labels.push_back({{0.05 * std::sin(i), 0.1 * i, 0.03 * std::cos(i)}, "robot" + std::to_string(i)});
  }
  const auto words = of_kind(shapes_of(overlays, from_front(), {.letters = 14, .top = 30}), SeenShape::Kind::words);
  ASSERT_EQ(words.size(), overlays.labels.size());
  EXPECT_EQ(words[0].words, "robot0") << "the nearest one";
  EXPECT_NEAR(words[0].points[0].y, pixel_of(from_front(), overlays.labels[0].place)->y, 1e-9) << "keeps its place";
  for (std::size_t i = 0; i < words.size(); ++i) {
    EXPECT_GT(words[i].points[0].y - 0.7 * words[i].size, 30) << "the upper edge is free";
    for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(cover_each_other(words[i], words[k])) << i << " and " << k;
  }
}

TEST_F(OverlayShapes, LabelsForWhichThereIsNoRoomAreLeftOut) {
  Overlays overlays;
  for (int i = 0; i < 100; ++i) overlays.labels.push_back({{0, 0.01 * i, 0}, "robot" + std::to_string(i)});
  const auto words = of_kind(shapes_of(overlays, from_front(), {.letters = 20}), SeenShape::Kind::words);
  EXPECT_GT(words.size(), 8U);
  EXPECT_LT(words.size(), 14U) << "of 30 pixels each";
}

TEST_F(OverlayShapes, LabelsOfWhatIsOutsideAreLeftOut) {
  const Overlays overlays{.marks = {},
                          .labels = {{{50, 0, 0}, "far right"}, {{0, -8, 0}, "behind"}, {{1.9, 0, 0}, "at the edge"}}};
  const auto words = of_kind(shapes_of(overlays, from_front(), {}), SeenShape::Kind::words);
  ASSERT_EQ(words.size(), 1U);
  EXPECT_EQ(words[0].words, "at the edge");
  EXPECT_LT(words[0].points[0].x + 0.5 * render::width_of_words(words[0].words, words[0].size), side);
}

}  // namespace
}  // namespace murosimf::viewer
