/// field.h - soccer fields of the RoboCup Humanoid League: sizes by name, and the model of a field.
///
/// A field lies in the plane z = 0 with its middle at the origin: x along the touch lines, y along the goal lines.
/// Lines belong to the areas that they bound, so lengths and widths reach to the outer edges of lines: a ball has
/// crossed the goal line when |x| > length / 2 + its radius.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "murosimf/model/model.h"
#include "murosimf/model/shape.h"

namespace murosimf::scene_file {

inline constexpr Color goal_white{0.93, 0.93, 0.9}, goal_yellow{0.93, 0.78, 0.08}, goal_blue{0.1, 0.25, 0.75};

/// Lengths in meters.
struct FieldSize {
  std::string_view name;
  double length = 0, width = 0;
  double goal_width = 0;   ///< between the posts
  double goal_height = 0;  ///< under the crossbar
  double goal_depth = 0;   ///< from the goal line to the back of the rear bar
  double goal_area_depth = 0, goal_area_width = 0;
  double penalty_area_depth = 0, penalty_area_width = 0;  ///< 0: the field has none
  double penalty_mark_distance = 0;                       ///< from the goal line
  double center_circle_diameter = 0;                      ///< to the middle of its line
  double border = 0;                                      ///< ground around the field
  double line_width = 0.05;
  double post_width = 0.1;
  double mark_size = 0.2;  ///< length of the bars of the penalty and center marks; not given by the rules
  Color goal_right = goal_white, goal_left = goal_white;  ///< of the goals at x > 0 and x < 0
  double pole_diameter = 0;  ///< of the two landmark poles beside the half line; 0: there are none
  double pole_segment = 0;   ///< height of each of the three parts of a pole
  double pole_distance = 0;  ///< from the touch line to the middle of a pole
  bool nets = false;         ///< whether its goals have nets by default
};

/// The field of the paper's time. Its goals are bars without nets, as in the paper, which counts 13 objects (7.5).
/// Source: RoboCup Soccer Humanoid League, Rules and Setup for 2008, table 1, from memory: no copy was at hand. Length,
///         width and goal width are sure. Goal depth, depth of the goal area and border agree with a team's file for
///         the 6 m x 4 m field of 2009. Width of the goal area, penalty mark and center circle are unchecked.
///         Goals, one yellow and one blue, with a crossbar at 0.9 m, and landmark poles of 20 cm with three parts of 20 cm, of
///         which the lowest and the highest have the color of the goal to the left, are those of the rules of 2009, as described in
///         the paper IEEE 5420187 (whether the edition of 2008 had other heights is not known). That paper puts poles at the
///         ends of the half line; 0.4 m outside of the touch line, with yellow at x > 0 and the yellow-blue-yellow pole at y >
///         0, follow a team's files of later years (world.landmarkYellow = {0, 2.4}): to the left of an observer facing the
///         field.
inline constexpr FieldSize kid_size_2008{.name = "kid_size_2008",
                                         .length = 6,
                                         .width = 4,
                                         .goal_width = 1.5,
                                         .goal_height = 0.9,
                                         .goal_depth = 0.5,
                                         .goal_area_depth = 0.6,
                                         .goal_area_width = 2.2,
                                         .penalty_mark_distance = 1.8,
                                         .center_circle_diameter = 1.2,
                                         .border = 0.7,
                                         .goal_right = goal_yellow,
                                         .goal_left = goal_blue,
                                         .pole_diameter = 0.2,
                                         .pole_segment = 0.2,
                                         .pole_distance = 0.4};

/// Source: RoboCup Humanoid League, Laws of the Game, law 1, table 1, column KidSize. The edition of 2023 was
///         not at hand; those of 2021 (as in RobocupSoccerField.proto of Webots) and of 2025 (as quoted by users)
///         give the same numbers. A penalty mark at 2.1 m is that of AdultSize. The height of the goal is that of
///         RobocupGoal.proto (KidSize; AdultSize has 1.8 m).
inline constexpr FieldSize kid_size_2023{.name = "kid_size_2023",
                                         .length = 9,
                                         .width = 6,
                                         .goal_width = 2.6,
                                         .goal_height = 1.2,
                                         .goal_depth = 0.6,
                                         .goal_area_depth = 1,
                                         .goal_area_width = 3,
                                         .penalty_area_depth = 2,
                                         .penalty_area_width = 5,
                                         .penalty_mark_distance = 1.5,
                                         .center_circle_diameter = 1.5,
                                         .border = 1,
                                         .nets = true};

/// Names that field_size() accepts.
[[nodiscard]] std::vector<std::string_view> field_names();

/// Throws SetupError with the nearest name.
[[nodiscard]] const FieldSize& field_size(std::string_view name);

/// Paint on the field. A closed stroke repeats its first point; the first stroke is the outer line. Goals
/// are the two strokes that reach beyond it; their posts stand on the goal line, outside `goal_width`. Without `goals` these two
/// are missing; goal areas are lines of the field, and stay.
[[nodiscard]] Markings field_markings(const FieldSize& size, bool goals = true);

/// Boxes of a goal, for `side` 1 (the goal at x > 0) or -1: two posts, crossbar, two bars from the posts backwards and
/// the rear bar, on the ground; all of post_width. Field frame. Without nets a ball that flies over the bars is not stopped.
/// Posts and bars of wood or plastic tube are square here: rules allow 8 to 12 cm of any section.
struct GoalBox {
  std::string_view name;
  Box box;
  Vec3d center;  ///< [m]
};
[[nodiscard]] std::vector<GoalBox> goal_boxes(const FieldSize& size, double side);

/// The net of that goal, as four walls of net_thickness (left, right, rear, top) behind the posts and the crossbar, inside of the
/// bars: a ball hits it before them, and does not bounce off its material, "net". The compliance of a real net is neglected: only
/// the place where the ball comes to rest would show it.
inline constexpr double net_thickness = 0.02;     ///< [m] thick enough that falling robots do not pass it in a step
inline constexpr double net_before_bars = 0.005;  ///< [m]
[[nodiscard]] std::vector<GoalBox> net_boxes(const FieldSize& size, double side);

/// Objects that stand on a field, besides bodies of the scene.
struct FieldFurniture {
  bool goals = true;
  bool nets = false;   ///< of the goals, if these exist: "goal_left_net_rear"
  bool poles = false;  ///< "landmark_left" at y > 0, "landmark_right" at y < 0: three cylinders each
};

/// A model named after the field. Its base, "field", is a plane of `ground_material` with the markings; `friction_direction`:
/// direction in which the pile of the ground leans (model/shape.h), in the field's axes. Each box of a goal is an object of its own, of
/// plastic, with its frame in its middle: "goal_right_crossbar" belongs to the goal at x > 0, "goal_left_post_left" is
/// the post at y > 0 of the goal at x < 0. `standing`: further objects that stand on the field. Ground and
/// goals are the 13 objects of the field in the paper (7.5).
[[nodiscard]] ModelPtr field_model(const FieldSize& size, const std::string& ground_material,
                                   const Vec3d& friction_direction = {}, const FieldFurniture& furniture = {},
                                   const std::vector<Chain>& standing = {});

}  // namespace murosimf::scene_file
