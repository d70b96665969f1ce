// `murosimf list`: names of levels, laws, controllers, sensors, parts, lenses, data sets, materials, properties, keys of scene files,
// formats, commands; and the order of a tick.
#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/command_line.h"
#include "apps/option_lists.h"
#include "apps/scene_arguments.h"
#include "apps/standard_output.h"
#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/catalog/property_catalog.h"
#include "murosimf/component_files/camera_info.h"
#include "murosimf/component_files/sensor_table.h"
#include "murosimf/component_files/sensor_types.h"
#include "murosimf/dynamics/integrator.h"
#include "murosimf/dynamics/servo/servo_law.h"
#include "murosimf/files/data_path.h"
#include "murosimf/geometry/any_tree.h"
#include "murosimf/model/material.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene_file/key_list.h"
#include "murosimf/viewer/actions.h"

namespace murosimf::app {
namespace {

/// Of a registry, or of another list of entries.
std::string names_and_meanings(const auto& entries) {
  std::string text;
  for (const auto& entry : entries) text += fmt::format("{:<22} {}\n", entry.name, entry.meaning);
  return text;
}

/// With the keys that only some types have.
std::string sensors_text() {
  std::string text;
  for (const component_files::SensorType& type : component_files::sensor_types()) {
    std::vector<std::string_view> keys = option_names(type.options);
    if (!type.objects.empty()) keys.push_back(type.objects);
    text += fmt::format("{:<22} {}{}\n", type.name, type.meaning,
                        keys.empty() ? "" : fmt::format("; keys: {}", fmt::join(keys, " ")));
  }
  return text;
}

/// Of robot files, then of meshes.
std::string formats_text() {
  constexpr std::string_view row = "{:<10} {:<12} {:<14} {}\n";
  std::string text = fmt::format(row, "robots", "endings", "first element", "meaning");
  for (const robot::RobotFormat& format : robot::robot_formats()) {
    const std::string root = format.root.empty() ? "" : fmt::format("<{}>", format.root);
    text += fmt::format(row, format.name, format.endings, root, format.meaning);
  }
  return text;
}

std::string properties_text() {
  std::string text =
      fmt::format("{:<30} {:<9} {:<7} {:<22} {:<28} {}\n", "property", "kind", "of", "unit", "frame", "meaning");
  for (const auto& [info, constant] : properties::catalog()) {
    text += fmt::format("{:<30} {:<9} {:<7} {:<22} {:<28} {}\n", info.name, constant ? "constant" : "variable",
                        info.scope == Scope::base ? "base" : "object", info.unit, info.frame, info.meaning);
  }
  return text;
}

/// What comes with the program and has a file.
std::string file_names(std::string_view kind, std::string_view extension) {
  return fmt::format("{}\n", fmt::join(files::data_file_names(kind, extension), "\n"));
}

/// The pairs that come with the program; a scene changes them by [[materials]] and --set materials.friction.
std::string materials_text() {
  std::string text =
      fmt::format("{:<10} {:<10} {:>9} {:>9} {:>9} {:>12} {:>12} {:>20} {:>19} {:>8} {:>17} {:>14}\n", "material",
                  "and", "friction", "rolling", "torsional", "restitution", "stiffness", "friction_anisotropy",
                  "rolling_anisotropy", "rebound", "viscous_friction", "spin_friction");
  const MaterialTable materials = MaterialTable::standard();
  for (const auto& [names, pair] : materials.pairs()) {
    const std::string stiffness = pair.stiffness > 0 ? fmt::format("{:g} N/m", pair.stiffness) : "by weight";
    text += fmt::format("{:<10} {:<10} {:>9g} {:>9g} {:>9g} {:>12g} {:>12} {:>20g} {:>19g} {:>8g} {:>17g} {:>14g}\n",
                        names.first, names.second, pair.friction, pair.rolling, pair.torsional, pair.restitution,
                        stiffness, pair.friction_anisotropy, pair.rolling_anisotropy, pair.rebound,
                        pair.viscous_friction, pair.spin_friction);
  }
  return text;
}

std::string section_text(const scene_file::SectionInfo& section) {
  std::string text = section.header.empty() ? "" : fmt::format("\n{}\n", section.header);
  if (!section.like.empty()) return text + fmt::format("those of {}, but 'name': for all of them\n", section.like);
  for (const scene_file::KeyInfo& key : section.keys) {
    text += fmt::format("{:<20} {:<10} {:<20} {}\n", key.name, key.unit, key.fallback, key.meaning);
  }
  return text;
}

/// Of a scene file, section by section.
std::string keys_text() {
  std::string text = fmt::format("{:<20} {:<10} {:<20} {}\n", "key", "unit", "default", "meaning");
  for (const scene_file::SectionInfo& section : scene_file::sections()) text += section_text(section);
  return text;
}

std::string_view phase_name(Phase phase) {
  constexpr std::array<std::string_view, 7> names{"survey",      "sense",  "control", "contact",
                                                  "interaction", "motion", "observe"};
  return names[static_cast<std::size_t>(phase)];
}

/// One line of a plan: algorithms of one wave, name and rate, with their entities.
struct PlanLine {
  std::string what;
  std::vector<std::pair<std::string, int>> entities;  ///< and how many algorithms each of them has there
};

/// Entities of a line; those that have several such algorithms with their number.
std::string entities_of(const PlanLine& line) {
  std::string text;
  for (const auto& [entity, count] : line.entities) {
    text += " " + entity + (count > 1 ? fmt::format(" ({})", count) : "");
  }
  return text;
}

/// The order of a tick of a scene.
std::string plan_text(const std::string& file) {
  scene::Scene scene(file, {.cameras = false});
  std::vector<PlanLine> lines;
  for (const PlannedAlgorithm& one : scene.simulation().order_of_tick()) {
    const std::string what =
        fmt::format("{:<5} {:<8} {:<22} {:>6.4g} ", one.wave + 1, phase_name(one.phase), one.name, one.rate_hz);
    auto line = std::ranges::find(lines, what, &PlanLine::what);
    if (line == lines.end()) line = lines.insert(line, {what, {}});
    if (line->entities.empty() || line->entities.back().first != one.entity) line->entities.emplace_back(one.entity, 0);
    ++line->entities.back().second;
  }
  std::string text = fmt::format("{:<5} {:<8} {:<22} {:>6}  {}\n", "wave", "phase", "algorithm", "rate", "entities");
  for (const PlanLine& line : lines) text += line.what + entities_of(line) + "\n";
  return text;
}

/// What keys of the viewer do: name for its file of keys, usual key, meaning.
std::string viewer_keys_text() {
  std::string text;
  for (const viewer::ActionInfo& info : viewer::actions()) {
    text += fmt::format("{:<18}{:<11}{}\n", info.name, info.key, info.meaning);
  }
  return text;
}

struct ListOptions {
  std::string what;
  std::string scene;
  std::vector<std::string> plugins;
};

void define(const Command& command, ListOptions& options) {
  const std::vector<std::string> kinds{"levels",      "contacts",    "body_contacts", "volumes",    "integrators",
                                       "servo_laws",  "controllers", "sensors",       "parts",      "lenses",
                                       "materials",   "scenes",      "models",        "properties", "keys",
                                       "options",     "formats",     "commands",      "plan",       "joint_references",
                                       "viewer_keys", "mjcf",        "urdf",          "sdf",        "datasets"};
  command.add("what", options.what, fmt::format("{}", fmt::join(kinds, ", "))).required().one_of(kinds).offers(kinds);
  command.add("scene", options.scene, "of 'plan': whose algorithms, in the order of a tick");
  add_plugins(command, options.plugins);
}

int list(const ListOptions& options, const CommandLine& line) {
  const std::string& what = options.what;
  if ((what == "plan") == options.scene.empty())
    throw SetupError(what == "plan" ? "list plan: name a scene, for example 'murosimf list plan walk'"
                                    : fmt::format("list {}: only 'plan' is of a scene", what));
  load_plugins(options.plugins);
  std::string text;
  if (what == "plan") text = plan_text(options.scene);
  if (what == "levels") text = names_and_meanings(catalog::levels());
  if (what == "contacts") text = names_and_meanings(catalog::contacts());
  if (what == "body_contacts") text = names_and_meanings(catalog::body_contacts());
  if (what == "volumes") {
    for (const auto& name : geometry::volume_names()) text += fmt::format("{}\n", name);
  }
  if (what == "integrators") text = names_and_meanings(dynamics::integrators());
  if (what == "joint_references") text = names_and_meanings(dynamics::joint_references());
  if (what == "servo_laws") text = names_and_meanings(dynamics::servo_laws());
  if (what == "controllers") text = names_and_meanings(catalog::controllers());
  if (what == "sensors") text = sensors_text();
  if (what == "parts") {
    for (const auto& name : component_files::sensor_parts()) text += fmt::format("{}\n", name);
  }
  if (what == "lenses") {
    for (const auto& name : component_files::lens_names()) text += fmt::format("{}\n", name);
  }
  if (what == "scenes") text = file_names("scenes", ".toml");
  if (what == "datasets") text = file_names("datasets", ".toml");
  if (what == "models") text = file_names("models", ".xml");
  if (what == "materials") text = materials_text();
  if (what == "properties") text = properties_text();
  if (what == "keys") text = keys_text();
  if (what == "formats") text = formats_text();
  for (const robot::RobotFormat& format : robot::robot_formats()) {
    if (what == format.name && format.words) text = files::to_text(format.words());
  }
  if (what == "commands") text = names_and_meanings(line.commands());
  if (what == "options") text = option_lists();
  if (what == "viewer_keys") text = viewer_keys_text();
  write_standard_output(text);
  return 0;
}

}  // namespace

void add_list(CommandLine& line) {
  const auto options = std::make_shared<ListOptions>();
  const Command command =
      line.add("list", "List the names that there are", [&line, options] { return list(*options, line); });
  define(command, *options);
}

}  // namespace murosimf::app
