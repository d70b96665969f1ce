// [field] of a scene file.
#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/scene_file/all_sections.h"
#include "murosimf/scene_file/field.h"
#include "murosimf/scene_file/section_readers.h"

namespace murosimf::scene_file {

const Section<FieldSpec>& field_section() {
  static const Section<FieldSpec> section(
      "[field]",
      {{"size", Choice<FieldSpec>{&FieldSpec::size, "field", field_names}, "",
        "lines and goals by the rules of a year"},
       {"surface", &FieldSpec::surface, "", "material of the ground"},
       {"friction_direction",
        &FieldSpec::friction_direction,
        "",
        "[x, y]: where the pile of the ground leans",
        {},
        "nowhere"},
       {"goals", &FieldSpec::goals, "", "false: none stand there, nor are their posts painted"},
       {"nets",
        [](const files::TomlTable& table, std::string_view key, FieldSpec& field) {
          table.read(key, field.nets.emplace());
        },
        "",
        "of the goals: they stop balls",
        {},
        "in kid_size_2023"},
       {"landmark_poles", &FieldSpec::landmark_poles, "", "true: two stand beside the half line, by the rules of 2008"},
       {"friction", &FieldSpec::friction, "", "between the ground and everything", not_negative, "by materials"}});
  return section;
}

void read_field(const files::TomlTable& scene, SceneSpec& spec) {
  const toml::table* node = scene.table("field");
  if (!node) return;
  field_section().read(*node, spec.field);
  if (spec.field.landmark_poles) {
    require(field_size(spec.field.size).pole_diameter > 0, files::TomlTable(*node, field_section().names()),
            "landmark_poles", fmt::format("cannot stand: the rules of {} have none", spec.field.size));
  }
  require(spec.field.goals || !spec.field.nets.value_or(false), files::TomlTable(*node, field_section().names()),
          "nets", "hang on goals, and 'goals' is false");
  require(spec.field.friction_direction.z == 0, files::TomlTable(*node, field_section().names()), "friction_direction",
          "lies in the ground: [x, y]");
}

}  // namespace murosimf::scene_file
