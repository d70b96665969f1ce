#include "murosimf/scene_file/scene_spec.h"

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/model/find_entry.h"
#include "murosimf/scene_file/all_sections.h"
#include "murosimf/scene_file/automatic_rate.h"
#include "murosimf/scene_file/event_section.h"
#include "murosimf/scene_file/material_section.h"
#include "murosimf/scene_file/overrides.h"
#include "murosimf/scene_file/push_section.h"
#include "murosimf/scene_file/robot_options.h"
#include "murosimf/scene_file/section_readers.h"
#include "murosimf/world/time.h"

namespace murosimf::scene_file {
namespace {

void read_rate(const files::TomlTable& scene, std::string_view key, SceneSpec& spec) {
  spec.automatic_rate = scene.find(key)->value_or(std::string_view{}) == "auto";
  if (spec.automatic_rate) return;
  require(scene.find(key)->is_number(), scene, key, "must be a number of Hz, or \"auto\"");
  spec.rate = section_detail::read_number(scene, key, between(slowest_rate, fastest_rate), "Hz");
}

/// Two numbers would be a place on the ground.
void read_gravity(const files::TomlTable& scene, std::string_view key, SceneSpec& spec) {
  const toml::array* list = scene.find(key)->as_array();
  require(!list || list->size() == 3, scene, key, "must be three numbers in brackets: x, y, z in m/s^2");
  scene.read(key, spec.gravity);
}

void read_body_contact_options(const files::TomlTable& scene, SceneSpec& spec) {
  const toml::table* given = scene.table("body_contact_options");
  if (!given) return;
  const catalog::BodyContactLawType& law = catalog::body_contacts().find(spec.body_contact);
  spec.body_contact_options =
      read_own_options(*given, fmt::format("law of contact between bodies '{}'", law.name), law.options);
}

}  // namespace

const Section<SceneSpec>& scene_section() {
  static const Section<SceneSpec> section(
      "",
      {{"name", &SceneSpec::name, "", "title of reports and pictures", {}, "that of the file"},
       {"duration", &SceneSpec::duration, "s", "of simulated time", between(0, longest_duration)},
       {"seed", &SceneSpec::seed, "", "of all random numbers"},
       {"rate", read_rate, "Hz", "of steps: motion and contact; \"auto\": the longest that change little", {}, "1000"},
       {"gravity", read_gravity, "m/s^2", "in the world", {}, "[0, 0, -9.81]"},
       {"body_contact",
        Choice<SceneSpec>{&SceneSpec::body_contact, "law of contact between bodies",
                          [] { return entry_names(catalog::body_contacts()); }},
        "", "how moving bodies push each other: murosimf list body_contacts"},
       {"body_contact_options", {}, "", "of that law: murosimf list options", {}, "the law's"},
       {"start", {}, "", "see [start]"},
       {"air", {}, "", "see [air]"},
       {"field", {}, "", "see [field]"},
       {"view", {}, "", "see [view]"},
       {"views", {}, "", "see [views.NAME]"},
       {"light", {}, "", "see [light]"},
       {"ball", {}, "", "see [ball]", {}, "no ball"},
       {"teams", {}, "", "see [[teams]]"},
       {"defaults", {}, "", "keys of all robots, see [defaults]"},
       {"robots", {}, "", "see [[robots]]"},
       {"bodies", {}, "", "see [[bodies]]"},
       {"materials", {}, "", "see [[materials]]"},
       {"events", {}, "", "see [[events]]"},
       {"pushes", {}, "", "see [[pushes]]"},
       {"communication", {}, "", "see [communication]"},
       {"league", {}, "", "see [league]"},
       {"algorithms", {}, "", "see [[algorithms]]"}});
  return section;
}

const Section<SceneSpec>& start_section() {
  const Bounds up_to_a_turn = between(0, 360);
  static const Section<SceneSpec> section(
      "[start]", {{"jitter_position", &SceneSpec::jitter_position, "m",
                   "starts vary by up to this in x and y, by seed and name", between(0, farthest_place)},
                  {"jitter_heading_deg", Angle<SceneSpec>{&SceneSpec::jitter_heading}, "deg", "the same of headings",
                   up_to_a_turn},
                  {"jitter_tilt_deg", Angle<SceneSpec>{&SceneSpec::jitter_tilt}, "deg", "about any axis", up_to_a_turn},
                  {"jitter_posture_deg", Angle<SceneSpec>{&SceneSpec::jitter_posture}, "deg",
                   "joint targets, of robots without a controller that sets them", up_to_a_turn}});
  return section;
}

void require(bool condition, const files::TomlTable& table, std::string_view key, std::string_view message) {
  if (!condition) throw SetupError(fmt::format("{}: '{}' {}", table.where(key), key, message));
}

SceneSpec read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                     const std::vector<std::string>& at_options, const std::vector<std::string>& push_options) {
  SceneSpec spec;
  toml::table document = files::parse_toml_file(file);
  if (document.empty()) throw SetupError(fmt::format("{}: the file is empty", file.string()));
  std::vector<MaterialChange> material_changes;
  for (const std::string& text : overrides) {
    if (!take_material_change(text, material_changes)) apply_override(document, text, spec.settings);
  }

  const files::TomlTable scene(document, scene_section().names());
  spec.file = file;
  spec.name = file.stem().string();
  scene_section().read(scene, spec);
  if (const toml::table* start = scene.table("start")) start_section().read(*start, spec);
  read_body_contact_options(scene, spec);
  read_air(scene, spec);
  read_field(scene, spec);
  read_view(scene, spec);
  read_light(scene, spec);
  read_viewpoints(scene, spec);
  read_ball(scene, spec);
  read_teams(scene, spec);
  read_robots(scene, spec);
  read_bodies(scene, spec);
  read_materials(scene, spec);
  read_communication(scene, spec);
  read_league(scene, spec);
  read_algorithms(scene, spec);
  apply_material_changes(material_changes, spec);
  spec.events = read_events(document, at_options);
  spec.pushes = read_pushes(document, push_options);
  if (spec.automatic_rate) {
    AutomaticRate automatic = automatic_rate(spec);
    spec.rate = automatic.hz;
    spec.rate_because = std::move(automatic.because);
  }
  return spec;
}

}  // namespace murosimf::scene_file
