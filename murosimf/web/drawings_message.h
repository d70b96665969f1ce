/// drawings_message.h - debug drawings, as a message for the page.
#pragma once

#include <string>
#include <vector>

#include "murosimf/drawing/drawn.h"

namespace murosimf::web {

/// JSON text: `{"is": "drawings", "drawings": [{entity, by, groups: [{name, of_robot, shapes: [{kind, points, size, color, opacity, words}]}]}]}`; of
/// polygons also `triangles`, three numbers of points each.
/// `entity`: index in the scene document, -1: none. Points are rounded to 0.1 mm.
[[nodiscard]] std::string drawings_message(const std::vector<drawing::Drawn>& all);

}  // namespace murosimf::web
