/// scene_labels.h - meaning of the numbers in label pictures of a scene (sensors/view_source.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "murosimf/scene/scene.h"

namespace murosimf::scene {

struct LabelRow {
  std::uint16_t id = 0;
  std::string name;  ///< "ground", "blue1"
  std::string kind;  ///< "scenery", "robot", "ball" or "body"
};

/// Ordered by number, from 0 on without a gap.
[[nodiscard]] std::vector<LabelRow> label_table(const Scene& scene);

/// The same as JSON: {"schema": "murosimf/labels/1", "labels": [{"id": 0, "kind": "scenery", "name": "background"}, ...]}
[[nodiscard]] std::string label_table_json(const Scene& scene);

}  // namespace murosimf::scene
