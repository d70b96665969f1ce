#include "murosimf/io/scene_overrides.h"

#include <fnmatch.h>

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/io/toml_reader.h"
#include "murosimf/model/error.h"

namespace murosimf::io {
namespace {

struct Override {
  std::string text;   // as the user wrote it
  std::string where;  // for messages
  std::vector<std::string> path;
  std::string value;
};

bool matches(const std::string& pattern, const std::string& name) {
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

Override split(const std::string& text) {
  Override o{text, fmt::format("--set '{}'", text), {}, {}};
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
    throw SetupError(fmt::format("{}: write PATH=VALUE, for example 'blue.*.level=simplified_dynamics'", o.where));
  }
  o.value = text.substr(equals + 1);
  std::string part;
  for (const char c : text.substr(0, equals) + ".") {
    if (c != '.') {
      part += c;
    } else if (part.empty()) {
      throw SetupError(fmt::format("{}: the path has an empty part", o.where));
    } else {
      o.path.push_back(std::exchange(part, {}));
    }
  }
  return o;
}

/// The value as TOML; a bare word is a text. Parsed anew for every target, since copies lose their source.
toml::table parsed(const Override& o) {
  try {
    return toml::parse("value = " + o.value, o.where);
  } catch (const toml::parse_error&) {
    toml::table table = toml::parse("value = \"\"", o.where);
    table.get("value")->as_string()->get() = o.value;
    return table;
  }
}

void assign(toml::table& table, const std::string& key, const Override& o) {
  toml::table value = parsed(o);
  table.insert_or_assign(key, std::move(*value.get("value")));
}

std::string text_of(const toml::table& table, std::string_view key) { return table[key].value_or(std::string{}); }

/// Robots that the first parts of the path mean, and how many parts they took: ENTITY or TEAM.ROBOT, with * and ?.
std::pair<std::vector<toml::table*>, std::size_t> robots_of(toml::table& scene, const std::vector<std::string>& path) {
  std::vector<toml::table*> robots;
  if (toml::array* all = scene["robots"].as_array()) {
    for (toml::node& node : *all) {
      if (node.is_table()) robots.push_back(node.as_table());
    }
  }
  std::vector<toml::table*> found;
  std::copy_if(robots.begin(), robots.end(), std::back_inserter(found),
               [&](const toml::table* r) { return matches(path[0], text_of(*r, "name")); });
  if (!found.empty() || path.size() < 2) return {found, 1};
  std::copy_if(robots.begin(), robots.end(), std::back_inserter(found), [&](const toml::table* r) {
    const std::string name = text_of(*r, "name");
    const std::string team = text_of(*r, "team");
    return matches(path[0], team) && (matches(path[1], name) || team + path[1] == name);
  });
  return {found, 2};
}

void check_key(const Override& o, const std::string& key, const std::vector<std::string_view>& known) {
  if (std::find(known.begin(), known.end(), key) == known.end()) {
    throw SetupError(fmt::format("{}: {}", o.where, unknown_name("setting", key, known)));
  }
}

void add_setting(const Override& o, std::vector<std::string> entities, const std::string& object,
                 const std::string& property, std::vector<PropertySetting>& settings) {
  const toml::table value = parsed(o);
  const auto numbers = numbers_of(*value.get("value"));
  if (!numbers) throw SetupError(fmt::format("{}: the value must be a number or numbers in brackets", o.where));
  settings.push_back({o.where, std::move(entities), object, property, *numbers});
}

/// The parts between the entity and the property: names of objects may have dots ("l_foot.offset").
std::string object_of(const Override& o, std::size_t begin) {
  return fmt::format("{}", fmt::join(o.path.begin() + static_cast<std::ptrdiff_t>(begin), o.path.end() - 1, "."));
}

[[noreturn]] void refuse_unknown(const toml::table& scene, const Override& o) {
  std::vector<std::string> names;
  if (const toml::array* all = scene["robots"].as_array()) {
    for (const toml::node& node : *all) {
      if (const toml::table* robot = node.as_table()) names.push_back(text_of(*robot, "name"));
    }
  }
  if (scene.contains("ball")) names.emplace_back("ball");
  std::vector<std::string_view> candidates(names.begin(), names.end());
  if (o.path.size() == 1) candidates = scene_keys();
  throw SetupError(
      fmt::format("{}: {}", o.where,
                  unknown_name(o.path.size() == 1 ? "setting" : "entity or table", o.path[0], candidates)));
}

}  // namespace

const std::vector<std::string_view>& scene_keys() {
  static const std::vector<std::string_view> keys{"name",         "duration", "seed",   "rate",     "gravity",
                                                  "body_contact", "start",    "field",  "view",     "ball",
                                                  "teams",        "defaults", "robots", "materials"};
  return keys;
}

std::vector<std::string_view> table_keys(std::string_view table) {
  if (table == "start") {
    return {"jitter_position", "jitter_heading_deg", "jitter_tilt_deg", "jitter_posture_deg"};
  }
  if (table == "field") return {"size", "surface", "grain", "goals"};
  if (table == "view") return {"center", "width", "azimuth_deg", "elevation_deg"};
  if (table == "ball") return {"position", "velocity", "radius", "mass", "hollow", "material", "contact"};
  if (table == "defaults") {
    auto keys = robot_keys();
    std::erase(keys, "name");
    return keys;
  }
  return {};
}

const std::vector<std::string_view>& robot_keys() {
  static const std::vector<std::string_view> keys{"name",           "team",       "model",      "level",
                                                  "contact",        "controller", "position",   "command",
                                                  "heading_deg",    "roll_deg",   "pitch_deg",  "volume",
                                                  "self_collision", "no_contact", "base_rigid", "joint_reference",
                                                  "integrator",     "fixed_base", "motion"};
  return keys;
}

void apply_override(toml::table& scene, const std::string& override_text, std::vector<PropertySetting>& settings) {
  const Override o = split(override_text);
  const auto [robots, used] = robots_of(scene, o.path);
  const std::size_t rest = o.path.size() - used;
  if (!robots.empty() && rest == 1) {
    check_key(o, o.path.back(), robot_keys());
    for (toml::table* robot : robots) assign(*robot, o.path.back(), o);
  } else if (!robots.empty() && rest >= 2) {
    std::vector<std::string> names;
    for (const toml::table* robot : robots) names.push_back(text_of(*robot, "name"));
    add_setting(o, names, object_of(o, used), o.path.back(), settings);
  } else if (o.path.size() == 1) {
    check_key(o, o.path[0], scene_keys());
    assign(scene, o.path[0], o);
  } else if (const auto keys = table_keys(o.path[0]); !keys.empty() && o.path.size() == 2) {
    check_key(o, o.path[1], keys);
    if (!scene.contains(o.path[0])) scene.insert(o.path[0], toml::table{});
    if (toml::table* table = scene[o.path[0]].as_table()) assign(*table, o.path[1], o);
  } else if (o.path.size() >= 3 && o.path[0] == "ball" && scene.contains("ball")) {
    add_setting(o, {"ball"}, object_of(o, 1), o.path.back(), settings);
  } else {
    refuse_unknown(scene, o);
  }
}

}  // namespace murosimf::io
