/// glfw_window.h - a window with an OpenGL context, and its keys and mouse as a list of events.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/viewer/input.h"

namespace murosimf::viewer {

class GlfwWindow {
 public:
  /// `width` x `height` in points of the desktop: equal to pixels where scale() is 1, and limited to the screen. Throws SetupError with
  /// alternatives, if there is no display or no OpenGL 3.3.
  GlfwWindow(const std::string& title, int width, int height);
  ~GlfwWindow();
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;

  /// Events since the last call. Waits up to `patience` [s] if there are none: a paused scene costs nothing.
  [[nodiscard]] std::vector<Input> inputs(double patience);
  [[nodiscard]] bool wants_to_close() const;
  /// [px] of the framebuffer.
  [[nodiscard]] std::pair<int, int> size() const;
  /// Magnification of letters and everything else on this screen: 2 where a point of the desktop has two pixels.
  [[nodiscard]] double scale() const;
  void set_full_screen(bool full);
  /// OpenGL calls go to it from now on; call nobody() before other contexts are used in this thread.
  void make_current();
  void make_nobody_current();
  void swap();

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace murosimf::viewer
