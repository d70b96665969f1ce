#include "murosimf/scene_file/field.h"

#include <array>
#include <cmath>
#include <memory>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::scene_file {
namespace {

constexpr std::array all_fields{&kid_size_2008, &kid_size_2023};
constexpr Color carpet_green{0.16, 0.47, 0.22};
constexpr Color net_white{0.95, 0.95, 0.95, 0.06};

// a polygon of 72 sides deviates from the circle of 1.5 m by less than 1 mm
constexpr int circle_sides = 72;

Stroke outer_lines(const FieldSize& size) {
  const double x = (size.length - size.line_width) / 2, y = (size.width - size.line_width) / 2;
  return {{{x, y, 0}, {-x, y, 0}, {-x, -y, 0}, {x, -y, 0}, {x, y, 0}}, size.line_width};
}

Stroke half_line(const FieldSize& size) {
  const double y = (size.width - size.line_width) / 2;
  return {{{0, y, 0}, {0, -y, 0}}, size.line_width};
}

/// A polygon with a closed end: the last corner is the first one.
Stroke center_circle(const FieldSize& size) {
  Stroke circle{{}, size.line_width};
  for (int i = 0; i <= circle_sides; ++i) {
    const double angle = 2 * pi * (i % circle_sides) / circle_sides;
    const double radius = size.center_circle_diameter / 2;
    circle.points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  return circle;
}

/// Goal or penalty area; `side` is 1 for the goal at x > 0, -1 for the other.
Stroke area(const FieldSize& size, double side, double depth, double width) {
  MUROSIMF_ASSERT(side == 1 || side == -1);
  const double line = side * (size.length - size.line_width) / 2;
  const double front = side * (size.length / 2 - depth + size.line_width / 2);
  const double y = (width - size.line_width) / 2;
  return {{{line, y, 0}, {front, y, 0}, {front, -y, 0}, {line, -y, 0}}, size.line_width};
}

Color goal_color(const FieldSize& size, double side) { return side > 0 ? size.goal_right : size.goal_left; }

/// Posts and the back of the goal on the ground; the front of the posts is flush with the goal line's outer edge.
Stroke goal(const FieldSize& size, double side) {
  MUROSIMF_ASSERT(side == 1 || side == -1);
  const double half_post = size.post_width / 2;
  const double line = side * size.length / 2;
  const double back = side * (size.length / 2 + size.goal_depth - half_post);
  const double y = size.goal_width / 2 + half_post;
  return {{{line, y, 0}, {back, y, 0}, {back, -y, 0}, {line, -y, 0}}, size.post_width, goal_color(size, side)};
}

Stroke bar(const FieldSize& size, double x, const Vec3d& direction) {
  const Vec3d middle{x, 0, 0};
  const Vec3d half = (size.mark_size / 2) * direction;
  return {{middle - half, middle + half}, size.line_width};
}

/// Fields of some years have no penalty area: a depth of 0 leaves it out.
void add_side(std::vector<Stroke>& strokes, const FieldSize& size, double side) {
  if (size.goal_area_depth > 0) strokes.push_back(area(size, side, size.goal_area_depth, size.goal_area_width));
  if (size.penalty_area_depth > 0) {
    strokes.push_back(area(size, side, size.penalty_area_depth, size.penalty_area_width));
  }
  const double mark = side * (size.length / 2 - size.penalty_mark_distance);
  strokes.push_back(bar(size, mark, {1, 0, 0}));
  strokes.push_back(bar(size, mark, {0, 1, 0}));
}

Chain goal_box(const GoalBox& part, std::string_view goal, const Color& color, const char* material = "plastic") {
  PlacedShape shape;
  shape.shape = part.box;
  shape.surface.material = material;
  shape.color = color;
  Chain chain;
  chain.translation(part.center, std::string(goal) + "_" + std::string(part.name));
  return chain.with(properties::shapes, {shape}).endpoint();
}

void add_goal(std::vector<Chain>& boxes, const FieldSize& size, double side, bool net) {
  const std::string_view name = side > 0 ? "goal_right" : "goal_left";
  for (const GoalBox& part : goal_boxes(size, side)) boxes.push_back(goal_box(part, name, goal_color(size, side)));
  if (!net) return;
  for (const GoalBox& part : net_boxes(size, side)) boxes.push_back(goal_box(part, name, net_white, "net"));
}

/// At y > 0 for `side` 1. An observer there facing the field sees the goal at `side` x > 0 to the left.
Chain landmark_pole(const FieldSize& size, double side) {
  const double y = size.width / 2 + size.pole_distance;
  const Color outer = goal_color(size, side), inner = goal_color(size, -side);
  Shapes parts;
  for (const int segment : {-1, 0, 1}) {
    PlacedShape part;
    part.shape = Cylinder{size.pole_diameter / 2, size.pole_segment / 2};
    part.position.z = segment * size.pole_segment;
    part.surface.material = "plastic";
    part.color = segment == 0 ? inner : outer;
    parts.push_back(part);
  }
  Chain chain;
  chain.translation({0, side * y, 1.5 * size.pole_segment}, side > 0 ? "landmark_left" : "landmark_right");
  return chain.with(properties::shapes, parts).endpoint();
}

}  // namespace

std::vector<std::string_view> field_names() {
  std::vector<std::string_view> names;
  for (const FieldSize* size : all_fields) names.push_back(size->name);
  return names;
}

const FieldSize& field_size(std::string_view name) {
  for (const FieldSize* size : all_fields) {
    if (size->name == name) return *size;
  }
  throw SetupError(unknown_name("field", name, field_names()));
}

Markings field_markings(const FieldSize& size, bool goals) {
  Markings markings;
  markings.half_length = size.length / 2 + size.border;
  markings.half_width = size.width / 2 + size.border;
  // the half line is one bar of the center mark
  markings.strokes = {outer_lines(size), half_line(size), center_circle(size), bar(size, 0, {1, 0, 0})};
  // the order of strokes is fixed: the first is the outer line (field.h)
  for (const double side : {1.0, -1.0}) {
    add_side(markings.strokes, size, side);
    if (goals) markings.strokes.push_back(goal(size, side));
  }
  return markings;
}

std::vector<GoalBox> goal_boxes(const FieldSize& size, double side) {
  MUROSIMF_ASSERT(side == 1 || side == -1);
  const double w = size.post_width / 2;
  const double front = size.length / 2 + w, rear = size.length / 2 + size.goal_depth - w;
  const double y = size.goal_width / 2 + w;
  const double post = (size.goal_height + size.post_width) / 2;        // half of its height
  const Box bar{{(size.goal_depth - size.post_width) / 2 - w, w, w}};  // between a post and the rear bar
  const double bar_x = side * (front + rear) / 2;
  return {{"post_left", {{w, w, post}}, {side * front, y, post}},
          {"post_right", {{w, w, post}}, {side * front, -y, post}},
          {"crossbar", {{w, size.goal_width / 2, w}}, {side * front, 0, size.goal_height + w}},
          {"bar_left", bar, {bar_x, y, w}},
          {"bar_right", bar, {bar_x, -y, w}},
          {"bar_rear", {{w, y + w, w}}, {side * rear, 0, w}}};
}

std::vector<GoalBox> net_boxes(const FieldSize& size, double side) {
  MUROSIMF_ASSERT(side == 1 || side == -1);
  const double t = net_thickness / 2, inwards = net_before_bars - t;
  const double front = size.length / 2 + size.post_width;
  const double rear = size.length / 2 + size.goal_depth - size.post_width - inwards;
  const double y = size.goal_width / 2 - inwards, top = size.goal_height + size.post_width / 2;
  const double x = side * (front + rear) / 2, half_depth = (rear - front) / 2 + t;
  return {{"net_left", {{half_depth, t, top / 2}}, {x, y, top / 2}},
          {"net_right", {{half_depth, t, top / 2}}, {x, -y, top / 2}},
          {"net_rear", {{t, y + t, top / 2}}, {side * rear, 0, top / 2}},
          {"net_top", {{half_depth, y + t, t}}, {x, 0, top}}};
}

ModelPtr field_model(const FieldSize& size, const std::string& ground_material, const Vec3d& friction_direction,
                     const FieldFurniture& furniture, const std::vector<Chain>& standing) {
  PlacedShape ground;
  ground.shape = Plane{};
  ground.surface.material = ground_material;
  ground.surface.friction_direction = friction_direction;
  ground.color = carpet_green;
  Chain chain;
  chain.base("field")
      .with(properties::shapes, {ground})
      .with(properties::markings, field_markings(size, furniture.goals));
  // goals in the order of the paper's list: left, then right
  std::vector<Chain> boxes = standing;
  if (furniture.goals) {
    for (const double side : {-1.0, 1.0}) add_goal(boxes, size, side, furniture.nets);
  }
  if (furniture.poles) {
    for (const double side : {1.0, -1.0}) boxes.push_back(landmark_pole(size, side));
  }
  chain.fork(boxes);
  return std::make_shared<const Model>(std::string(size.name), std::move(chain));
}

}  // namespace murosimf::scene_file
