#include "murosimf/scene_file/field.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::scene_file {
namespace {

// sums of a few short decimal fractions
constexpr double tolerance = 1e-12;

bool is_closed(const Stroke& stroke) {
  const Vec3d gap = stroke.points.back() - stroke.points.front();
  return norm(gap) == 0;
}

double reach_x(const Stroke& stroke) {
  double reach = 0;
  for (const Vec3d& p : stroke.points) reach = std::max(reach, std::abs(p.x));
  return reach;
}

bool has_stroke(const Markings& markings, const std::vector<Vec3d>& points) {
  return std::any_of(markings.strokes.begin(), markings.strokes.end(), [&](const Stroke& stroke) {
    return std::equal(stroke.points.begin(), stroke.points.end(), points.begin(), points.end(),
                      [](const Vec3d& a, const Vec3d& b) { return norm(a - b) < tolerance; });
  });
}

class EveryField : public testing::TestWithParam<std::string_view> {
 protected:
  const FieldSize& size = field_size(GetParam());
  const Markings markings = field_markings(size);
};

TEST_P(EveryField, OuterLineReachesLengthAndWidthWithItsOuterEdge) {
  const Stroke& line = markings.strokes.front();
  ASSERT_TRUE(is_closed(line));
  ASSERT_EQ(line.points.size(), 5u);
  for (const Vec3d& corner : line.points) {
    EXPECT_NEAR(std::abs(corner.x) + line.width / 2, size.length / 2, tolerance);
    EXPECT_NEAR(std::abs(corner.y) + line.width / 2, size.width / 2, tolerance);
  }
}

TEST_P(EveryField, CenterCircleHasItsRadius) {
  const auto circle = std::find_if(markings.strokes.begin() + 1, markings.strokes.end(), is_closed);
  ASSERT_NE(circle, markings.strokes.end());
  const double radius = size.center_circle_diameter / 2;
  for (std::size_t i = 0; i + 1 < circle->points.size(); ++i) {
    EXPECT_NEAR(norm(circle->points[i]), radius, tolerance);
    // the polygon looks round: its sides leave the circle by less than 1 mm
    EXPECT_NEAR(norm(0.5 * (circle->points[i] + circle->points[i + 1])), radius, 1e-3);
  }
}

TEST_P(EveryField, AreasAndMarksStandWhereTheRulesSay) {
  const double w = size.line_width / 2;
  const double front = size.length / 2 - size.goal_area_depth + w, y = size.goal_area_width / 2 - w;
  const double line = size.length / 2 - w;
  EXPECT_TRUE(has_stroke(markings, {{line, y, 0}, {front, y, 0}, {front, -y, 0}, {line, -y, 0}}));
  const double mark = size.length / 2 - size.penalty_mark_distance, half = size.mark_size / 2;
  EXPECT_TRUE(has_stroke(markings, {{mark - half, 0, 0}, {mark + half, 0, 0}}));
  EXPECT_TRUE(has_stroke(markings, {{mark, -half, 0}, {mark, half, 0}}));
}

TEST_P(EveryField, TwoGoalsStandBehindTheGoalLines) {
  int goals = 0;
  for (const Stroke& stroke : markings.strokes) {
    if (reach_x(stroke) <= size.length / 2) continue;
    ++goals;
    ASSERT_EQ(stroke.points.size(), 4u);
    EXPECT_NEAR(std::abs(stroke.points.front().x), size.length / 2, tolerance);
    EXPECT_NEAR(reach_x(stroke) + stroke.width / 2, size.length / 2 + size.goal_depth, tolerance);
    EXPECT_NEAR(stroke.points.front().y - stroke.width / 2, size.goal_width / 2, tolerance);
  }
  EXPECT_EQ(goals, 2);
}

TEST_P(EveryField, BothHalvesAreMirrorImages) {
  const auto mirrored = [&](const Vec3d& p, double x_sign, double y_sign) {
    const Vec3d image{x_sign * p.x, y_sign * p.y, p.z};
    for (const Stroke& stroke : markings.strokes) {
      for (const Vec3d& q : stroke.points) {
        if (norm(q - image) < tolerance) return true;
      }
    }
    return false;
  };
  for (const Stroke& stroke : markings.strokes) {
    for (const Vec3d& p : stroke.points) {
      EXPECT_TRUE(mirrored(p, -1, 1)) << p.x << ' ' << p.y;
      EXPECT_TRUE(mirrored(p, 1, -1)) << p.x << ' ' << p.y;
    }
  }
}

TEST_P(EveryField, EverythingLiesOnTheGround) {
  EXPECT_NEAR(markings.half_length, size.length / 2 + size.border, tolerance);
  EXPECT_NEAR(markings.half_width, size.width / 2 + size.border, tolerance);
  for (const Stroke& stroke : markings.strokes) {
    EXPECT_LE(reach_x(stroke) + stroke.width / 2, markings.half_length);
    for (const Vec3d& p : stroke.points) EXPECT_EQ(p.z, 0);
  }
}

TEST_P(EveryField, BaseIsOnePlaneWithMarkings) {
  const ModelPtr model = field_model(size, "carpet", {0, 1, 0});
  EXPECT_EQ(model->name(), size.name);
  const int field = model->object_index("field");
  EXPECT_EQ(field, 0);
  const Shapes* shapes = model->find(properties::shapes, field);
  ASSERT_TRUE(shapes && shapes->size() == 1);
  EXPECT_TRUE(std::holds_alternative<Plane>(shapes->front().shape));
  EXPECT_EQ(shapes->front().surface.material, "carpet");
  EXPECT_EQ(shapes->front().surface.friction_direction.y, 1);
  const Markings* painted = model->find(properties::markings, field);
  ASSERT_TRUE(painted);
  EXPECT_EQ(painted->strokes.size(), markings.strokes.size());
}

/// A box of a goal in the field's frame, read from the model.
struct Block {
  std::string name;
  Vec3d low, high;  // [m] corners
};

std::vector<Block> goal_blocks(const Model& model) {
  std::vector<Block> blocks;
  for (const int i : model.bodies()) {
    if (i == 0) continue;
    const PlacedShape& placed = model.find(properties::shapes, i)->front();
    const Vec3d half = std::get<Box>(placed.shape).half_size;
    const Vec3d center = model.placement(i).offset + placed.position;
    blocks.push_back({model.objects()[i].name, center - half, center + half});
  }
  return blocks;
}

bool overlap(const Block& a, const Block& b) {
  const double clear = 1e-9;  // faces may touch
  return a.low.x < b.high.x - clear && b.low.x < a.high.x - clear && a.low.y < b.high.y - clear &&
         b.low.y < a.high.y - clear && a.low.z < b.high.z - clear && b.low.z < a.high.z - clear;
}

TEST_P(EveryField, HasThirteenBodiesOfOneShapeEach) {
  const ModelPtr model = field_model(size, "carpet");
  ASSERT_EQ(model->bodies().size(), 13u);
  for (const int i : model->bodies()) EXPECT_EQ(model->find(properties::shapes, i)->size(), 1u);
  EXPECT_EQ(model->tree().links.size(), 1u) << "everything is fixed to the base";
  const Shapes& bar = *model->find(properties::shapes, model->object_index("goal_left_crossbar"));
  EXPECT_EQ(bar.front().surface.material, "plastic");
}

TEST_P(EveryField, GoalBoxesTouchButDoNotOverlap) {
  const auto blocks = goal_blocks(*field_model(size, "carpet"));
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    EXPECT_GE(blocks[i].low.z, -tolerance) << blocks[i].name << " reaches under the ground";
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_FALSE(overlap(blocks[i], blocks[j])) << blocks[i].name << ' ' << blocks[j].name;
    }
  }
}

