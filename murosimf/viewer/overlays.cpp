#include "murosimf/viewer/overlays.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::viewer {
namespace {

constexpr Color contact_color{1.0, 0.95, 0.2}, force_color{1.0, 0.3, 0.9}, center_color{0.15, 0.95, 0.95},
    box_color{0.75, 0.8, 0.85}, support_color{0.35, 1.0, 0.45}, moment_color{1.0, 0.25, 0.8};

/// One entity of a frame.
struct Posed {
  const EntityOutline& outline;
  std::span<const Vec3d> r;
  std::span<const Mat3d> R;
};

/// Adds the twelve edges of a box.
void add_box(const Transformd& place, const Vec3d& half, Overlays& into) {
  const auto corner = [&](int x, int y, int z) {
    return place.position + place.orientation * Vec3d{x * half.x, y * half.y, z * half.z};
  };
  for (const int z : {-1, 1}) {
    into.marks.push_back({.points = {corner(-1, -1, z), corner(1, -1, z), corner(1, 1, z), corner(-1, 1, z)},
                          .color = box_color,
                          .width = 1,
                          .closed = true});
  }
  for (const int x : {-1, 1}) {
    for (const int y : {-1, 1}) into.marks.push_back({{corner(x, y, -1), corner(x, y, 1)}, box_color, 1});
  }
}

/// [m] Middle and half sides of the box about a shape, in the shape's axes.
std::pair<Vec3d, Vec3d> box_of(const Shape& shape) {
  if (const auto* box = std::get_if<Box>(&shape)) return {{}, box->half_size};
  if (const auto* ellipsoid = std::get_if<Ellipsoid>(&shape)) return {{}, ellipsoid->semi_axes};
  if (const auto* cylinder = std::get_if<Cylinder>(&shape)) {
    return {{}, {cylinder->radius, cylinder->radius, cylinder->half_length}};
  }
  if (const auto* capsule = std::get_if<Capsule>(&shape)) {
    return {{}, {capsule->radius, capsule->radius, capsule->half_length + capsule->radius}};
  }
  if (const auto* convex = std::get_if<Convex>(&shape)) {
    const auto& corners = convex->hull->vertices;
    MUROSIMF_ASSERT(!corners.empty());
    Vec3d low = corners.front(), high = low;
    for (const Vec3d& p : corners) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    return {0.5 * (low + high), 0.5 * (high - low)};
  }
  const double radius = bounding_radius(shape);
  return {{}, {radius, radius, radius}};
}

void add_boxes(const Posed& entity, Overlays& into) {
  const Model& model = *entity.outline.model;
  for (const int i : model.having(properties::shapes)) {
    const auto row = static_cast<std::size_t>(i);
    MUROSIMF_ASSERT(row < entity.r.size() && row < entity.R.size());
    for (const PlacedShape& shape : *model.find(properties::shapes, i)) {
      const auto [middle, half] = box_of(shape.shape);
      const Mat3d R = entity.R[row] * shape.orientation;
      add_box({entity.r[row] + entity.R[row] * shape.position + R * middle, R}, half, into);
    }
  }
}

/// The foot of the plumb line shows whether the center of mass is above the soles.
void add_center_of_mass(const Posed& entity, Overlays& into) {
  const auto center = center_of_mass(*entity.outline.model, entity.r, entity.R);
  if (!center) return;
  const Vec3d below{center->x, center->y, 0};
  into.marks.push_back({{*center, below}, center_color, 1});
  into.marks.push_back({.points = {*center}, .color = center_color, .width = 4, .filled = true});
  into.marks.push_back({.points = {below}, .color = center_color, .width = 3});
}

void add_axes(const Posed& entity, Overlays& into) {
  const double length = 0.06;  // [m]
  const Model& model = *entity.outline.model;
  for (const Link& link : model.tree().links) {
    const auto i = static_cast<std::size_t>(link.object);
    MUROSIMF_ASSERT(i < entity.r.size());
    const Vec3d& r = entity.r[i];
    const Mat3d& R = entity.R[i];
    into.marks.push_back({{r, r + length * R.x}, {1, 0.2, 0.2}, 2});
    into.marks.push_back({{r, r + length * R.y}, {0.2, 1, 0.2}, 2});
    into.marks.push_back({{r, r + length * R.z}, {0.35, 0.5, 1}, 2});
  }
}

/// [m] Radius about that of a robot.
std::vector<Vec3d> ring_around(const Vec3d& middle) {
  constexpr int corners = 24;
  std::vector<Vec3d> ring;
  for (int i = 0; i < corners; ++i) {
    ring.push_back(middle + 0.22 * Vec3d{std::cos(2 * pi * i / corners), std::sin(2 * pi * i / corners), 0});
  }
  return ring;
}

void add_level(const Posed& entity, const std::string& level, Overlays& into) {
  into.marks.push_back({.points = ring_around({entity.r[0].x, entity.r[0].y, 0.005}),
                        .color = color_of_level(level),
                        .width = 3,
                        .closed = true});
}

/// A ring and an arrow at a robot's estimate of its pose, and a line from there to its true place.
void add_belief(const Posed& entity, const Vec3d& believed, Overlays& into) {
  const Color& color = entity.outline.color;
  constexpr double height = 0.006, length = 0.35;  // [m]
  const Vec3d at{believed.x, believed.y, height}, ahead{std::cos(believed.z), std::sin(believed.z), 0};
  into.marks.push_back({.points = ring_around(at), .color = color, .width = 2, .closed = true, .filled = true});
  into.marks.push_back({.points = {at, at + length * ahead}, .color = color, .width = 3, .arrow = true});
  into.marks.push_back({.points = {at, {entity.r[0].x, entity.r[0].y, height}}, .color = color, .width = 1});
}

/// [m] Above the highest of its origins.
Vec3d above(const Posed& entity) {
  double highest = entity.r[0].z;
  for (const Vec3d& r : entity.r) highest = std::max(highest, r.z);
  return {entity.r[0].x, entity.r[0].y, highest + 0.14};
}

void add_name(const Posed& entity, const std::string& level, const OverlayOptions& options, Overlays& into) {
  const bool with_level = options.levels && !level.empty();
  if (!options.names && !with_level) return;
  std::string text = options.names ? entity.outline.name : std::string();
  if (with_level) text += (text.empty() ? "" : ": ") + level;
  into.labels.push_back({above(entity), text, with_level ? color_of_level(level) : Color{1, 1, 1}});
}

/// Slightly above the ground, so that the marks are not hidden by it.
std::vector<Vec3d> ground_contacts(const PoseFrame& frame, std::size_t entity) {
  std::vector<Vec3d> points;
  for (const ContactMark& mark : frame.contacts) {
    if (mark.ground_contact_of == static_cast<int>(entity)) points.push_back({mark.point.x, mark.point.y, 0.003});
  }
  return points;
}

/// Small forces would be arrows without a visible direction.
void add_contacts(const PoseFrame& frame, const OverlayOptions& options, Overlays& into) {
  for (const ContactMark& mark : frame.contacts) {
    if (options.contacts) {
      into.marks.push_back({.points = {mark.point}, .color = contact_color, .width = 3, .filled = true});
    }
    if (options.forces && norm(mark.force) > 0.01) {
      into.marks.push_back({.points = {mark.point, mark.point + options.force_scale * mark.force},
                            .color = force_color,
                            .width = 2,
                            .arrow = true});
    }
  }
}

void add_zero_moment_point(const PoseFrame& frame, std::size_t entity, Overlays& into) {
  const auto point = zero_moment_point(frame, static_cast<int>(entity));
  if (!point) return;
  into.marks.push_back({.points = {*point}, .color = moment_color, .width = 4, .filled = true});
  into.marks.push_back({.points = {*point}, .color = moment_color, .width = 8});
}

/// Frames and inspections come at different instants: an entity may be gone by now.
void add_loads(const PoseFrame& frame, const Inspection& seen, Overlays& into) {
  for (const JointLoad& load : seen.loads) {
    const auto entity = static_cast<std::size_t>(load.path.entity);
    if (entity + 1 >= frame.first.size() || !frame.present[entity]) continue;
    const Vec3d place = frame.position[frame.first[entity] + static_cast<std::size_t>(load.path.object)];
    into.marks.push_back({.points = {place}, .color = color_of_load(load.share), .width = 6, .filled = true});
  }
}

}  // namespace

