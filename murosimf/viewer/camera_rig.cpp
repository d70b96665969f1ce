#include "murosimf/viewer/camera_rig.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::viewer {
namespace {

constexpr double tv_delay = 0.6;     // [s] delay of a cameraman
constexpr double tv_fov = 0.75;      // [rad]
constexpr double tv_height = 2.6;    // [m]
constexpr double tv_distance = 2.2;  // [m] outside of the touch line

std::size_t base_row(const PoseFrame& frame, int entity) {
  MUROSIMF_ASSERT(entity >= 0 && static_cast<std::size_t>(entity) < frame.first.size());
  return frame.first[static_cast<std::size_t>(entity)];
}

bool is_there(const PoseFrame* frame, int entity) {
  return frame && entity >= 0 && static_cast<std::size_t>(entity) < frame->present.size() &&
         frame->present[static_cast<std::size_t>(entity)];
}

}  // namespace

void CameraRig::advance(const RigView& scene, double wall) {
  const int target = follows && is_there(scene.frame, scene.selected) ? scene.selected : -1;
  if (target >= 0) {
    const Vec3d at = scene.frame->position[base_row(*scene.frame, target)];
    if (target == followed_) orbit.target += at - last_;
    last_ = at;
  }
  followed_ = target;
  const int watched = is_there(scene.frame, scene.ball) ? scene.ball : scene.selected;
  if (!is_there(scene.frame, watched)) return;
  const Vec3d at = scene.frame->position[base_row(*scene.frame, watched)];
  if (!attention_) attention_ = at;
  // exponential smoothing, independent of the picture rate
  *attention_ += (1 - std::exp(-wall / tv_delay)) * (at - *attention_);
}

/// Without a robot to look from or at, the free camera takes the place of the mode.
sensors::Perspective CameraRig::view(const RigView& scene, int width, int height) const {
  if (mode_ == Mode::robot && is_there(scene.frame, scene.selected)) return through_camera(scene, width, height);
  if (mode_ == Mode::tv) {
    const Vec3d at = attention_.value_or(Vec3d{});
    const Vec3d eye{0.6 * std::clamp(at.x, -scene.half_length, scene.half_length), -scene.half_width - tv_distance,
                    tv_height};
    return look(eye, {at.x, at.y, 0.2}, tv_fov, width, height);
  }
  return orbit.view(width, height);
}

/// A robot without a camera looks from about its head's height, derived from its base.
sensors::Perspective CameraRig::through_camera(const RigView& scene, int width, int height) const {
  const PoseFrame& frame = *scene.frame;
  const std::size_t first = base_row(frame, scene.selected);
  if (scene.camera) {
    const std::size_t row = first + static_cast<std::size_t>(scene.camera->link);
    MUROSIMF_ASSERT(row < frame.position.size());
    sensors::Perspective view = pinhole_view(*scene.camera, frame.position[row], frame.orientation[row], width, height);
    view.without = scene.carrier;
    return view;
  }
  const double turn = heading(frame.orientation[first]);
  const Vec3d ahead{std::cos(turn), std::sin(turn), 0};
  const Vec3d eye = frame.position[first] + 0.15 * ahead + Vec3d{0, 0, 0.15};
  sensors::Perspective view = look(eye, eye + ahead - Vec3d{0, 0, 0.2}, 1.2, width, height);
  view.without = scene.carrier;
  return view;
}

sensors::Perspective pinhole_view(const sensors::CameraInfo& camera, const Vec3d& r, const Mat3d& R, int width,
                                  int height) {
  sensors::Perspective view;
  view.eye = r + R * camera.position;
  view.axes = R * camera.orientation;
  const imaging::Lens& lens = camera.lens;
  const double middle = 0.5 * (lens.spec().height - 1);
  const auto half_view = [&](double u) {
    const auto ray = lens.ray({u, middle});
    return ray && ray->z > 0 ? std::min(std::abs(std::atan2(ray->x, ray->z)), widest_half_view) : widest_half_view;
  };
  // the mean of both halves: the principal point of a lens need not be in the middle
  view.right = std::tan(0.5 * (half_view(-0.5) + half_view(lens.spec().width - 0.5)));
  view.left = -view.right;
  view.bottom = view.right * height / std::max(1, width);
  view.top = -view.bottom;
  view.width = width;
  view.height = height;
  return view;
}

}  // namespace murosimf::viewer
