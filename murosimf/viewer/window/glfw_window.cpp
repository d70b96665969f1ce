#include "murosimf/viewer/window/glfw_window.h"

#include <array>
#include <cctype>
#include <string_view>

#include <epoxy/gl.h>  // before GLFW, which otherwise brings another one

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/viewer/window.h"

namespace murosimf::viewer {
namespace {

struct NamedKey {
  int key;
  std::string_view name;
};
constexpr std::array named_keys{
    NamedKey{GLFW_KEY_SPACE, "Space"},
    NamedKey{GLFW_KEY_TAB, "Tab"},
    NamedKey{GLFW_KEY_ENTER, "Enter"},
    NamedKey{GLFW_KEY_KP_ENTER, "Enter"},
    NamedKey{GLFW_KEY_ESCAPE, "Escape"},
    NamedKey{GLFW_KEY_BACKSPACE, "Backspace"},
    NamedKey{GLFW_KEY_BACKSLASH, "Backslash"},
    NamedKey{GLFW_KEY_DELETE, "Delete"},
    NamedKey{GLFW_KEY_INSERT, "Insert"},
    NamedKey{GLFW_KEY_HOME, "Home"},
    NamedKey{GLFW_KEY_END, "End"},
    NamedKey{GLFW_KEY_PAGE_UP, "PageUp"},
    NamedKey{GLFW_KEY_PAGE_DOWN, "PageDown"},
    NamedKey{GLFW_KEY_LEFT, "Left"},
    NamedKey{GLFW_KEY_RIGHT, "Right"},
    NamedKey{GLFW_KEY_UP, "Up"},
    NamedKey{GLFW_KEY_DOWN, "Down"},
};

/// Name by the layout of this keyboard; empty: a key without a name here.
std::string name_of(int key, int scancode) {
  for (const NamedKey& named : named_keys) {
    if (named.key == key) return std::string(named.name);
  }
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return fmt::format("F{}", key - GLFW_KEY_F1 + 1);
  const char* text = glfwGetKeyName(key, scancode);
  std::string name = text ? text : std::string();
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

std::string& last_trouble() {
  static std::string trouble;
  return trouble;
}

}  // namespace

struct GlfwWindow::Handles {
  GLFWwindow* window = nullptr;
  std::vector<Input> inputs;
  int x = 0, y = 0, width = 0, height = 0;  // of the window before it filled the screen
};

namespace {

std::vector<Input>& inputs_of(GLFWwindow* window) {
  return *static_cast<std::vector<Input>*>(glfwGetWindowUserPointer(window));
}

void take_key(GLFWwindow* window, int key, int scancode, int action, int mods) {
  KeyInput input{{name_of(key, scancode), (mods & GLFW_MOD_CONTROL) != 0, (mods & GLFW_MOD_SHIFT) != 0,
                  (mods & GLFW_MOD_ALT) != 0},
                 action != GLFW_RELEASE,
                 action == GLFW_REPEAT};
  const auto held = [&](int left, int right, bool& flag, const char* name) {
    if (key != left && key != right) return;
    input.chord.key = name;
    flag = action != GLFW_RELEASE;
  };
  held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL, input.chord.ctrl, "Ctrl");
  held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT, input.chord.shift, "Shift");
  held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT, input.chord.alt, "Alt");
  if (!input.chord.key.empty()) inputs_of(window).push_back(input);
}

/// Pixels of the framebuffer, which may be finer than the window's own.
Pixel in_pixels(GLFWwindow* window, double x, double y) {
  int width = 1, height = 1, pixels_x = 1, pixels_y = 1;
  glfwGetWindowSize(window, &width, &height);
  glfwGetFramebufferSize(window, &pixels_x, &pixels_y);
  return {x * pixels_x / std::max(1, width), y * pixels_y / std::max(1, height)};
}

