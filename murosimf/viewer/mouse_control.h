/// mouse_control.h - effects of the mouse in the picture of a scene.
///
/// left drag: turn about the middle · right drag, or left with Alt: move the picture · wheel: zoom · click: select ·
/// double click: select, and look at it · right double click: look at that place; with Ctrl: follow it · Shift and left drag: move a robot, the ball
/// or a body over the ground, while it is paused · Ctrl and right drag: push it, along the plane of the picture · Ctrl and left drag:
/// turn it as if its front were pulled that way.
#pragma once

#include <functional>
#include <optional>

#include "murosimf/viewer/orbit_camera.h"
#include "murosimf/viewer/viewer.h"

namespace murosimf::viewer {

/// The object seen at a pixel.
struct Hit {
  std::optional<ObjectPath> path;  ///< nothing: the ground
  Vec3d point;                     ///< [m] world
};

class MouseControl {
 public:
  enum class Button { left, right, middle };
  struct Held {
    bool ctrl = false, shift = false, alt = false;
  };
  /// Nothing if no object is seen at a pixel.
  using Pick = std::function<std::optional<Hit>(const Pixel&)>;
  /// A push in preparation.
  struct Pull {
    ObjectPath path;
    Vec3d from, to;  ///< [m] world
    Vec3d force;     ///< [N]
    Vec3d moment{};  ///< [N m]
  };

  explicit MouseControl(Viewer& viewer) : viewer_(viewer) {}

  void press(Button button, const Held& held, const Pixel& pixel, const sensors::Perspective& view, const Pick& pick);
  void move(const Pixel& pixel, const sensors::Perspective& view);
  void release(const Pixel& pixel, const sensors::Perspective& view, const Pick& pick);
  void double_click(Button button, const Held& held, const Pixel& pixel, const Pick& pick);
  void wheel(double clicks);

  [[nodiscard]] bool drags() const { return kind_ != Kind::none; }
  [[nodiscard]] std::optional<Pull> pull() const;

 private:
  enum class Kind { none, orbit, pan, place, push, twist, nothing };
  void begin_with_thing(Kind kind, const Pixel& pixel, const sensors::Perspective& view, const Pick& pick);
  [[nodiscard]] std::optional<Vec3d> dragged_to(const Pixel& pixel, const sensors::Perspective& view) const;

  Viewer& viewer_;
  Kind kind_ = Kind::none;
  Button button_ = Button::left;
  Pixel began_, last_;
  bool went_far_ = false;
  ObjectPath path_;
  Vec3d grabbed_, start_, to_,
      normal_;  // [m] grabbed place, base at the start, place that it is pulled to; normal of the plane
};

}  // namespace murosimf::viewer
