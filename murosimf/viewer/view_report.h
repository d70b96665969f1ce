/// view_report.h - what a session at the window has come to: for people as a line, for programs as JSON (docs/json.md).
#pragma once

#include <string>

#include "murosimf/viewer/window.h"

namespace murosimf::viewer {

/// When the scene does not run any more.
[[nodiscard]] std::string to_text(Viewer& viewer, const WindowReport& shown);
/// One JSON object: "murosimf/view/1".
[[nodiscard]] std::string to_json(Viewer& viewer, const WindowReport& shown);

}  // namespace murosimf::viewer