/// All callbacks put their input into one queue, in the order in which it came.
void listen(GLFWwindow* window) {
  glfwSetKeyCallback(window, take_key);
  glfwSetCharCallback(window, [](GLFWwindow* of, unsigned int letter) { inputs_of(of).push_back(TextInput{letter}); });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* of, int button, int action, int) {
    if (button <= GLFW_MOUSE_BUTTON_MIDDLE)
      inputs_of(of).push_back(ButtonInput{button, action == GLFW_PRESS, input_clock()});
  });
  glfwSetCursorPosCallback(window, [](GLFWwindow* of, double x, double y) {
    inputs_of(of).push_back(MoveInput{in_pixels(of, x, y)});
  });
  glfwSetScrollCallback(window, [](GLFWwindow* of, double, double y) { inputs_of(of).push_back(WheelInput{y}); });
}

GLFWwindow* open(const std::string& title, int width, int height) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  // cameras draw by EGL; mixing it with GLX in one thread fails with some drivers
  for (const int api : {GLFW_EGL_CONTEXT_API, GLFW_NATIVE_CONTEXT_API}) {
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, api);
    if (GLFWwindow* window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr)) return window;
  }
  return nullptr;
}

/// Limited to the screen, which may be small for letters of that size.
void fit_to_screen(GLFWwindow* window) {
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  if (!monitor) return;
  int x = 0, y = 0, most_x = 0, most_y = 0, width = 0, height = 0;
  glfwGetMonitorWorkarea(monitor, &x, &y, &most_x, &most_y);
  glfwGetWindowSize(window, &width, &height);
  if (most_x > 0 && most_y > 0 && (width > most_x || height > most_y))
    glfwSetWindowSize(window, std::min(width, most_x), std::min(height, most_y));
}

}  // namespace

std::string no_window_because() {
  glfwSetErrorCallback([](int, const char* text) { last_trouble() = text; });
  if (glfwInit()) return {};
  return fmt::format(
      "no window: {}; without a display: 'murosimf run SCENE --web' shows it in a browser, 'murosimf render' makes "
      "pictures",
      last_trouble().empty() ? "there is no display" : last_trouble());
}

GlfwWindow::GlfwWindow(const std::string& title, int width, int height) : handles_(std::make_unique<Handles>()) {
  if (const std::string reason = no_window_because(); !reason.empty()) throw SetupError(reason);
  handles_->window = open(title, width, height);
  if (!handles_->window) {
    glfwTerminate();
    throw SetupError(
        fmt::format("no window with OpenGL 3.3: {}; without one: 'murosimf run SCENE --web' and 'murosimf render'",
                    last_trouble()));
  }
  glfwSetWindowUserPointer(handles_->window, &handles_->inputs);
  listen(handles_->window);
  if (scale() > 1) fit_to_screen(handles_->window);
  glfwMakeContextCurrent(handles_->window);
  glfwSwapInterval(1);
}

GlfwWindow::~GlfwWindow() {
  glfwDestroyWindow(handles_->window);
  glfwTerminate();
}

std::vector<Input> GlfwWindow::inputs(double patience) {
  patience > 0 ? glfwWaitEventsTimeout(patience) : glfwPollEvents();
  return std::exchange(handles_->inputs, {});
}

bool GlfwWindow::wants_to_close() const { return glfwWindowShouldClose(handles_->window) != 0; }

std::pair<int, int> GlfwWindow::size() const {
  std::pair<int, int> size;
  glfwGetFramebufferSize(handles_->window, &size.first, &size.second);
  return size;
}

double GlfwWindow::scale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(handles_->window, &x, &y);
  return std::clamp(static_cast<double>(x), 1.0, 4.0);
}

/// Place and size are kept for the way back.
void GlfwWindow::set_full_screen(bool full) {
  GLFWmonitor* monitor = glfwGetWindowMonitor(handles_->window);
  if (full == (monitor != nullptr)) return;
  if (!full) {
    return glfwSetWindowMonitor(handles_->window, nullptr, handles_->x, handles_->y, handles_->width, handles_->height,
                                GLFW_DONT_CARE);
  }
  glfwGetWindowPos(handles_->window, &handles_->x, &handles_->y);
  glfwGetWindowSize(handles_->window, &handles_->width, &handles_->height);
  monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
  if (mode) glfwSetWindowMonitor(handles_->window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void GlfwWindow::make_current() { glfwMakeContextCurrent(handles_->window); }
void GlfwWindow::make_nobody_current() { glfwMakeContextCurrent(nullptr); }
void GlfwWindow::swap() { glfwSwapBuffers(handles_->window); }

}  // namespace murosimf::viewer
