#include "murosimf/robot/robot_soles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "murosimf/geometry/support.h"
#include "murosimf/math/assert.h"

namespace murosimf::robot {
namespace {

constexpr double thickness = 0.005;  // [m] parts up to here above the lowest point belong to the sole
constexpr double least_half = 0.01;  // [m] half width of a sole, also under a ball
constexpr double slope = 0.05;       // [1] points of a flat bottom are the farthest even in tilted directions
constexpr int directions = 16;       // around

/// Farthest points of a shape downwards and nearly so; `at`: of the shape, in a frame with -z down.
void add_low_points(const Shape& shape, const Transformd& at, std::vector<Vec3d>& points) {
  const auto add = [&](const Vec3d& down) {
    const Vec3d local = transposed_times(at.orientation, down);
    points.push_back(at.position + at.orientation * geometry::support(shape, local));
  };
  add({0, 0, -1});
  for (int i = 0; i < directions; ++i) {
    // between the axes as well, so that the corners of a box are found
    const double angle = (i + 0.5) * 2 * pi / directions;
    add({slope * std::cos(angle), slope * std::sin(angle), -1});
  }
}

/// The one of `candidates`, with either sign, that is nearest to `direction`; it is removed.
Vec3d take_nearest(std::vector<Vec3d>& candidates, const Vec3d& direction) {
  MUROSIMF_ASSERT(!candidates.empty());
  const auto nearest =
      std::ranges::max_element(candidates, {}, [&](const Vec3d& axis) { return std::abs(dot(axis, direction)); });
  const Vec3d axis = *nearest;
  candidates.erase(nearest);
  return dot(axis, direction) < 0 ? -axis : axis;
}

/// Points of bodies behind a foot that end as low, in the axes of the sole from the origin of the foot.
std::vector<Vec3d> points_of_toes(const robot_formats::RobotDescription& description, std::size_t foot, double bottom,
                                  const Mat3d& sole_axes) {
  std::vector<Vec3d> points;
  MUROSIMF_ASSERT(foot < description.bodies.size());
  std::vector<std::optional<Transformd>> places(description.bodies.size());  // in those axes; none: not behind the foot
  places[foot] = Transformd{{}, transpose(sole_axes)};
  for (std::size_t i = foot + 1; i < places.size(); ++i) {
    const robot_formats::BodyDescription& body = description.bodies[i];
    if (body.parent < 0 || !places[static_cast<std::size_t>(body.parent)]) continue;
    MUROSIMF_ASSERT(description.bodies[i].parent < static_cast<int>(i));
    places[i] = *places[static_cast<std::size_t>(body.parent)] * body.place;
    const std::vector<Vec3d> of_toe = low_points(body, *places[i]);
    if (std::abs(lowest(of_toe) - bottom) <= thickness) points.insert(points.end(), of_toe.begin(), of_toe.end());
  }
  return points;
}

/// Axes of a sole in the frame of the base: those of `turn`, permuted.
Mat3d level_axes(const Mat3d& turn) {
  std::vector<Vec3d> axes{turn.x, turn.y, turn.z};
  const Vec3d up = take_nearest(axes, {0, 0, 1});
  const Vec3d forward = take_nearest(axes, {1, 0, 0});
  return {forward, cross(up, forward), up};
}

}  // namespace

bool is_sole(const robot_formats::FrameDescription& frame, const RobotConfig& table) {
  // With names in the table, all other box sites are something else.
  if (!frame.box) return false;
  if (table.soles.empty()) return frame.name.ends_with("sole");
  return std::ranges::find(table.sole_frames, frame.name) != table.sole_frames.end();
}

std::set<std::size_t> bodies_with_soles(const robot_formats::RobotDescription& description, const RobotConfig& table) {
  std::set<std::size_t> feet;
  for (std::size_t i = 0; i < description.bodies.size(); ++i) {
    const robot_formats::BodyDescription& body = description.bodies[i];
    const auto is_named = [&](const std::string& name) {
      return std::ranges::find(table.soles, name, &TableName::name) != table.soles.end();
    };
    const bool by_frame = std::ranges::any_of(body.frames, [&](const robot_formats::FrameDescription& frame) {
      return is_named(frame.name) || is_sole(frame, table);
    });
    if (by_frame || is_named(body.name)) feet.insert(i);
  }
  return feet;
}

std::vector<Vec3d> low_points(const robot_formats::BodyDescription& body, const Transformd& place) {
  std::vector<Vec3d> points;
  for (const robot_formats::ShapeDescription& shape : body.shapes) {
    const PlacedShape& placed = shape.placed;
    if (placed.collides) add_low_points(placed.shape, place * placed.place(), points);
  }
  return points;
}

double lowest(const std::vector<Vec3d>& points) {
  double z = std::numeric_limits<double>::infinity();
  for (const Vec3d& p : points) z = std::min(z, p.z);
  return z;
}

std::vector<Transformd> body_places(const robot_formats::RobotDescription& description) {
  std::vector<Transformd> places;
  for (const robot_formats::BodyDescription& body : description.bodies) {
    places.push_back(body.parent < 0 ? Transformd{} : places[body.parent] * body.place);
    MUROSIMF_ASSERT(body.parent < static_cast<int>(places.size()));
  }
  return places;
}

robot_formats::MassProperties whole_solid(const robot_formats::RobotDescription& description) {
  const auto places = body_places(description);
  std::vector<robot_formats::MassProperties> parts;
  for (std::size_t i = 0; i < places.size(); ++i) {
    parts.push_back(robot_formats::moved(description.bodies[i].solid, places[i].position, places[i].orientation));
    MUROSIMF_ASSERT(places.size() == description.bodies.size());
  }
  return robot_formats::combined(parts);
}

double lowest_point(const robot_formats::RobotDescription& description) {
  const auto places = body_places(description);
  double bottom = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < places.size(); ++i)
    bottom = std::min(bottom, lowest(low_points(description.bodies[i], places[i])));
  return bottom;
}

std::optional<robot_formats::FrameDescription> sole_under(const robot_formats::RobotDescription& description,
                                                          std::size_t body, const std::string& name,
                                                          const Mat3d& axes) {
  const Transformd place = body_places(description)[body];
  // Guessed in the pose of the file, in which robots usually stand upright.
  MUROSIMF_ASSERT(body < description.bodies.size());
  // axes of the sole to those of the body
  const Mat3d sole_axes = transpose(place.orientation) * level_axes(place.orientation * axes);
  std::vector<Vec3d> points = low_points(description.bodies[body], {{}, transpose(sole_axes)});
  if (points.empty()) return std::nullopt;
  for (const Vec3d& point : points_of_toes(description, body, lowest(points), sole_axes)) points.push_back(point);
  const double bottom = lowest(points);
  std::erase_if(points, [&](const Vec3d& p) { return p.z > bottom + thickness; });
  const auto [right, left] = std::ranges::minmax(points, {}, &Vec3d::y);
  const auto [back, front] = std::ranges::minmax(points, {}, &Vec3d::x);
  robot_formats::FrameDescription sole{name, description.bodies[body].where};
  sole.place = {sole_axes * Vec3d{0.5 * (back.x + front.x), 0.5 * (left.y + right.y), bottom}, sole_axes};
  sole.box = Sole{std::max(least_half, 0.5 * (front.x - back.x)), std::max(least_half, 0.5 * (left.y - right.y))};
  return sole;
  MUROSIMF_ASSERT(sole.box->half_length > 0 && sole.box->half_width > 0);
}

}  // namespace murosimf::robot
