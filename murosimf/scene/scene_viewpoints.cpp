#include "murosimf/scene/scene_viewpoints.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::scene {
namespace {

constexpr double fov = 40 * pi / 180;  // [rad] of viewpoints that are not the scene's own
constexpr double margin = 1.04;        // [1] around the visible points

sensors::Perspective looking(const Vec3d& eye, const Vec3d& at, const Vec3d& upwards, double angle, int width,
                             int height) {
  MUROSIMF_ASSERT(width > 0 && height > 0 && angle > 0);
  sensors::Perspective view;
  view.eye = eye;
  view.axes.z = (1 / norm(at - eye)) * (at - eye);
  const Vec3d right = cross(view.axes.z, upwards);
  view.axes.x = (1 / norm(right)) * right;
  view.axes.y = cross(view.axes.z, view.axes.x);
  view.right = std::tan(0.5 * angle);
  view.left = -view.right;
  view.bottom = view.right * height / width;
  view.top = -view.bottom;
  view.width = width;
  view.height = height;
  return view;
}

Vec3d upwards_of(const Vec3d& direction) {
  // the vertical cannot be upwards in a view along it
  return std::hypot(direction.x, direction.y) > 1e-6 * norm(direction) ? Vec3d{0, 0, 1} : Vec3d{0, 1, 0};
}

/// View from the direction `toward` (unit, to the eye), at the smallest distance with all points in the picture.
sensors::Perspective around(const std::vector<Vec3d>& points, const Vec3d& middle, const Vec3d& toward, int width,
                            int height) {
  MUROSIMF_ASSERT(std::abs(norm(toward) - 1) < 1e-9);
  sensors::Perspective view = looking(middle + toward, middle, upwards_of(toward), fov, width, height);
  double distance = 0.2;
  for (const Vec3d& p : points) {  // |x| <= right (z + distance) at z and x from the middle, likewise y
    const Vec3d seen = margin * transposed_times(view.axes, p - middle);
    distance = std::max({distance, std::abs(seen.x) / view.right - seen.z, std::abs(seen.y) / view.bottom - seen.z});
  }
  view.eye = middle + distance * toward;
  return view;
}

std::vector<Vec3d> field_corners(const Scene& scene) {
  const Entity& field = *scene.simulation().world().find("field");
  const Markings* markings = field.model().find(properties::markings, 0);
  MUROSIMF_ASSERT(markings != nullptr);
  const double x = markings->half_length, y = markings->half_width;
  return {{x, y, 0}, {-x, y, 0}, {x, -y, 0}, {-x, -y, 0}};
}

Vec3d direction(double azimuth, double elevation) {
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

/// Without a width, all of the field is in the picture.
sensors::Perspective overview(const Scene& scene, int width, int height) {
  const scene_file::ViewSpec& spec = scene.spec().view;
  const Vec3d toward = direction(spec.azimuth, spec.elevation);
  if (spec.width == 0) return around(field_corners(scene), {}, toward, width, height);
  const double distance = 0.5 * spec.width / std::tan(0.5 * fov);
  return looking(spec.center + distance * toward, spec.center, upwards_of(toward), fov, width, height);
}

sensors::Perspective behind(const Entity& moving_entity, int width, int height) {
  const auto* r = moving_entity.find(properties::position);
  const auto* R = moving_entity.find(properties::orientation);
  MUROSIMF_ASSERT(r != nullptr && R != nullptr);
  const Vec3d at = r->values[0];
  const Vec3d ahead = rotation_z(heading(R->values[0])) * Vec3d{1, 0, 0};
  return looking(at - 1.0 * ahead + Vec3d{0, 0, 0.55}, at + 0.4 * ahead, {0, 0, 1}, 1.1, width, height);
}

}  // namespace

render::ParallelView parallel_view(const Scene& scene, int width, int height) {
  const scene_file::ViewSpec& spec = scene.spec().view;
  const Mat3d axes = render::axes_from(spec.azimuth, spec.elevation);
  if (spec.width == 0) return render::view_of(field_corners(scene), axes, width, height);
  return {.center = spec.center, .axes = axes, .pixel = spec.width / width, .width = width, .height = height};
}

sensors::Perspective perspective_around(const Scene& scene, const std::vector<Vec3d>& points, double elevation,
                                        int width, int height) {
  MUROSIMF_ASSERT(!points.empty());
  Vec3d middle;
  for (const Vec3d& p : points) middle += (1.0 / static_cast<double>(points.size())) * p;
  return around(points, middle, direction(scene.spec().view.azimuth, elevation), width, height);
}

std::vector<std::string> viewpoint_names(const Scene& scene) {
  std::vector<std::string> names{"overview", "top", "side", "left", "right"};
  for (const scene_file::ViewpointSpec& eye : scene.spec().viewpoints) names.push_back(eye.name);
  for (const Entity* moving_entity : scene.moving_entities()) names.push_back(moving_entity->name());
  return names;
}

sensors::Perspective viewpoint_perspective(const Scene& scene, const std::string& name, int width, int height) {
  for (const scene_file::ViewpointSpec& eye : scene.spec().viewpoints) {
    if (eye.name != name) continue;
    return looking(eye.eye, eye.look_at, upwards_of(eye.eye - eye.look_at), eye.fov, width, height);
  }
  if (name == "overview") return overview(scene, width, height);
  const std::vector<Vec3d> corners = field_corners(scene);
  if (name == "top") return around(corners, {}, {0, 0, 1}, width, height);
  if (name == "side") return around(corners, {}, direction(-0.5 * pi, 0.35), width, height);
  if (name == "left") return around(corners, {}, direction(pi, 0.35), width, height);
  if (name == "right") return around(corners, {}, direction(0, 0.35), width, height);
  for (const Entity* moving_entity : scene.moving_entities()) {
    if (moving_entity->name() == name) return behind(*moving_entity, width, height);
  }
  const auto names = viewpoint_names(scene);
  throw SetupError(unknown_name("view", name, {names.begin(), names.end()}));
}

}  // namespace murosimf::scene
