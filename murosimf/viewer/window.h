/// window.h - shows a viewer in a window until it is closed, or a script ends it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/runtime/pacer.h"
#include "murosimf/viewer/key_map.h"
#include "murosimf/viewer/script.h"
#include "murosimf/viewer/viewer.h"

namespace murosimf::viewer {

struct WindowOptions {
  std::string title = "MuRoSimF";
  int width = 1280, height = 720;  ///< [px]
  KeyMap keys{};
  std::optional<std::vector<ScriptStep>> script{};  ///< script to run; then it ends
  std::string screenshot{};                         ///< PNG file; empty: none
  std::optional<double> after{};  ///< [s] of wall time, after which the screenshot is taken, and it ends
  std::optional<int>
      samples{};  ///< per pixel of the scene, 1 to 8: smooth edges; nothing: 4, or 1 with software rendering
  std::optional<bool> shadows{};  ///< nothing: on, except with software rendering that is too slow (docs/viewer.md)
  StopRequest stop{};             ///< ends it
};

/// Statistics of the window.
struct WindowReport {
  std::int64_t pictures = 0;
  double wall = 0;                 ///< [s] from the first picture to the last one
  double scene_ms = 0;             ///< mean, to draw the scene
  std::string drawn_by;            ///< "llvmpipe (LLVM 15.0.6, 256 bits), software"
  std::vector<std::string> files;  ///< screenshots
};

/// Throws SetupError if this build or this machine has no window, or the script fails.
WindowReport show(Viewer& viewer, const WindowOptions& options);

/// Reason why no window is possible: one line with alternatives; empty if none is known.
[[nodiscard]] std::string no_window_because();

}  // namespace murosimf::viewer
