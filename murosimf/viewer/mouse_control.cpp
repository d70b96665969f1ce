#include "murosimf/viewer/mouse_control.h"

#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::viewer {
namespace {

constexpr double still = 4;            // [px] tolerated movement of a click
constexpr double least_force = 0.5;    // [N] smaller pushes are regarded as unintended
constexpr double least_moment = 0.05;  // [N m]

}  // namespace

void MouseControl::press(Button button, const Held& held, const Pixel& pixel, const sensors::Perspective& view,
                         const Pick& pick) {
  button_ = button;
  began_ = last_ = pixel;
  went_far_ = false;
  if (held.ctrl) return begin_with_thing(button == Button::left ? Kind::twist : Kind::push, pixel, view, pick);
  if (held.shift && button == Button::left) return begin_with_thing(Kind::place, pixel, view, pick);
  kind_ = button == Button::left && !held.alt ? Kind::orbit : Kind::pan;
}

void MouseControl::begin_with_thing(Kind kind, const Pixel& pixel, const sensors::Perspective& view, const Pick& pick) {
  kind_ = Kind::nothing;
  const auto hit = pick(pixel);
  MUROSIMF_ASSERT(!hit || !hit->path || static_cast<std::size_t>(hit->path->entity) < viewer_.outline().size());
  if (!hit || !hit->path || !viewer_.outline()[static_cast<std::size_t>(hit->path->entity)].moves) {
    return viewer_.tell("take hold of a robot, a body or the ball", true);
  }
  if (kind == Kind::place && !viewer_.status().paused)
    return viewer_.tell("pause first (Space), then move things", true);
  path_ = *hit->path;
  grabbed_ = to_ = hit->point;
  start_ = viewer_.poses().place_of({path_.entity, 0}).value_or(hit->point);
  normal_ = kind == Kind::place ? Vec3d{0, 0, 1} : view.axes.z;
  kind_ = kind;
  viewer_.select(kind == Kind::place ? ObjectPath{path_.entity, 0} : path_);
}

std::optional<Vec3d> MouseControl::dragged_to(const Pixel& pixel, const sensors::Perspective& view) const {
  return on_plane(view, pixel, grabbed_, normal_);
}

/// A small tremble of the hand is still a click.
void MouseControl::move(const Pixel& pixel, const sensors::Perspective& view) {
  if (kind_ == Kind::none) return;
  const double right = pixel.x - last_.x, down = pixel.y - last_.y;
  last_ = pixel;
  if (std::hypot(pixel.x - began_.x, pixel.y - began_.y) > still) went_far_ = true;
  if (!went_far_) return;
  if (kind_ == Kind::orbit || kind_ == Kind::pan) {
    viewer_.rig.set_mode(CameraRig::Mode::free);
    if (kind_ == Kind::orbit) viewer_.rig.orbit.orbit(right, down, view.height);
    if (kind_ == Kind::pan) viewer_.rig.orbit.pan(right, down, view.height);
    return;
  }
  const auto place = dragged_to(pixel, view);
  if (!place) return;
  to_ = *place;
  if (kind_ == Kind::place) viewer_.steering.move(path_.entity, start_ + (to_ - grabbed_));
}

/// The drag ends where the button is released, also if no move was reported before.
void MouseControl::release(const Pixel& pixel, const sensors::Perspective& view, const Pick& pick) {
  move(pixel, view);
  const auto pulled = pull();
  const Kind kind = kind_;
  kind_ = Kind::none;
  if (pulled && norm(pulled->force) > least_force) viewer_.steering.push(pulled->path, pulled->force);
  if (pulled && norm(pulled->moment) > least_moment) viewer_.steering.twist(pulled->path, pulled->moment);
  if (kind != Kind::orbit || went_far_) return;
  const auto hit = pick(pixel);
  if (hit && hit->path && viewer_.outline()[static_cast<std::size_t>(hit->path->entity)].moves) {
    viewer_.select(hit->path);
  } else {
    viewer_.select(std::nullopt);
  }
}

/// The place becomes the center of rotation, also on the ground.
void MouseControl::double_click(Button button, const Held& held, const Pixel& pixel, const Pick& pick) {
  const auto hit = pick(pixel);
  if (!hit) return;
  if (hit->path && (button == Button::left || held.ctrl)) viewer_.select(hit->path);
  viewer_.rig.set_mode(CameraRig::Mode::free);
  viewer_.rig.orbit.target = hit->point;
  if (button == Button::right && held.ctrl) viewer_.rig.follows = true;
}

void MouseControl::wheel(double clicks) {
  viewer_.rig.set_mode(CameraRig::Mode::free);
  viewer_.rig.orbit.zoom(clicks);
}

std::optional<MouseControl::Pull> MouseControl::pull() const {
  if ((kind_ != Kind::push && kind_ != Kind::twist) || !went_far_) return std::nullopt;
  const Vec3d way = to_ - grabbed_;
  if (kind_ == Kind::push) return Pull{path_, grabbed_, to_, viewer_.newtons_per_meter * way};
  // the grabbed front points to the eye, against the normal, hence cross(way, normal)
  return Pull{path_, grabbed_, to_, {}, viewer_.newton_meters_per_meter * cross(way, normal_)};
}

}  // namespace murosimf::viewer
