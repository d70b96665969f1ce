// [view], [views.NAME] and [light] of a scene file: how people and cameras see it.
#include <fmt/format.h>

#include "murosimf/model/find_entry.h"
#include "murosimf/render/light.h"
#include "murosimf/scene_file/all_sections.h"
#include "murosimf/scene_file/section_readers.h"

namespace murosimf::scene_file {
namespace {

void read_samples(const files::TomlTable& table, std::string_view key, LightSpec& light) {
  std::uint64_t samples = 1;
  table.read(key, samples);
  require(samples == 1 || samples == 2 || samples == 4 || samples == 8, table, key, "must be 1, 2, 4 or 8");
  light.samples = static_cast<int>(samples);
}

void read_toward(const files::TomlTable& table, std::string_view key, LightSpec& light) {
  Vec3d toward;
  table.read(key, toward);
  require(toward.z > 0, table, key, "must point upwards: light comes from above");
  light.toward = toward;
}

ViewpointSpec read_viewpoint(std::string_view name, const toml::table& node) {
  const files::TomlTable table(node, viewpoint_section().names());
  ViewpointSpec place{.name = std::string(name)};
  require(table.find("eye") != nullptr, table, "eye", "is missing: where the eye is, [x, y, z] in m");
  viewpoint_section().read(table, place);
  require(norm(place.look_at - place.eye) > 1e-3, table, "look_at", "is where the eye is");
  return place;
}

}  // namespace

const Section<ViewSpec>& view_section() {
  static const Section<ViewSpec> section(
      "[view]",
      {{"center", &ViewSpec::center, "m", "of the picture, with 'width'", up_to(farthest_place)},
       {"width", &ViewSpec::width, "m", "of what --pictures and the view 'overview' show", between(0, farthest_place),
        "all of the field"},
       {"azimuth_deg", Angle<ViewSpec>{&ViewSpec::azimuth}, "deg", "where the eye is, counterclockwise from x",
        between(-360, 360)},
       {"elevation_deg", Angle<ViewSpec>{&ViewSpec::elevation}, "deg", "of the eye above the ground", between(0, 90)}});
  return section;
}

const Section<ViewpointSpec>& viewpoint_section() {
  static const Section<ViewpointSpec> section(
      "[views.NAME]",
      {{"eye", &ViewpointSpec::eye, "m", "a place to look from: murosimf render --view NAME", up_to(farthest_place),
        "(needed)"},
       {"look_at", &ViewpointSpec::look_at, "m", "what is in the middle of the picture", up_to(farthest_place)},
       {"fov_deg", Angle<ViewpointSpec>{&ViewpointSpec::fov}, "deg", "from the left border to the right one",
        between(1, 150)}});
  return section;
}

const Section<LightSpec>& light_section() {
  static const Section<LightSpec> section(
      "[light]", {{"name", Choice<LightSpec>{&LightSpec::name, "light", [] { return entry_names(render::lights()); }},
                   "", "surroundings and lamps: hall, day, evening, spots, night, plain"},
                  {"toward", read_toward, "", "[x, y, z]: to the lamp, upwards", {}, "the lamp's own"},
                  {"brightness", &LightSpec::brightness, "", "of all light", between(0, 100)},
                  {"shadows", &LightSpec::shadows, "", "whether the lamp casts them"},
                  {"samples", read_samples, "", "to a pixel: 1, 2, 4 or 8; edges are smooth with 4", {}, "1"}});
  return section;
}

void read_view(const files::TomlTable& scene, SceneSpec& spec) {
  if (const toml::table* node = scene.table("view")) view_section().read(*node, spec.view);
}

void read_viewpoints(const files::TomlTable& scene, SceneSpec& spec) {
  const toml::table* views = scene.table("views");
  if (!views) return;
  for (const auto& [key, node] : *views) {
    const toml::table* inside = node.as_table();
    if (!inside) {
      files::fail_at(node.source(), fmt::format("view '{}' must be a table, like [views.{}]", key.str(), key.str()));
    }
    spec.viewpoints.push_back(read_viewpoint(key.str(), *inside));
  }
}

void read_light(const files::TomlTable& scene, SceneSpec& spec) {
  if (const toml::table* node = scene.table("light")) light_section().read(*node, spec.light);
}

}  // namespace murosimf::scene_file
