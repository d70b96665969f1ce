// [ball] of a scene file.
#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/files/toml_color.h"
#include "murosimf/scene_file/all_sections.h"
#include "murosimf/scene_file/section_readers.h"

namespace murosimf::scene_file {

const Section<BallSpec>& ball_section() {
  static const Section<BallSpec> section(
      "[ball]",
      {{"position", &BallSpec::position, "m", "z: height of its lowest point", up_to(farthest_place)},
       {"velocity", &BallSpec::velocity, "m/s", "at the start"},
       {"radius", &BallSpec::radius, "m", "of the sphere", positive},
       {"mass", &BallSpec::mass, "kg", "of all of it", positive},
       {"hollow", &BallSpec::hollow, "", "inertia of a shell, 2/3 m r^2, instead of 2/5 m r^2"},
       {"material", &BallSpec::material, "", "of its surface"},
       {"drag", &BallSpec::drag, "", "C_d in air", between(0, 10)},
       {"lift", &BallSpec::lift, "", "what C_l comes to at high spin", between(0, 10)},
       {"color",
        [](const files::TomlTable& table, std::string_view, BallSpec& ball) {
          ball.color = files::read_color(table, ball.color);
        },
        "",
        "red, green, blue from 0 to 1",
        {},
        "orange"},
       {"contact", Choice<BallSpec>{&BallSpec::contact, "contact law", [] { return entry_names(catalog::contacts()); }},
        "", "murosimf list contacts"},
       {"present", &BallSpec::present, "", "at the start; an event 'ball.present = true' brings it"}});
  return section;
}

void read_ball(const files::TomlTable& scene, SceneSpec& spec) {
  if (const toml::table* node = scene.table("ball")) ball_section().read(*node, spec.ball.emplace());
}

}  // namespace murosimf::scene_file