Overlays overlays(const PoseFrame& frame, std::span<const EntityOutline> outline, const Inspection& seen,
                  const OverlayOptions& options, int selected) {
  Overlays into;
  const std::size_t count = std::min({outline.size(), frame.present.size(), seen.entities.size()});
  MUROSIMF_ASSERT(frame.first.size() > count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!frame.present[i] || !outline[i].moves) continue;
    const std::size_t first = frame.first[i], rows = frame.first[i + 1] - first;
    const Posed entity{outline[i], std::span(frame.position).subspan(first, rows),
                       std::span(frame.orientation).subspan(first, rows)};
    MUROSIMF_ASSERT(rows > 0);
    const std::string& level = outline[i].is_robot ? seen.entities[i].level : std::string();
    if (options.levels && outline[i].is_robot) add_level(entity, level, into);
    if (options.support_polygons && outline[i].is_robot) {
      Mark hull{.points = hull_on_ground(ground_contacts(frame, i)),
                .color = support_color,
                .closed = true,
                .filled = true};
      if (hull.points.size() > 2) into.marks.push_back(std::move(hull));
    }
    if (options.zero_moment_points && outline[i].is_robot) add_zero_moment_point(frame, i, into);
    if (options.beliefs && seen.entities[i].believed_pose) add_belief(entity, *seen.entities[i].believed_pose, into);
    if (options.bounding_volumes) add_boxes(entity, into);
    if (options.centers_of_mass) add_center_of_mass(entity, into);
    if (options.frames && static_cast<int>(i) == selected) add_axes(entity, into);
    add_name(entity, level, options, into);
  }
  if (options.joint_loads) add_loads(frame, seen, into);
  add_contacts(frame, options, into);
  return into;
}

