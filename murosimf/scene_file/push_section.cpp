#include "murosimf/scene_file/push_section.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/files/toml_reader.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/scene_file/all_sections.h"
#include "murosimf/scene_file/assignment.h"
#include "murosimf/scene_file/overrides.h"

namespace murosimf::scene_file {
namespace {

/// Sets the entities that the path denotes, and their object.
void take_target(toml::table& scene, const std::vector<std::string>& path, PushSpec& push) {
  MUROSIMF_ASSERT(!path.empty());
  auto [tables, used] = robots_of(scene, path);
  if (tables.empty()) tables = bodies_called(scene, path[0]), used = 1;
  for (const toml::table* table : tables) push.entities.push_back(text_of(*table, "name"));
  if (tables.empty() && path[0] == "ball" && scene.contains("ball")) push.entities = {"ball"};
  if (push.entities.empty()) {
    const auto names = entity_names(scene);
    throw SetupError(unknown_name("entity", path[0], {names.begin(), names.end()}));
  }
  MUROSIMF_ASSERT(used <= path.size());
  push.object = fmt::format("{}", fmt::join(path.begin() + static_cast<std::ptrdiff_t>(used), path.end(), "."));
}

/// Values come from files, options and programs: all are checked in the same place.
void check_push(const PushSpec& push) {
  const auto finite = [](const Vec3d& v) { return std::isfinite(v.x + v.y + v.z); };
  if (!finite(push.force) || !finite(push.moment)) throw SetupError("force and moment must be finite numbers");
  const bool times = push.begin >= 0 && push.end <= longest_duration && std::isfinite(push.begin + push.end);
  if (!times) throw SetupError("the times must be numbers of seconds, at least 0");
  if (!(push.begin < push.end)) throw SetupError(fmt::format("it ends at {} s, before it begins", push.end));
  if (norm(push.force) + norm(push.moment) == 0) throw SetupError("neither its force nor its moment is above 0");
}

void take_force(const Assignment& assignment, PushSpec& push) {
  const std::vector<double> numbers = property_setting(assignment, 0, {}).numbers;
  if (numbers.size() != 3 && numbers.size() != 6) {
    throw SetupError("write three numbers (force in N) or six (force in N, moment in N m)");
  }
  push.force = {numbers[0], numbers[1], numbers[2]};
  if (numbers.size() == 6) push.moment = {numbers[3], numbers[4], numbers[5]};
}

double read_second(std::string_view text) {
  double time = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), time);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) {
    throw SetupError(fmt::format("'{}' is no time in seconds", text));
  }
  return time;
}

PushSpec read_push_option(toml::table& scene, const std::string& option) {
  PushSpec push{.where = fmt::format("--push '{}'", option)};
  with_context(push.where, [&] {
    // the last '@': object names may contain one
    const std::size_t time = option.rfind('@'), dots = time == std::string::npos ? time : option.find("..", time);
    if (dots == std::string::npos) {
      throw SetupError("write OBJECT=FORCE@BEGIN..END, for example 'blue1.torso=[60,0,0]@2..2.1'");
    }
    push.begin = read_second(std::string_view(option).substr(time + 1, dots - time - 1));
    push.end = read_second(std::string_view(option).substr(dots + 2));
  });
  const Assignment assignment = split_assignment(option.substr(0, option.rfind('@')), push.where);
  take_force(assignment, push);
  with_context(push.where, [&] {
    take_target(scene, assignment.path, push);
    check_push(push);
  });
  return push;
}

PushSpec read_push_table(toml::table& scene, const toml::table& node) {
  const files::TomlTable table(node, push_section().names());
  PushSpec push{.where = table.where()};
  push_section().read(table, push);
  std::string on;
  table.read("on", on);
  for (const std::string_view key : {"on", "from", "to"}) {
    if (!table.find(key)) throw SetupError(fmt::format("{}: '{}' of the push is missing", push.where, key));
  }
  with_context(push.where, [&] {
    take_target(scene, split_assignment(on + "=0", push.where).path, push);
    check_push(push);
  });
  return push;
}

}  // namespace

PushSpec read_push_change(toml::table& scene, const Assignment& change) {
  PushSpec push{.where = change.where};
  const std::vector<double> numbers = property_setting(change, 0, {}).numbers;
  with_context(change.where, [&] {
    if (numbers.size() != 4 && numbers.size() != 7) {
      throw SetupError(
          "write four numbers (force in N, duration in s) or seven (with a moment in N m after the force)");
    }
    push.force = {numbers[0], numbers[1], numbers[2]};
    if (numbers.size() == 7) push.moment = {numbers[3], numbers[4], numbers[5]};
    push.end = numbers.back();
    take_target(scene, {change.path.begin(), change.path.end() - 1}, push);
    check_push(push);
  });
  return push;
}

const Section<PushSpec>& push_section() {
  static const Section<PushSpec> section("[[pushes]]",
                                         {{"on", {}, "", "ENTITY or ENTITY.BODY, with * and ?", {}, "(needed)"},
                                          {"force", &PushSpec::force, "N", "world, at the center of mass of the body"},
                                          {"moment", &PushSpec::moment, "N m", "world"},
                                          {"from", &PushSpec::begin, "s", "its first instant", {}, "(needed)"},
                                          {"to", &PushSpec::end, "s", "its end", {}, "(needed)"}});
  return section;
}

/// Pushes of the file come before those of the command line.
std::vector<PushSpec> read_pushes(toml::table& scene, const std::vector<std::string>& push_options) {
  std::vector<PushSpec> pushes;
  for (const toml::table* node : files::TomlTable(scene, scene_section().names()).tables("pushes")) {
    pushes.push_back(read_push_table(scene, *node));
  }
  for (const std::string& option : push_options) pushes.push_back(read_push_option(scene, option));
  return pushes;
}

}  // namespace murosimf::scene_file
