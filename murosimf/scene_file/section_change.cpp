#include "murosimf/scene_file/section_change.h"

#include "murosimf/model/error.h"
#include "murosimf/scene_file/all_sections.h"
#include "murosimf/scene_file/assignment.h"

namespace murosimf::scene_file {
namespace {

/// Reads the event's key and value as if they stood in the section of a file.
template <class Spec>
void read_key(const Section<Spec>& section, const SceneEvent& event, const std::vector<std::string_view>& known,
              Spec& spec) {
  const Assignment assignment{event.where, {event.section, event.key}, event.value};
  check_key(assignment, event.key, known);
  toml::table value = assignment.parsed(), table;
  table.insert(event.key, std::move(*value.get("value")));
  section.read(table, spec);
}

}  // namespace

const std::vector<std::string_view>& changeable_ball_keys() {
  static const std::vector<std::string_view> keys{"radius", "mass", "hollow", "material", "drag", "lift", "color"};
  return keys;
}

LightSpec changed(const LightSpec& light, const SceneEvent& event) {
  LightSpec result = light;
  read_key(light_section(), event, light_section().names(), result);
  return result;
}

BallSpec changed(const BallSpec& ball, const SceneEvent& event) {
  BallSpec result = ball;
  read_key(ball_section(), event, changeable_ball_keys(), result);
  return result;
}

}  // namespace murosimf::scene_file