std::optional<Vec3d> zero_moment_point(const PoseFrame& frame, int entity) {
  double force = 0;
  Vec3d moment;
  for (const ContactMark& mark : frame.contacts) {
    // only forces that support: a pull by a sticking contact carries nothing
    if (mark.ground_contact_of != entity || !(mark.force.z > 0)) continue;
    force += mark.force.z;
    moment += mark.force.z * mark.point;
  }
  constexpr double least = 1e-3;  // [N]
  if (force < least) return std::nullopt;
  return (1 / force) * moment;
}

Color color_of_load(double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  return {std::min(1.0, 2 * s), std::min(1.0, 2 - 2 * s), 0.1};
}

/// Nothing for models without mass.
std::optional<Vec3d> center_of_mass(const Model& model, std::span<const Vec3d> r, std::span<const Mat3d> R) {
  MUROSIMF_ASSERT(r.size() == R.size());
  double mass = 0;
  Vec3d moment;
  for (const Link& link : model.tree().links) {
    const auto i = static_cast<std::size_t>(link.object);
    mass += link.mass;
    moment += link.mass * (r[i] + R[i] * link.com);
  }
  return mass > 0 ? std::optional<Vec3d>((1 / mass) * moment) : std::nullopt;
}

std::vector<Vec3d> hull_on_ground(std::vector<Vec3d> points) {
  std::ranges::sort(points, [](const Vec3d& a, const Vec3d& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  if (points.size() < 3) return points;
  const auto turns_right = [](const Vec3d& o, const Vec3d& a, const Vec3d& b) {
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x) <= 1e-12;
  };
  std::vector<Vec3d> hull;  // Andrew's monotone chain: lower, then upper part
  const auto extend = [&](const Vec3d& point, std::size_t least) {
    while (hull.size() >= least + 2 && turns_right(hull[hull.size() - 2], hull.back(), point)) hull.pop_back();
    hull.push_back(point);
  };
  for (const Vec3d& point : points) extend(point, 0);
  const std::size_t lower = hull.size() - 1;
  for (auto point = points.rbegin() + 1; point != points.rend(); ++point) extend(*point, lower);
  hull.pop_back();
  return hull;
}

Color color_of_level(std::string_view level) {
  if (level == "kinematic_walking") return {0.55, 0.75, 1.0};
  if (level == "simplified_dynamics") return {0.45, 0.95, 0.5};
  if (level == "full_dynamics") return {1.0, 0.85, 0.3};
  if (level == "articulated_dynamics") return {1.0, 0.5, 0.35};
  std::size_t sum = 0;
  for (const char c : level) sum = 31 * sum + static_cast<unsigned char>(c);
  return curve_color(sum);
}

Color curve_color(std::size_t number) {
  constexpr std::array<Color, 8> colors{{{0.95, 0.45, 0.35},
                                         {0.45, 0.85, 0.45},
                                         {0.45, 0.65, 1.0},
                                         {0.95, 0.8, 0.35},
                                         {0.8, 0.5, 0.95},
                                         {0.4, 0.9, 0.9},
                                         {0.95, 0.6, 0.8},
                                         {0.75, 0.75, 0.75}}};
  return colors[number % colors.size()];
}

}  // namespace murosimf::viewer
