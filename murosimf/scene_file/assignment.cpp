#include "murosimf/scene_file/assignment.h"

#include <fnmatch.h>

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/files/toml_bounds.h"
#include "murosimf/files/toml_reader.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::scene_file {
namespace {

bool matches(const std::string& pattern, const std::string& name) {
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

std::string trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return std::string(text.substr(begin, text.find_last_not_of(" \t") + 1 - begin));
}

/// Entries of other types are left out: the reader of robots refuses them.
std::vector<toml::table*> all_robots(toml::table& scene) {
  std::vector<toml::table*> robots;
  if (toml::array* all = scene["robots"].as_array()) {
    for (toml::node& node : *all) {
      if (node.is_table()) robots.push_back(node.as_table());
    }
  }
  return robots;
}

}  // namespace

toml::table Assignment::parsed() const {
  files::check_toml_bounds(value, where);
  try {
    return toml::parse("value = " + value, where);
  } catch (const toml::parse_error&) {
    // a bare word is no TOML: inserted as a value, so that quotes in it need no escapes
    toml::table table = toml::parse("value = \"\"", where);
    table.get("value")->as_string()->get() = value;
    return table;
  }
}

std::string Assignment::object(std::size_t begin) const {
  MUROSIMF_ASSERT(begin < path.size());
  return fmt::format("{}", fmt::join(path.begin() + static_cast<std::ptrdiff_t>(begin), path.end() - 1, "."));
}

/// Only the first '=' separates: the value may contain others.
Assignment split_assignment(std::string_view text, std::string where) {
  Assignment assignment{std::move(where), {}, {}};
  const auto equals = text.find('=');
  const std::string left = trimmed(text.substr(0, equals));
  if (equals != std::string_view::npos) assignment.value = trimmed(text.substr(equals + 1));
  if (left.empty() || assignment.value.empty()) {
    throw SetupError(
        fmt::format("{}: write PATH=VALUE, for example 'blue.*.level=simplified_dynamics'", assignment.where));
  }
  std::string part;
  for (const char c : left + ".") {  // the last part ends with a dot, too
    if (c != '.') {
      part += c;
    } else if (part.empty()) {
      throw SetupError(fmt::format("{}: the path has an empty part", assignment.where));
    } else {
      assignment.path.push_back(std::exchange(part, {}));
    }
  }
  MUROSIMF_ASSERT(!assignment.path.empty());
  return assignment;
}

std::string text_of(const toml::table& table, std::string_view key) { return table[key].value_or(std::string{}); }

std::pair<std::vector<toml::table*>, std::size_t> robots_of(toml::table& scene, const std::vector<std::string>& path) {
  MUROSIMF_ASSERT(!path.empty());
  const toml::table* defaults = scene["defaults"].as_table();
  const std::string usual_team = defaults ? text_of(*defaults, "team") : "";
  const std::vector<toml::table*> robots = all_robots(scene);
  std::vector<toml::table*> found;
  std::copy_if(robots.begin(), robots.end(), std::back_inserter(found),
               [&](const toml::table* r) { return matches(path[0], text_of(*r, "name")); });
  // an entity's own name takes precedence over a team
  if (!found.empty() || path.size() < 2) return {found, 1};
  std::copy_if(robots.begin(), robots.end(), std::back_inserter(found), [&](const toml::table* r) {
    const std::string name = text_of(*r, "name");
    const std::string team = r->contains("team") ? text_of(*r, "team") : usual_team;
    return matches(path[0], team) && (matches(path[1], name) || team + path[1] == name);
  });
  return {found, 2};
}

std::vector<std::string> entity_names(const toml::table& scene) {
  std::vector<std::string> names;
  if (const toml::array* all = scene["robots"].as_array()) {
    for (const toml::node& node : *all) {
      if (const toml::table* robot = node.as_table()) names.push_back(text_of(*robot, "name"));
    }
  }
  if (const toml::array* all = scene["bodies"].as_array()) {
    for (const toml::node& node : *all) {
      if (const toml::table* body = node.as_table()) names.push_back(text_of(*body, "name"));
    }
  }
  if (scene.contains("ball")) names.emplace_back("ball");
  return names;
}

void check_key(const Assignment& assignment, std::string_view key, const std::vector<std::string_view>& known) {
  if (std::find(known.begin(), known.end(), key) != known.end()) return;
  throw SetupError(fmt::format("{}: {}", assignment.where, unknown_name("setting", key, known)));
}

/// A table names its parts, so that their order does not matter.
std::vector<double> named_force(const toml::table& table) {
  std::vector<double> numbers(6, 0.0);
  for (const auto& [key, node] : table) {
    const bool force = key.str() == "force";
    if (!force && key.str() != "moment") {
      throw SetupError(unknown_name("part of a force", key.str(), {"force", "moment"}));
    }
    const auto three = node.is_array() ? files::numbers_of(node) : std::nullopt;
    if (!three || three->size() != 3) {
      throw SetupError(fmt::format("{} must be three numbers in brackets, in world axes", key.str()));
    }
    std::copy(three->begin(), three->end(), numbers.begin() + (force ? 0 : 3));
  }
  MUROSIMF_ASSERT(numbers.size() == 6);
  return numbers;
}

PropertySetting property_setting(const Assignment& assignment, std::size_t begin, std::vector<std::string> entities) {
  const toml::table value = assignment.parsed();
  const toml::node& node = *value.get("value");
  const auto numbers = node.is_table() ? with_context(assignment.where, [&] { return named_force(*node.as_table()); })
                                       : files::numbers_of(node);
  if (!numbers) {
    throw SetupError(fmt::format("{}: the value must be a number or numbers in brackets", assignment.where));
  }
  return {assignment.where, std::move(entities), assignment.object(begin), assignment.path.back(), *numbers};
}

std::vector<toml::table*> bodies_called(toml::table& scene, const std::string& pattern) {
  std::vector<toml::table*> found;
  toml::array* all = scene["bodies"].as_array();
  for (std::size_t i = 0; all && i < all->size(); ++i) {
    toml::table* body = (*all)[i].as_table();
    const std::string name = body ? (*body)["name"].value_or(std::string{}) : std::string{};
    if (!name.empty() && matches(pattern, name)) found.push_back(body);
  }
  return found;
}

}  // namespace murosimf::scene_file
