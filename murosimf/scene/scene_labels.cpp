#include "murosimf/scene/scene_labels.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "murosimf/math/assert.h"
#include "murosimf/scene/scene_parts.h"
#include "murosimf/sensors/view_source.h"

namespace murosimf::scene {
namespace {

std::string kind_of(const SceneParts& parts, const Entity* entity) {
  if (entity == parts.ball) return "ball";
  return std::ranges::find(parts.robots, entity) != parts.robots.end() ? "robot" : "body";
}

}  // namespace

std::vector<LabelRow> label_table(const Scene& scene) {
  std::vector<LabelRow> rows{{sensors::label_background, "background", "scenery"},
                             {sensors::label_ground, "ground", "scenery"},
                             {sensors::label_line, "line", "scenery"},
                             {sensors::label_goal, "goal", "scenery"}};
  const SceneParts& parts = scene.parts();
  for (const Entity* entity : parts.moving_entities) {
    MUROSIMF_ASSERT(rows.size() <= 0xFFFF);
    rows.push_back({static_cast<std::uint16_t>(rows.size()), entity->name(), kind_of(parts, entity)});
  }
  return rows;
}

std::string label_table_json(const Scene& scene) {
  nlohmann::json labels = nlohmann::json::array();
  for (const LabelRow& row : label_table(scene))
    labels.push_back({{"id", row.id}, {"name", row.name}, {"kind", row.kind}});
  return nlohmann::json{{"schema", "murosimf/labels/1"}, {"labels", labels}}.dump();
}

}  // namespace murosimf::scene
