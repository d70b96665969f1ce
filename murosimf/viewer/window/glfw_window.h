/// glfw_window.h - a window with an OpenGL context, and what keys and mouse do in it as a list of events.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "murosimf/viewer/key_map.h"
#include "murosimf/viewer/orbit_camera.h"

namespace murosimf::viewer {

struct KeyInput {
  KeyChord chord;
  bool pressed = false, again = false;  ///< again: it is held, and repeats
};
struct ButtonInput {
  int button = 0;  ///< 0 left, 1 right, 2 middle
  bool pressed = false;
};
struct MoveInput {
  Pixel place;  ///< of the window
};
struct WheelInput {
  double clicks = 0;
};
struct TextInput {
  unsigned int letter = 0;  ///< Unicode
};
using Input = std::variant<KeyInput, ButtonInput, MoveInput, WheelInput, TextInput>;

class GlfwWindow {
 public:
  /// Throws SetupError with what else there is, if there is no display or no OpenGL 3.3.
  GlfwWindow(const std::string& title, int width, int height);
  ~GlfwWindow();
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;

  /// What has come since the last call. Waits up to `patience` [s] if nothing has: a paused scene costs nothing.
  [[nodiscard]] std::vector<Input> inputs(double patience);
  [[nodiscard]] bool wants_to_close() const;
  /// [px] of what is drawn into.
  [[nodiscard]] std::pair<int, int> size() const;
  /// How much larger letters are to be on this screen.
  [[nodiscard]] double scale() const;
  void set_full_screen(bool full);
  /// OpenGL calls go to it from now on; nobody() before other contexts are used in this thread.
  void make_current();
  void make_nobody_current();
  void swap();

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace murosimf::viewer
