/// robot_picture_test - a robot from four sides, in the size of its shapes.
#include "murosimf/appearance/robot_picture.h"

#include <vector>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"

namespace murosimf::appearance {
namespace {

/// Columns or rows that are not empty, from the first on.
struct Range {
  int first = 0, count = 0;
};

class RobotPicture : public testing::Test {
 protected:
  /// A box of 0.2 x 0.4 x 1 m (forward, left, up), red, with a blue one on its left side.
  static robot_formats::RobotDescription block() {
    robot_formats::BodyDescription body;
    body.name = "trunk";
    const auto add = [&](const Vec3d& half_size, const Vec3d& position, const Color& color) {
      body.shapes.emplace_back();
      PlacedShape& placed = body.shapes.back().placed;
      placed.shape = Box{half_size};
      placed.position = position;
      placed.color = color;
    };
    add({0.1, 0.2, 0.5}, {}, {0.9, 0.1, 0.1});
    add({0.02, 0.05, 0.02}, {0, 0.25, 0.3}, {0.1, 0.1, 0.9});
    robot_formats::RobotDescription robot;
    robot.name = "block";
    robot.bodies.push_back(body);
    return robot;
  }
  void SetUp() override {
    try {
      picture_ = robot_picture(block(), 1600, 640);
    } catch (const SetupError& error) {
      GTEST_SKIP() << error.what();
    }
  }
  [[nodiscard]] bool is_empty(int u, int v) const { return picture_(u, v) == picture_(0, 0); }
  [[nodiscard]] bool is_empty_column(int u) const {
    for (int v = 0; v < picture_.height(); ++v) {
      if (!is_empty(u, v)) return false;
    }
    return true;
  }
  /// Columns of objects side by side.
  [[nodiscard]] std::vector<Range> views() const {
    std::vector<Range> found;
    bool inside = false;
    for (int u = 0; u < picture_.width(); ++u) {
      const bool empty = is_empty_column(u);
      if (!empty && !inside) found.push_back({u, 0});
      inside = !empty;
      if (inside) ++found.back().count;
    }
    return found;
  }
  [[nodiscard]] Range rows(const Range& columns) const {
    Range rows{-1, 0};
    for (int v = 0; v < picture_.height(); ++v) {
      for (int u = columns.first; u < columns.first + columns.count; ++u) {
        if (is_empty(u, v)) continue;
        if (rows.count == 0) rows.first = v;
        rows.count = v - rows.first + 1;
      }
    }
    return rows;
  }
  /// Mean column of blue pixels, as a share of the view; not a number if there are none.
  [[nodiscard]] double blue(const Range& columns) const {
    double sum = 0;
    int count = 0;
    for (int u = columns.first; u < columns.first + columns.count; ++u) {
      for (int v = 0; v < picture_.height(); ++v) {
        const imaging::Rgb& p = picture_(u, v);
        if (p.blue < 2 * p.red || p.blue < 2 * p.green) continue;
        sum += u - columns.first;
        ++count;
      }
    }
    return sum / count / columns.count;
  }

  imaging::ColorImage picture_;
};

TEST_F(RobotPicture, ShowsFourSidesToOneScale) {
  const std::vector<Range> sides = views();
  ASSERT_EQ(sides.size(), 4u);
  const Range &front = sides[0], &left = sides[1], &top = sides[2];
  const double scale = rows(front).count / 1.0;  // [px/m]
  EXPECT_NEAR(front.count / scale, 0.5, 0.01) << "breadth, with what is on the left";
  EXPECT_NEAR(left.count / scale, 0.2, 0.01) << "depth";
  EXPECT_NEAR(rows(left).count / scale, 1.0, 0.01);
  EXPECT_NEAR(top.count / scale, 0.5, 0.01);
  EXPECT_NEAR(rows(top).count / scale, 0.2, 0.01);
  EXPECT_GT(scale, 300) << "they fill the picture";
  EXPECT_GT(sides[3].first + sides[3].count, 800);
  // in the middle of the picture
  EXPECT_NEAR(sides[0].first, 1600 - sides[3].first - sides[3].count, 4);
  for (const Range& side : sides) EXPECT_NEAR(rows(side).first + 0.5 * rows(side).count, 320, 3);
}

TEST_F(RobotPicture, TheLeftIsOnTheRightOfWhoLooksFromTheFront) {
  const std::vector<Range> sides = views();
  ASSERT_EQ(sides.size(), 4u);
  EXPECT_GT(blue(sides[0]), 0.8) << "front";
  EXPECT_NEAR(blue(sides[1]), 0.5, 0.05) << "left side";
  EXPECT_LT(blue(sides[2]), 0.2) << "from above, forward is up";
}

TEST(RobotPictures, OfNothingAreEmpty) {
  robot_formats::RobotDescription nothing;
  nothing.bodies.emplace_back();
  try {
    const imaging::ColorImage picture = robot_picture(nothing, 64, 48);
    for (const imaging::Rgb& pixel : picture.pixels()) ASSERT_EQ(pixel, picture(0, 0));
  } catch (const SetupError& error) {
    GTEST_SKIP() << error.what();
  }
}

}  // namespace
}  // namespace murosimf::appearance