TEST_P(EveryField, PostsStandOnTheGoalLineOutsideTheGoalWidth) {
  const ModelPtr model = field_model(size, "carpet");
  for (const Block& post : goal_blocks(*model)) {
    if (post.name.find("post") == std::string::npos) continue;
    const double front = std::min(std::abs(post.low.x), std::abs(post.high.x));
    EXPECT_NEAR(front, size.length / 2, tolerance) << post.name;
    EXPECT_NEAR(std::min(std::abs(post.low.y), std::abs(post.high.y)), size.goal_width / 2, tolerance) << post.name;
    EXPECT_NEAR(post.low.z, 0, tolerance);
    EXPECT_NEAR(post.high.z, size.goal_height + size.post_width, tolerance);
    EXPECT_EQ(post.name.find("goal_right") == 0, post.low.x > 0);
    EXPECT_EQ(post.name.find("post_left") != std::string::npos, post.low.y > 0);
  }
}

TEST_P(EveryField, GoalMouthIsOpenAndTheRearBarStopsARollingBall) {
  const ModelPtr model = field_model(size, "carpet");
  const double inside = size.goal_depth - size.post_width;
  const double ball_radius = 0.065;
  EXPECT_GT(inside, 2 * ball_radius);
  for (const double side : {-1.0, 1.0}) {
    const double x = side * size.length / 2, y = size.goal_width / 2;
    const Block mouth{"mouth",
                      {std::min(x, x + side * inside), -y, 0},
                      {std::max(x, x + side * inside), y, size.goal_height}};
    const Block ball{"ball",
                     {x + side * size.goal_depth - ball_radius, -ball_radius, 0},
                     {x + side * size.goal_depth + ball_radius, ball_radius, 2 * ball_radius}};
    int stops = 0;
    for (const Block& block : goal_blocks(*model)) {
      EXPECT_FALSE(overlap(block, mouth)) << block.name;
      stops += overlap(block, ball) ? 1 : 0;
    }
    EXPECT_EQ(stops, 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Field, EveryField, testing::ValuesIn(field_names()),
                         [](const auto& field) { return std::string(field.param); });

TEST(Field, PenaltyAreaExistsOnlyWhereTheRulesHaveOne) {
  const auto areas = [](const FieldSize& size) { return field_markings(size).strokes.size(); };
  EXPECT_EQ(areas(kid_size_2023), areas(kid_size_2008) + 2);
  EXPECT_TRUE(has_stroke(field_markings(kid_size_2023),
                         {{-4.475, 2.475, 0}, {-2.525, 2.475, 0}, {-2.525, -2.475, 0}, {-4.475, -2.475, 0}}));
}

TEST(Field, UnknownNameSuggestsTheNearest) {
  try {
    (void)field_size("kid_size_2022");
    FAIL() << "an unknown field was accepted";
  } catch (const SetupError& error) {
    EXPECT_STREQ(error.what(), "unknown field 'kid_size_2022'; did you mean 'kid_size_2023'?");
  }
}

std::string colors_of(const Shapes& shapes) {
  std::string text;
  for (const PlacedShape& placed : shapes) {
    const Color& c = placed.color;
    text += c.red > 0.7 && c.blue > 0.7 ? 'w' : c.red > 2 * c.blue ? 'y' : 'b';
  }
  return text;
}

// Rule: of 2008 yellow at x > 0, blue at x < 0; of 2023 white.
TEST(FieldModel, GoalsHaveTheColorsOfTheirYear) {
  for (const auto& [size, right, left] : {std::tuple{&kid_size_2008, "y", "b"}, {&kid_size_2023, "w", "w"}}) {
    const ModelPtr model = field_model(*size, "carpet");
    for (const std::string part : {"crossbar", "post_left", "bar_rear"}) {
      EXPECT_EQ(colors_of(*model->find(properties::shapes, model->object_index("goal_right_" + part))), right) << part;
      EXPECT_EQ(colors_of(*model->find(properties::shapes, model->object_index("goal_left_" + part))), left) << part;
    }
  }
}

// Rule: 60 cm high, 20 cm thick, beside the half line; the outer parts have the color of the goal to the left of a viewer who looks from
// the pole onto the field: at y > 0 that of x > 0.
TEST(FieldModel, LandmarkPolesStandBesideTheHalfLine) {
  const ModelPtr model = field_model(kid_size_2008, "carpet", {}, {.goals = false, .poles = true});
  ASSERT_EQ(model->bodies().size(), 3u);
  for (const auto& [name, y, colors] : {std::tuple{"landmark_left", 2.4, "yby"}, {"landmark_right", -2.4, "byb"}}) {
    const int pole = model->object_index(name);
    const Shapes& parts = *model->find(properties::shapes, pole);
    EXPECT_EQ(colors_of(parts), colors);
    const Vec3d middle = model->placement(pole).offset;
    EXPECT_LT(norm(middle - Vec3d{0, y, 0.3}), tolerance);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(middle.z + parts[i].position.z, 0.1 + 0.2 * i, tolerance);
      EXPECT_NEAR(std::get<Cylinder>(parts[i].shape).radius, 0.1, tolerance);
      EXPECT_NEAR(std::get<Cylinder>(parts[i].shape).half_length, 0.1, tolerance);
    }
  }
}

// Rule: without goals nothing of them is painted; goal areas are lines and stay.
TEST(FieldMarkings, LeaveOutGoalsThatDoNotStand) {
  for (const FieldSize* size : {&kid_size_2008, &kid_size_2023}) {
    const Markings all = field_markings(*size), without = field_markings(*size, false);
    EXPECT_EQ(without.strokes.size(), all.strokes.size() - 2);
    for (const Stroke& stroke : without.strokes) EXPECT_LT(reach_x(stroke), size->length / 2);
    const double front = size->length / 2 - size->goal_area_depth + size->line_width / 2;
    EXPECT_EQ(std::ranges::count_if(without.strokes,
                                    [&](const Stroke& s) {
                                      return s.points.size() == 4 &&
                                             std::abs(std::abs(s.points[1].x) - front) < tolerance;
                                    }),
              2);
  }
}

TEST(FieldModel, StandsWithoutGoalsIfAsked) {
  const ModelPtr model = field_model(kid_size_2008, "carpet", {}, {.goals = false});
  EXPECT_EQ(model->bodies().size(), 1u);
}

}  // namespace
}  // namespace murosimf::scene_file
