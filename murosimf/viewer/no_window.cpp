// Replacement for the window where GLFW, Dear ImGui or OpenGL is missing.
#include "murosimf/model/error.h"
#include "murosimf/viewer/window.h"

namespace murosimf::viewer {

std::string no_window_because() {
  return "no window in this build: GLFW, Dear ImGui or OpenGL was missing (Debian and Ubuntu: libglfw3-dev, "
         "libimgui-dev, "
         "libepoxy-dev, libegl-dev); without a window: 'murosimf run SCENE --web' and 'murosimf render'";
}

WindowReport show(Viewer& /*viewer*/, const WindowOptions& /*options*/) { throw SetupError(no_window_because()); }

}  // namespace murosimf::viewer
