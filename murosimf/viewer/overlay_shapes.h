/// overlay_shapes.h - overlays (overlays.h) as lines, areas and words in the pixels of a picture, for pictures without a window.
#pragma once

#include <vector>

#include "murosimf/render/seen_drawing.h"
#include "murosimf/viewer/overlays.h"

namespace murosimf::viewer {

struct OverlayStyle {
  double letters = 18;  ///< [px] height of labels
  double width = 1;     ///< factor of the widths of marks
  double top = 0;       ///< [px] that labels leave free at the upper edge
};

/// What a picture from `view` shows of them: marks, then labels. Labels do not cover each other: of two the nearer one keeps its place, the
/// other one goes up, or down if there is no room, and a line leads to its place if it went far; one for which there is no room at all is
/// left out, as is one whose place is not in the picture. Throws SetupError if this build has no pictures.
[[nodiscard]] std::vector<render::SeenShape> shapes_of(const Overlays& overlays, const sensors::Perspective& view,
                                                       const OverlayStyle& style);

}  // namespace murosimf::viewer
