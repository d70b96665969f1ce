#include "murosimf/viewer/orbit_camera.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::viewer {
namespace {

constexpr double steepest = 0.5 * pi - 1e-3;      // [rad]
constexpr double nearest = 0.05, farthest = 200;  // [m]
constexpr double turn_per_height = pi;            // [rad] for a drag as long as the picture is high
constexpr double lowest = -0.2;                   // [rad] slightly from below
constexpr double share_per_click = 0.88;          // [1] of the distance
constexpr Vec3d upwards{0, 0, 1};

Vec3d toward_eye(double azimuth, double elevation) {
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

}  // namespace

sensors::Perspective look(const Vec3d& eye, const Vec3d& at, double fov, int width, int height) {
  MUROSIMF_ASSERT(fov > 0);
  sensors::Perspective view;
  view.eye = eye;
  view.axes.z = (1 / norm(at - eye)) * (at - eye);
  Vec3d right = cross(view.axes.z, upwards);
  if (norm(right) < 1e-9) right = {1, 0, 0};  // straight down: any direction will do
  view.axes.x = (1 / norm(right)) * right;
  view.axes.y = cross(view.axes.z, view.axes.x);
  view.right = std::tan(0.5 * fov);
  view.left = -view.right;
  view.bottom = view.right * height / std::max(1, width);
  view.top = -view.bottom;
  view.width = width;
  view.height = height;
  return view;
}

std::optional<Pixel> pixel_of(const sensors::Perspective& view, const Vec3d& place) {
  const Vec3d seen = transposed_times(view.axes, place - view.eye);
  if (!(seen.z > 1e-3)) return std::nullopt;
  return Pixel{(seen.x / seen.z - view.left) / (view.right - view.left) * view.width,
               (seen.y / seen.z - view.top) / (view.bottom - view.top) * view.height};
}

Ray ray_of(const sensors::Perspective& view, const Pixel& pixel) {
  const Vec3d optical{view.left + pixel.x / view.width * (view.right - view.left),
                      view.top + pixel.y / view.height * (view.bottom - view.top), 1};
  return {view.eye, view.axes * ((1 / norm(optical)) * optical)};
}

std::optional<Vec3d> on_plane(const sensors::Perspective& view, const Pixel& pixel, const Vec3d& place,
                              const Vec3d& normal) {
  const Ray ray = ray_of(view, pixel);
  const double slope = dot(ray.direction, normal);
  if (std::abs(slope) < 1e-6) return std::nullopt;
  const double way = dot(place - ray.from, normal) / slope;
  // beyond 10 km the intersection is meaningless to the user
  if (!(way > 0 && way < 1e4)) return std::nullopt;
  return ray.from + way * ray.direction;
}

/// Straight up or down there is no azimuth: then the usual one is taken.
void OrbitCamera::take_over(const sensors::Perspective& view) {
  const Vec3d forward = view.axes.z;
  elevation = std::asin(std::clamp(-forward.z, -1.0, 1.0));
  azimuth = std::hypot(forward.x, forward.y) > 1e-6 ? std::atan2(-forward.y, -forward.x) : -0.5 * pi;
  elevation = std::clamp(elevation, lowest, steepest);
  if (forward.z < -0.05) distance = std::clamp(view.eye.z / -forward.z, nearest, farthest);
  target = view.eye + distance * forward;
  fov = 2 * std::atan(std::max(-view.left, view.right));
}

void OrbitCamera::orbit(double right, double down, int height) {
  azimuth -= turn_per_height * right / height;
  elevation = std::clamp(elevation + turn_per_height * down / height, lowest, steepest);
}

void OrbitCamera::pan(double right, double down, int height) {
  const sensors::Perspective now = view(height, height);
  const double meters = 2 * now.right * distance / height;
  target -= meters * right * now.axes.x + meters * down * now.axes.y;
}

void OrbitCamera::zoom(double clicks) {
  distance = std::clamp(distance * std::pow(share_per_click, clicks), nearest, farthest);
}

void OrbitCamera::fly(double forward, double left, double up) {
  const Vec3d ahead{-std::cos(azimuth), -std::sin(azimuth), 0};
  target += forward * ahead + left * cross(upwards, ahead) + up * upwards;
}

sensors::Perspective OrbitCamera::view(int width, int height) const { return look(eye(), target, fov, width, height); }

Vec3d OrbitCamera::eye() const { return target + distance * toward_eye(azimuth, elevation); }

}  // namespace murosimf::viewer
