#include "murosimf/io/robot_soles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "murosimf/geometry/support.h"

namespace murosimf::io {
namespace {

constexpr double thickness = 0.005;       // [m] what lies so near above the lowest point belongs to the sole
constexpr double level_feet = 0.01;       // [m] feet need not end at exactly the same height
constexpr double least_half = 0.01;       // [m] half width of a sole, also under a ball
constexpr double slope = 0.05;            // [1] points of a flat bottom are the farthest even in tilted directions
constexpr int directions = 16;            // around
constexpr std::size_t joints_of_leg = 3;  // at least; a wheel has fewer

/// Farthest points of a shape downwards and nearly so, in the frame of the base.
void add_low_points(const PlacedShape& shape, const Place& body, std::vector<Vec3d>& points) {
  const Place at = inside(body, {shape.position, shape.orientation});
  const auto add = [&](const Vec3d& down) {
    const Vec3d local = transposed_times(at.orientation, down);
    points.push_back(at.position + at.orientation * geometry::support(shape.shape, local));
  };
  add({0, 0, -1});
  for (int i = 0; i < directions; ++i) {
    // between the axes, too, so that the corners of a box come out
    const double angle = (i + 0.5) * 2 * pi / directions;
    add({slope * std::cos(angle), slope * std::sin(angle), -1});
  }
}

std::vector<Vec3d> low_points(const DraftBody& body, const Place& place) {
  std::vector<Vec3d> points;
  for (const DraftShape& shape : body.shapes) {
    if (shape.placed.collides) add_low_points(shape.placed, place, points);
  }
  return points;
}

/// [m] infinite without points.
double lowest(const std::vector<Vec3d>& points) {
  double z = std::numeric_limits<double>::infinity();
  for (const Vec3d& p : points) z = std::min(z, p.z);
  return z;
}

std::size_t joints_above(const RobotDraft& draft, std::size_t body) {
  std::size_t count = 0;
  for (int b = static_cast<int>(body); b >= 0; b = draft.bodies[b].parent) count += draft.bodies[b].joints.size();
  return count;
}

}  // namespace

std::vector<Place> body_places(const RobotDraft& draft) {
  std::vector<Place> places;
  for (const DraftBody& body : draft.bodies) {
    places.push_back(body.parent < 0 ? Place{} : inside(places[body.parent], body.place));
  }
  return places;
}

std::optional<DraftFrame> sole_under(const RobotDraft& draft, std::size_t body, const std::string& name) {
  const Place place = body_places(draft)[body];
  std::vector<Vec3d> points = low_points(draft.bodies[body], place);
  if (points.empty()) return std::nullopt;
  const double bottom = lowest(points);
  std::erase_if(points, [&](const Vec3d& p) { return p.z > bottom + thickness; });
  const auto [left, right] = std::ranges::minmax(points, {}, &Vec3d::y);
  const auto [back, front] = std::ranges::minmax(points, {}, &Vec3d::x);
  const Vec3d middle{0.5 * (back.x + front.x), 0.5 * (left.y + right.y), bottom};
  DraftFrame sole{name, draft.bodies[body].where};
  sole.place = {transposed_times(place.orientation, middle - place.position), transpose(place.orientation)};
  sole.box = Sole{std::max(least_half, 0.5 * (front.x - back.x)), std::max(least_half, 0.5 * (right.y - left.y))};
  return sole;
}

std::vector<std::size_t> find_feet(const RobotDraft& draft) {
  const auto places = body_places(draft);
  std::vector<double> bottoms;
  for (std::size_t i = 0; i < draft.bodies.size(); ++i)
    bottoms.push_back(lowest(low_points(draft.bodies[i], places[i])));
  const double ground = *std::ranges::min_element(bottoms);
  std::vector<std::size_t> feet;
  for (std::size_t i = 0; i < bottoms.size(); ++i) {
    if (bottoms[i] <= ground + level_feet && joints_above(draft, i) >= joints_of_leg) feet.push_back(i);
  }
  return feet;
}

}  // namespace murosimf::io
