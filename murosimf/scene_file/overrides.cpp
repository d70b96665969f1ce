#include "murosimf/scene_file/overrides.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/scene_file/assignment.h"
#include "murosimf/scene_file/key_list.h"
#include "murosimf/scene_file/robot_options.h"
#include "murosimf/scene_file/setting_targets.h"

namespace murosimf::scene_file {
namespace {

void assign(toml::table& table, const std::string& key, const Assignment& o) {
  toml::table value = o.parsed();
  table.insert_or_assign(key, std::move(*value.get("value")));
}

/// Keys of an existing section.
std::vector<std::string_view> keys_of(std::string_view section) {
  const SectionInfo* found = find_section(section);
  MUROSIMF_ASSERT(found != nullptr);
  return names_of(*found);
}

/// The same for sections that occur only once in a file; empty if there is none of that name.
std::vector<std::string_view> keys_of_one(std::string_view name) {
  const SectionInfo* section = find_section(name);
  const bool once = section && section->header == fmt::format("[{}]", name);
  return once ? names_of(*section) : std::vector<std::string_view>{};
}

/// The table of a key, created if missing.
toml::table& table_in(toml::table& table, const std::string& key, const Assignment& o) {
  if (!table.contains(key)) table.insert(key, toml::table{});
  if (toml::table* inside = table[key].as_table()) return *inside;
  throw SetupError(fmt::format("{}: '{}' is no table there, so nothing in it can be set", o.where, key));
}

/// sensors.NAME, sensors.NAME.KEY or sensors.NAME.OUTPUT.KEY, from part `begin` of the path on.
void assign_sensor(toml::table& robot, const Assignment& o, std::size_t begin) {
  MUROSIMF_ASSERT(begin < o.path.size());
  if (o.path.size() - begin > 4) {
    throw SetupError(fmt::format("{}: write sensors.NAME.KEY or sensors.NAME.OUTPUT.KEY", o.where));
  }
  toml::table* table = &robot;
  for (std::size_t i = begin; i + 1 < o.path.size(); ++i) table = &table_in(*table, o.path[i], o);
  assign(*table, o.path.back(), o);
}

/// Whether a key of a robot is a table: options, or its link.
bool is_table_key(std::string_view key) { return is_options_key(key) || key == "link"; }

/// options.KEY or link.KEY, from part `begin` of the path on; the reader of that table checks the key.
void assign_option(toml::table& robot, const Assignment& o, std::size_t begin) {
  if (o.path.size() - begin != 2) throw SetupError(fmt::format("{}: write {}.KEY", o.where, o.path[begin]));
  assign(table_in(robot, o.path[begin], o), o.path.back(), o);
}

/// Whether the path ends with the index of a number in a list: command.0.
bool is_element(const Assignment& o, std::size_t begin) {
  const std::string& place = o.path.back();
  const bool is_digit = place.size() == 1 && place.front() >= '0' && place.front() <= '9';
  const auto keys = keys_of("robots");
  return o.path.size() - begin == 2 && is_digit && std::ranges::find(keys, o.path[begin]) != keys.end();
}

/// Sets one number of an existing list.
void assign_element(toml::table& robot, const Assignment& o, std::size_t begin) {
  toml::array* list = robot[o.path[begin]].as_array();
  MUROSIMF_ASSERT(o.path.back().size() == 1);
  const std::size_t place = static_cast<std::size_t>(o.path.back().front() - '0');
  if (!list || place >= list->size()) {
    throw SetupError(
        fmt::format("{}: there is no list '{}' with so many numbers; set all of it", o.where, o.path[begin]));
  }
  toml::table value = o.parsed();
  list->replace(list->cbegin() + static_cast<std::ptrdiff_t>(place), std::move(*value.get("value")));
}

/// Names of bodies that are entities, which static ones are not.
std::vector<std::string> moving_names(const std::vector<toml::table*>& bodies, const Assignment& o) {
  std::vector<std::string> names;
  for (const toml::table* body : bodies) {
    if (!(*body)["static"].value_or(false)) names.push_back(text_of(*body, "name"));
  }
  if (names.empty())
    throw SetupError(fmt::format("{}: '{}' stands there for good; only its keys change", o.where, o.path[0]));
  return names;
}

/// As it is called in reports: without a name by its class.
std::string algorithm_name(const toml::table& algorithm) {
  const std::string name = text_of(algorithm, "name"), target = text_of(algorithm, "class");
  return name.empty() ? target.substr(target.rfind(':') + 1) : name;
}

toml::table& algorithm_called(toml::table& scene, const Assignment& o) {
  std::vector<std::string> names;
  if (toml::array* all = scene["algorithms"].as_array()) {
    for (toml::node& node : *all) {
      toml::table* const algorithm = node.as_table();
      if (!algorithm) continue;
      names.push_back(algorithm_name(*algorithm));
      if (names.back() == o.path[1]) return *algorithm;
    }
  }
  if (names.empty()) throw SetupError(fmt::format("{}: the scene has no [[algorithms]]", o.where));
  throw SetupError(fmt::format("{}: {}", o.where, unknown_name("algorithm", o.path[1], {names.begin(), names.end()})));
}

/// algorithms.NAME.KEY, algorithms.NAME.options.KEY and algorithms.NAME.noise.OUTPUT; a key that is none of all algorithms is an option of
/// the class, which checks it.
void assign_algorithm(toml::table& scene, const Assignment& o) {
  toml::table& algorithm = algorithm_called(scene, o);
  const auto keys = keys_of("algorithms");
  if (o.path.size() == 4 && (o.path[2] == "options" || o.path[2] == "noise")) return assign_option(algorithm, o, 2);
  if (o.path.size() != 3) throw SetupError(fmt::format("{}: write algorithms.NAME.KEY", o.where));
  const bool is_own = std::ranges::find(keys, o.path[2]) != keys.end();
  assign(is_own ? algorithm : table_in(algorithm, "options", o), o.path[2], o);
}

/// The nearest known name is part of the error, at the level of the path at which it is unknown.
[[noreturn]] void refuse_unknown(const toml::table& scene, const Assignment& o) {
  const std::vector<std::string> names = entity_names(scene);
  std::vector<std::string_view> candidates(names.begin(), names.end());
  if (o.path.size() == 1) candidates = keys_of("");
  throw SetupError(
      fmt::format("{}: {}", o.where,
                  unknown_name(o.path.size() == 1 ? "setting" : "entity or table", o.path[0], candidates)));
}

}  // namespace

void apply_override(toml::table& scene, const std::string& override_text, std::vector<PropertySetting>& settings) {
  const Assignment o = split_assignment(override_text, fmt::format("--set '{}'", override_text));
  const auto [robots, used] = robots_of(scene, o.path);
  const std::size_t rest = o.path.size() - used;
  const auto names = [&found = robots] {
    std::vector<std::string> result;
    for (const toml::table* robot : found) result.push_back(text_of(*robot, "name"));
    return result;
  };
  if (!robots.empty() && rest == 1 && is_of_joints(o.path.back())) {
    settings.push_back(property_setting(o, used, names()));
  } else if (!robots.empty() && rest == 1) {
    check_key(o, o.path.back(), keys_of("robots"));
    for (toml::table* robot : robots) assign(*robot, o.path.back(), o);
  } else if (!robots.empty() && is_element(o, used)) {
    for (toml::table* robot : robots) assign_element(*robot, o, used);
  } else if (!robots.empty() && rest >= 2 && o.path[used] == "sensors") {
    for (toml::table* robot : robots) assign_sensor(*robot, o, used);
  } else if (!robots.empty() && rest >= 2 && is_table_key(o.path[used])) {
    for (toml::table* robot : robots) assign_option(*robot, o, used);
  } else if (!robots.empty() && rest >= 2) {
    settings.push_back(property_setting(o, used, names()));
  } else if (const auto bodies = bodies_called(scene, o.path[0]); !bodies.empty() && o.path.size() == 2) {
    check_key(o, o.path[1], keys_of("bodies"));
    for (toml::table* body : bodies) assign(*body, o.path[1], o);
  } else if (!bodies.empty() && o.path.size() >= 3) {
    settings.push_back(property_setting(o, 1, moving_names(bodies, o)));
  } else if (o.path.size() == 1) {
    check_key(o, o.path[0], keys_of(""));
    assign(scene, o.path[0], o);
  } else if (const auto keys = keys_of_one(o.path[0]); !keys.empty() && o.path.size() == 2) {
    check_key(o, o.path[1], keys);
    if (!scene.contains(o.path[0])) scene.insert(o.path[0], toml::table{});
    if (toml::table* table = scene[o.path[0]].as_table()) assign(*table, o.path[1], o);
  } else if (o.path.size() >= 3 && o.path[0] == "defaults" && o.path[1] == "sensors") {
    assign_sensor(table_in(scene, "defaults", o), o, 1);
  } else if (o.path.size() >= 3 && o.path[0] == "defaults" && is_table_key(o.path[1])) {
    assign_option(table_in(scene, "defaults", o), o, 1);
  } else if (o.path.size() >= 3 && o.path[0] == "algorithms") {
    assign_algorithm(scene, o);
  } else if (o.path.size() == 2 && o.path[0] == "body_contact_options") {
    assign_option(scene, o, 0);
  } else if (o.path.size() >= 3 && o.path[0] == "ball" && scene.contains("ball")) {
    settings.push_back(property_setting(o, 1, {"ball"}));
  } else {
    refuse_unknown(scene, o);
  }
}

}  // namespace murosimf::scene_file
