#include "murosimf/scene_file/event_section.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/dynamics/servo/servo_law.h"
#include "murosimf/files/toml_reader.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/scene_file/all_sections.h"
#include "murosimf/scene_file/assignment.h"
#include "murosimf/scene_file/overrides.h"
#include "murosimf/scene_file/push_section.h"
#include "murosimf/scene_file/section_change.h"
#include "murosimf/scene_file/setting_targets.h"

namespace murosimf::scene_file {
namespace {

constexpr double farthest_new_place = 1e5;  // [m]

void check_time(double time, const std::string& where) {
  if (std::isfinite(time) && time >= 0 && time <= longest_duration) return;
  throw SetupError(fmt::format("{}: the time must be a number of seconds, at least 0", where));
}

/// Checks that the named level, law or value exists.
void check_value(const SceneEvent& event) {
  with_context(event.where, [&] {
    if (event.key == "level") (void)find_entry(catalog::levels(), "level", event.value);
    if (event.key == "contact") (void)find_entry(catalog::contacts(), "contact law", event.value);
    if (event.key == "servo_law") (void)find_entry(dynamics::servo_laws(), "servo law", event.value);
    if (event.key == "present" && event.value != "true" && event.value != "false") {
      throw SetupError(fmt::format("present is true or false, not '{}'", event.value));
    }
  });
}

bool is_of_ball(const Assignment& change) {
  const auto& keys = changeable_ball_keys();
  return change.path[0] == "ball" && change.path.size() == 2 &&
         std::find(keys.begin(), keys.end(), change.path[1]) != keys.end();
}

/// A key of [light], or one of [ball] that replaces the ball.
SceneEvent section_event(const Assignment& change, double time) {
  if (change.path.size() != 2) throw SetupError(fmt::format("{}: write {}.KEY=VALUE", change.where, change.path[0]));
  SceneEvent event{time, change.where, {}, change.path[1], change.value, {}, change.path[0]};
  change.path[0] == "light" ? void(changed(LightSpec{}, event)) : void(changed(BallSpec{}, event));
  return event;
}

/// The friction of the field, or a number of pairs of materials, as for --set (material_section.h).
bool is_of_surfaces(const Assignment& change) {
  const auto& path = change.path;
  return (path[0] == "materials" && path.size() > 1) || (path == std::vector<std::string>{"field", "friction"});
}

SceneEvent surface_event(const Assignment& change, double time) {
  const std::string key = fmt::format("{}", fmt::join(change.path.begin() + 1, change.path.end(), "."));
  return {time, change.where, {}, key, change.value, {}, change.path[0]};
}

std::vector<std::string> names_of(const std::vector<toml::table*>& robots) {
  std::vector<std::string> names;
  for (const toml::table* robot : robots) names.push_back(text_of(*robot, "name"));
  return names;
}

/// [x, y], [x, y, z] or [x, y, z, heading].
Placement read_place(const Assignment& change) {
  const std::vector<double> numbers = property_setting(change, 0, {}).numbers;
  const auto reaches = [](double x) { return std::abs(x) <= farthest_new_place; };
  if (numbers.size() < 2 || numbers.size() > 4 || !std::ranges::all_of(numbers, reaches)) {
    throw SetupError(fmt::format("{}: write [x, y], [x, y, z] (m) or [x, y, z, heading] (rad), at most {} each",
                                 change.where, farthest_new_place));
  }
  Placement place{.position = {numbers[0], numbers[1], 0}};
  if (numbers.size() > 2) place.position.z = numbers[2];
  if (numbers.size() > 3) place.heading = numbers[3];
  return place;
}

/// DIRECTION, [DIRECTION, SIDE] or [DIRECTION, SIDE, X, Y].
locomotion::KickRequest read_kick(const Assignment& change) {
  constexpr double farthest = 10;  // [m]
  std::vector<double> numbers = property_setting(change, 0, {}).numbers;
  const std::size_t count = numbers.size();
  numbers.resize(4);
  const auto reaches = [](double x) { return std::abs(x) <= farthest; };
  if ((count != 1 && count != 2 && count != 4) || !(std::abs(numbers[0]) <= pi) ||
      !std::ranges::all_of(numbers, reaches)) {
    throw SetupError(
        fmt::format("{}: write DIRECTION, [DIRECTION, SIDE] or [DIRECTION, SIDE, X, Y]: rad, from -pi to pi; "
                    "above 0 with the left foot, below 0 with the right one; m, where the ball lies",
                    change.where));
  }
  return {.direction = numbers[0], .side = numbers[1], .ball_x = numbers[2], .ball_y = numbers[3]};
}

/// Keys of the ball.
const std::vector<std::string_view>& ball_keys() {
  static const std::vector<std::string_view> keys = [] {
    std::vector<std::string_view> all = changeable_ball_keys();
    all.insert(all.end(), {"contact", "present", "place"});
    return all;
  }();
  return keys;
}

}  // namespace

/// A push has more parts than one value, so it is read apart from other changes.
SceneEvent read_event(toml::table& scene, double time, const std::string& text, const std::string& where) {
  check_time(time, where);
  const Assignment change = split_assignment(text, where);
  if (change.path.size() > 1 && change.path.back() == "push") {
    PushSpec push = read_push_change(scene, change);
    std::vector<std::string> pushed = push.entities;
    return {time, where, std::move(pushed), "push", change.value, {}, {}, std::move(push)};
  }
  auto [robots, used] = robots_of(scene, change.path);
  std::vector<std::string> entities = names_of(robots);
  if (entities.empty() && is_of_surfaces(change)) return surface_event(change, time);
  if (entities.empty() && change.path[0] == "ball" && scene.contains("ball")) {
    entities = {"ball"};
    used = 1;
  }
  const auto bodies = bodies_called(scene, change.path[0]);
  const bool of_light = change.path[0] == "light" && entities.empty() && bodies.empty();
  if (of_light || (entities == std::vector<std::string>{"ball"} && is_of_ball(change)))
    return section_event(change, time);
  if (entities.empty() && !bodies.empty()) {
    entities = names_of(bodies);
    used = 1;
    const std::string& key = change.path.back();
    const bool property = change.path.size() > 2 || key == "contact" || key == "present" || key == "place";
    if (!property)
      throw SetupError(
          fmt::format("{}: a body has no '{}' that could change while it runs; "
                      "its contact, its properties, its place and whether it is present can",
                      where, change.path.back()));
  }
  const std::size_t rest = change.path.size() - std::min(change.path.size(), used);
  if (entities.empty() || rest == 0) {
    const auto names = entity_names(scene);
    throw SetupError(
        fmt::format("{}: {}", where, unknown_name("entity", change.path[0], {names.begin(), names.end()})));
  }
  SceneEvent event{time, where, entities, change.path.back(), change.value, {}, {}};
  if (rest > 1 || is_of_joints(event.key)) {
    event.setting = property_setting(change, used, entities);
  } else {
    check_key(change, event.key, change.path[0] == "ball" ? ball_keys() : exchangeable_keys());
    if (event.key == "place") event.place = read_place(change);
    if (event.key == "kick") event.kick = read_kick(change);
    if (event.key == "command") {
      event.setting = property_setting(change, used, entities);
      event.setting->property = properties::walk_command.name;
    }
    check_value(event);
  }
  return event;
}

namespace {

/// One text or a list of texts.
void read_changes(const files::TomlTable& table, std::string_view key, EventTable& event) {
  const toml::node& set = *table.find(key);
  const auto take = [&](const toml::node& text) {
    if (!text.is_string())
      throw SetupError(fmt::format("{}: '{}' must be a text, or a list of texts", table.where(key), key));
    event.changes.push_back(*text.value<std::string>());
  };
  if (const toml::array* list = set.as_array()) {
    for (const toml::node& text : *list) take(text);
  } else {
    take(set);
  }
}

void read_table(toml::table& scene, const toml::table& node, std::vector<SceneEvent>& events) {
  const files::TomlTable table(node, event_section().names());
  if (!table.find("set")) throw SetupError(fmt::format("{}: 'set' of the event is missing", table.where()));
  EventTable event;
  event_section().read(table, event);
  for (const std::string& change : event.changes)
    events.push_back(read_event(scene, event.time, change, table.where("set")));
}

/// TIME:CHANGE, as on the command line.
SceneEvent read_option(toml::table& scene, const std::string& option) {
  const std::string where = fmt::format("--at '{}'", option);
  double time = 0;
  const auto [end, error] = std::from_chars(option.data(), option.data() + option.size(), time);
  if (error != std::errc{} || end == option.data() + option.size() || *end != ':') {
    throw SetupError(
        fmt::format("{}: write TIME:PATH=VALUE, for example '3.5:blue1.level=articulated_dynamics'", where));
  }
  return read_event(scene, time, std::string(end + 1, option.data() + option.size()), where);
}

}  // namespace

const Section<EventTable>& event_section() {
  static const Section<EventTable> section(
      "[[events]]", {{"time", &EventTable::time, "s", "when it happens", {}, "(needed)"},
                     {"set", read_changes, "", "PATH = VALUE, or a list of them: what changes then", {}, "(needed)"}});
  return section;
}

const std::vector<std::string_view>& exchangeable_keys() {
  static const std::vector<std::string_view> keys{"level", "contact", "servo_law", "command",
                                                  "play",  "kick",    "present",   "place"};
  return keys;
}

std::vector<SceneEvent> read_events(toml::table& scene, const std::vector<std::string>& at_options) {
  std::vector<SceneEvent> events;
  for (const toml::table* event : files::TomlTable(scene, scene_section().names()).tables("events"))
    read_table(scene, *event, events);
  for (const std::string& option : at_options) events.push_back(read_option(scene, option));
  // stable: events at equal times happen in their order of definition
  std::stable_sort(events.begin(), events.end(),
                   [](const SceneEvent& a, const SceneEvent& b) { return a.time < b.time; });
  MUROSIMF_ASSERT(std::ranges::is_sorted(events, {}, &SceneEvent::time));
  return events;
}

}  // namespace murosimf::scene_file
