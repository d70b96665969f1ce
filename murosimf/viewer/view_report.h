/// view_report.h - results of a session at the window: for people as a line, for programs as JSON (docs/json.md).
#pragma once

#include <optional>
#include <string>

#include "murosimf/scene/run_report.h"
#include "murosimf/viewer/window.h"

namespace murosimf::viewer {

/// Call when the scene has stopped running.
[[nodiscard]] std::string to_text(Viewer& viewer, const WindowReport& shown);
/// One JSON object: "murosimf/view/1". `packets`: of other programs' drawings; nothing: no server was open.
[[nodiscard]] std::string to_json(Viewer& viewer, const WindowReport& shown,
                                  const std::optional<scene::DrawingPackets>& packets);

}  // namespace murosimf::viewer
