#include "murosimf/appearance/robot_picture.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "murosimf/appearance/visual_meshes.h"
#include "murosimf/geometry/support.h"
#include "murosimf/model/chain.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/render/image_png.h"
#include "murosimf/render/renderer.h"
#include "murosimf/robot/robot_soles.h"
#include "murosimf/robot_formats/robot_visuals.h"

namespace murosimf::appearance {
namespace {

constexpr double gap = 0.15;  // [1] between two views, of the height of the first
constexpr double room = 0.9;  // [1] the title needs some
constexpr int samples = 4;    // to a pixel

/// Adds the readable ones, in the frame of the base. False if there are none: robot_checks reports them.
bool add_meshes(const std::vector<VisualMesh>& visuals, const Transformd& place, MeshPictures& pictures,
                render::EntityAppearance& robot) {
  bool any = false;
  for (const VisualMesh& visual : visuals) {
    try {
      std::vector<std::string> not_shown;
      for (auto& [mesh, color, as_it_is, picture] : visual_parts(visual, pictures, PictureUse::by_pixel, not_shown)) {
        for (Vec3d& v : mesh.vertices) v = place.position + place.orientation * v;
        robot.meshes.push_back({0, render::render_mesh_of(mesh, picture), color, as_it_is});
      }
      any = true;
    } catch (const SetupError&) {
      continue;
    }
  }
  return any;
}

/// The appearance of the robot in the frame of the base.
render::EntityAppearance appearance_of(const robot_formats::RobotDescription& description) {
  render::EntityAppearance robot;
  MeshPictures pictures;
  const auto places = robot::body_places(description);
  for (std::size_t i = 0; i < description.bodies.size(); ++i) {
    const robot_formats::BodyDescription& body = description.bodies[i];
    const bool has_meshes = add_meshes(robot_formats::visuals_of(description, body), places[i], pictures, robot);
    for (const robot_formats::ShapeDescription& shape : body.shapes) {
      PlacedShape placed = shape.placed;
      // Collision shapes are hidden by visual meshes.
      if (placed.color.alpha <= 0 || (has_meshes && placed.collides) || std::holds_alternative<Plane>(placed.shape))
        continue;
      const Transformd at = places[i] * placed.place();
      placed.position = at.position;
      placed.orientation = at.orientation;
      robot.shapes.push_back({0, placed});
    }
  }
  return robot;
}

/// Corners of the box around the robot after a turn; both zero if nothing is visible.
std::array<Vec3d, 2> extent_of(const render::EntityAppearance& robot, const Mat3d& turn) {
  Vec3d low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  const auto add = [&](const Vec3d& at) {
    const Vec3d p = turn * at;
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  };
  for (const render::ShownMesh& shown : robot.meshes) {
    for (const auto& [place, normal] : shown.solid.corners) add({place[0], place[1], place[2]});
  }
  for (const render::ShownShape& shown : robot.shapes) {
    const auto& [position, orientation] = shown.placed.place();
    for (const Vec3d& d : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}) {
      for (const double sign : {-1.0, 1.0}) {
        const Vec3d direction = transposed_times(turn * orientation, sign * d);
        add(position + orientation * geometry::support(shown.placed.shape, direction));
      }
    }
  }
  if (low.x > high.x) return {};
  return {low, high};
}

void place(Entity& entity, const Vec3d& position, const Mat3d& orientation) {
  entity.column(properties::position).values.assign(1, position);
  entity.column(properties::orientation).values.assign(1, orientation);
}

}  // namespace

imaging::ColorImage robot_picture(const robot_formats::RobotDescription& description, int columns, int rows) {
  // The eye looks along y: x is to the right, z up.
  const std::array turns{rotation_z(-0.5 * pi), rotation_z(pi), rotation_x(0.5 * pi) * rotation_z(0.5 * pi),
                         rotation_x(0.3) * rotation_z(-0.5 * pi + 0.6)};
  const render::EntityAppearance robot = appearance_of(description);
  const auto model = std::make_shared<const Model>("robot", Chain{}.base("robot"));
  World row;
  std::vector<Vec3d> corners;
  const auto [lowest, highest] = extent_of(robot, turns[0]);
  double right = 0;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const auto [low, high] = extent_of(robot, turns[i]);
    const Vec3d shift{right - low.x, 0, -0.5 * (low.z + high.z)};
    place(row.add(fmt::format("view_{}", i), model), shift, turns[i]);
    corners.insert(corners.end(), {low + shift, high + shift});
    right += high.x - low.x + gap * (highest.z - lowest.z);
  }
  // The light comes over the observer's left shoulder.
  const render::Light light{.toward = {-0.5, -0.65, 0.55}, .background = {0.83, 0.86, 0.88}, .shadows = false};
  const auto renderer = render::make_renderer(row, {}, [&](const Entity& /*entity*/) { return robot; },
                                              {.light = light, .samples = samples, .ground = false});
  renderer->locate();
  render::ParallelView view = render::view_of(corners, render::axes_from(-0.5 * pi, 0), columns, rows);
  view.pixel /= room;
  sensors::View drawn;
  renderer->draw(view, {}, 0, drawn);
  if (const std::string trouble = renderer->trouble(); !trouble.empty()) throw SetupError(trouble);
  return std::move(drawn.color);
}

std::string robot_picture_png(const robot_formats::RobotDescription& description) {
  return render::image_png(robot_picture(description), description.name + ": front, left side, top, from an angle");
}

}  // namespace murosimf::appearance
