#include "murosimf/scene_file/unused_settings.h"

#include <algorithm>
#include <array>
#include <set>
#include <variant>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"

namespace murosimf::scene_file {
namespace {

/// A key of a robot that only some levels or controllers use.
struct UsedKey {
  std::string_view key;   ///< name in the file
  std::string_view word;  ///< name in the catalog
  enum { by_level, by_first_level, by_controller } use = by_level;
  bool (*says)(const RobotSpec&) = nullptr;  ///< whether it was set to a value with an effect; null: always
};

bool asks_for_height(const RobotSpec& robot) { return robot.position.z != 0; }
bool asks_for_roll(const RobotSpec& robot) { return robot.roll != 0; }
bool asks_for_pitch(const RobotSpec& robot) { return robot.pitch != 0; }
bool asks_for_servo_law(const RobotSpec& robot) { return !robot.servo_law.empty(); }
bool asks_for_motion(const RobotSpec& robot) { return !robot.motion.empty(); }
bool asks_for_command(const RobotSpec& robot) { return !is_zero(robot.command); }

constexpr std::array used_keys{
    UsedKey{"contact", "contact"},
    UsedKey{"contact_options", "contact"},
    UsedKey{"integrator", "integrator"},
    UsedKey{"joint_reference", "joint_reference"},
    UsedKey{"servo_law", "servo_law", UsedKey::by_level, asks_for_servo_law},
    UsedKey{"base_rigid", "base_rigid", UsedKey::by_level, [](const RobotSpec& r) { return r.base_rigid; }},
    UsedKey{"fixed_base", "fixed_base", UsedKey::by_level, [](const RobotSpec& r) { return r.fixed_base; }},
    UsedKey{"self_collision", "self_collision", UsedKey::by_level,
            [](const RobotSpec& r) { return r.collision.self_collision; }},
    UsedKey{"position", "position.z", UsedKey::by_first_level, asks_for_height},
    UsedKey{"roll_deg", "roll_deg", UsedKey::by_first_level, asks_for_roll},
    UsedKey{"pitch_deg", "pitch_deg", UsedKey::by_first_level, asks_for_pitch},
    UsedKey{"command", "command", UsedKey::by_controller, asks_for_command},
    UsedKey{"motion", "motion", UsedKey::by_controller, asks_for_motion},
    UsedKey{"library", "library", UsedKey::by_controller, [](const RobotSpec& r) { return !r.library.empty(); }},
    UsedKey{"call_budget", "call_budget", UsedKey::by_controller,
            [](const RobotSpec& r) { return r.call_budget != 0; }},
    UsedKey{"link", "link", UsedKey::by_controller, [](const RobotSpec& r) { return r.link.does_something(); }},
    UsedKey{"reload", "library", UsedKey::by_controller, [](const RobotSpec& r) { return r.reload; }},
};

bool is_for(const SceneEvent& event, const RobotSpec& robot) {
  return std::ranges::find(event.entities, robot.name) != event.entities.end();
}

bool any_uses(const std::vector<const catalog::LevelType*>& levels, std::string_view word) {
  return std::ranges::any_of(levels,
                             [&](const catalog::LevelType* level) { return catalog::has_word(level->keys, word); });
}

const catalog::LevelType& first_level(const RobotSpec& robot) {
  return find_entry(catalog::levels(), "level", robot.level);
}

bool is_used(const SceneSpec& spec, const RobotSpec& robot, const UsedKey& key) {
  if (key.use == UsedKey::by_level) return any_uses(levels_from(spec, robot, 0), key.word);
  // what stands on the field may be at that height
  if (key.word == "position.z" && std::ranges::any_of(spec.bodies, &BodySpec::is_static)) return true;
  if (key.use == UsedKey::by_first_level) return catalog::has_word(first_level(robot).keys, key.word);
  return catalog::has_word(catalog::controllers().find(robot.controller).keys, key.word);
}

std::string line_about(const RobotSpec& robot, const UsedKey& key) {
  const std::string_view part = key.word == "position.z" ? "z of " : "";
  const std::string user =
      key.use == UsedKey::by_controller ? fmt::format("controller '{}'", robot.controller) : robot.level;
  return fmt::format("{}: {} has no {}'{}'; it changes nothing", robot.name, user, part, key.key);
}

/// Of robots by name; of [defaults] once, and only if no robot uses them.
void add_keys(const SceneSpec& spec, const UsedKey& key, std::vector<std::string>& lines) {
  std::vector<const RobotSpec*> by_default;
  bool default_helps = false;
  for (const RobotSpec& robot : spec.robots) {
    const auto given = robot.given.find(std::string(key.key));
    if (given == robot.given.end() || (key.says && !key.says(robot))) continue;
    const bool used = is_used(spec, robot, key);
    if (given->second.by_default) {
      by_default.push_back(&robot);
      default_helps = default_helps || used;
    } else if (!used) {
      lines.push_back(line_about(robot, key));
    }
  }
  if (default_helps || by_default.empty()) return;
  lines.push_back(fmt::format("defaults: no robot uses '{}' ({})", key.key, line_about(*by_default.front(), key)));
}

/// Laws that an event sets for a robot whose levels have none from then on.
void add_events(const SceneSpec& spec, std::vector<std::string>& lines) {
  for (const SceneEvent& event : spec.events) {
    if (event.key != "contact" && event.key != "servo_law") continue;
    if (event.setting) continue;
    for (const RobotSpec& robot : spec.robots) {
      if (!is_for(event, robot)) continue;
      const auto present = levels_from(spec, robot, event.time);
      if (any_uses(present, event.key)) continue;
      lines.push_back(fmt::format("{}: {} has no '{}' at {:.3f} s; it changes nothing ({})", robot.name,
                                  present.front()->name, event.key, event.time, event.where));
    }
  }
}

/// Whether an entry of a registry, used by an algorithm of a robot from some time on, has an option.
bool any_has(const auto& entries, std::string_view option) {
  return std::ranges::any_of(entries,
                             [&](const auto* entry) { return find_option(entry->options, option) != nullptr; });
}

/// Also the laws that events set: an option may be for one of them.
std::vector<const catalog::ContactLawType*> laws_of(const SceneSpec& spec, const RobotSpec& robot) {
  std::vector<const catalog::ContactLawType*> found{&catalog::contacts().find(robot.contact)};
  for (const SceneEvent& event : spec.events) {
    if (event.key != "contact" || event.setting || !is_for(event, robot)) continue;
    found.push_back(&catalog::contacts().find(event.value));
  }
  return found;
}

/// Options that only other levels or laws have; not those of [defaults], which are for other robots.
void add_options(const RobotSpec& robot, const std::string& key, const OptionValues& values, const auto& entries,
                 std::vector<std::string>& lines) {
  const auto given = robot.given.find(key);
  if (given == robot.given.end() || given->second.by_default) return;
  for (const auto& [name, value] : values) {
    if (any_has(entries, name)) continue;
    lines.push_back(
        fmt::format("{}: {} has no '{}' in '{}'; it changes nothing", robot.name, entries.front()->name, name, key));
  }
}

/// Only if no robot would use it at any level: then the key is a mistake.
void add_start(const SceneSpec& spec, std::vector<std::string>& lines) {
  const auto no_robot = [&](const auto& uses) { return std::ranges::none_of(spec.robots, uses); };
  if (spec.jitter_tilt != 0 &&
      no_robot([](const auto& r) { return catalog::has_word(first_level(r).keys, "roll_deg"); })) {
    lines.emplace_back("start: no robot begins at a level that 'jitter_tilt_deg' could lean; it changes nothing");
  }
  const auto keeps_posture = [](const RobotSpec& robot) {
    return catalog::has_word(catalog::controllers().find(robot.controller).keys, "posture");
  };
  if (spec.jitter_posture != 0 && no_robot(keeps_posture)) {
    lines.emplace_back("start: controllers set the joints of all robots; 'jitter_posture_deg' changes nothing");
  }
}

/// [air] without any effect.
void add_air(const SceneSpec& spec, std::vector<std::string>& lines) {
  const AirSpec usual;
  const bool windy = !is_zero(spec.air.wind);
  if (windy && spec.air.density == 0) lines.emplace_back("air: 'wind' changes nothing without 'density'");
  if (!windy && spec.air.density == usual.density) return;
  const auto flies = [](const BodySpec& body) {
    return !body.is_static && body.shape && std::holds_alternative<Sphere>(*body.shape);
  };
  if (spec.ball || std::ranges::any_of(spec.bodies, flies)) return;
  lines.emplace_back("air: only balls and spheres that move feel it, and there are none; [air] changes nothing");
}

}  // namespace

/// The levels that a robot has from this time on, in any order of events.
std::vector<const catalog::LevelType*> levels_from(const SceneSpec& spec, const RobotSpec& robot, double time) {
  std::vector<const catalog::LevelType*> found{&first_level(robot)};
  for (const SceneEvent& event : spec.events) {
    if (event.key != "level" || event.setting || !is_for(event, robot)) continue;
    if (event.time <= time && time > 0) found.clear();
    found.push_back(&find_entry(catalog::levels(), "level", event.value));
  }
  return found;
}

std::vector<std::string> unused_keys(const SceneSpec& spec) {
  std::vector<std::string> lines;
  const bool bodies_stand = std::ranges::all_of(spec.bodies, &BodySpec::is_static);
  if (spec.robots.empty() && !spec.ball && bodies_stand) {
    lines.emplace_back("nothing moves in this scene: it has neither [[robots]] nor a [ball] nor [[bodies]] that move");
  }
  for (const UsedKey& key : used_keys) add_keys(spec, key, lines);
  for (const RobotSpec& robot : spec.robots) {
    add_options(robot, "level_options", robot.level_options, levels_from(spec, robot, 0), lines);
    add_options(robot, "contact_options", robot.contact_options, laws_of(spec, robot), lines);
  }
  add_events(spec, lines);
  add_start(spec, lines);
  add_air(spec, lines);
  return lines;
}

std::vector<std::string> unused_pairs(const SceneSpec& spec, const std::vector<std::string>& used) {
  const MaterialTable standard = MaterialTable::standard();
  std::vector<std::string_view> known = standard.names();
  known.insert(known.end(), used.begin(), used.end());
  std::vector<std::string> lines;
  for (const GivenPair& pair : spec.material_pairs) {
    for (const std::string& name : std::set<std::string>{pair.a, pair.b}) {
      if (std::ranges::find(used, name) != used.end()) continue;
      if (std::ranges::find(known, name) == known.end()) {
        throw SetupError(fmt::format("{}: {}", pair.where, unknown_name("material", name, known)));
      }
      lines.push_back(fmt::format("materials: nothing here is of '{}'; the pair of '{}' and '{}' changes nothing", name,
                                  pair.a, pair.b));
    }
  }
  return lines;
}

std::string unused_friction_direction(const SceneSpec& spec, const std::vector<std::string>& used) {
  if (is_zero(spec.field.friction_direction)) return {};
  Surface ground, body;
  ground.material = spec.field.surface;
  for (const std::string& name : used) {
    body.material = name;
    const PairSurface pair = spec.materials.find(ground, body);
    if (pair.friction_anisotropy > 0 || pair.rolling_anisotropy > 0) return {};
  }
  return fmt::format("field: nothing here feels the pile of '{}'; 'friction_direction' changes nothing",
                     spec.field.surface);
}

}  // namespace murosimf::scene_file
