#include "murosimf/scene_file/remote_override.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "murosimf/catalog/built_in_controllers.h"
#include "murosimf/files/data_path.h"
#include "murosimf/files/toml_reader.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot/motion_file.h"
#include "murosimf/scene_file/assignment.h"
#include "murosimf/scene_file/key_list.h"
#include "murosimf/scene_file/setting_targets.h"

namespace murosimf::scene_file {
namespace {

enum class Value {
  number,      ///< or a boolean, or a list of them
  word,        ///< or a number
  controller,  ///< one that starts no software from elsewhere
  model,       ///< file
  motion,      ///< likewise
};

struct Allowed {
  std::string_view key;
  Value value = Value::number;
};

constexpr std::array of_scene{Allowed{"duration"}, Allowed{"seed"}, Allowed{"rate", Value::word}, Allowed{"gravity"},
                              Allowed{"body_contact", Value::word}};
constexpr std::array of_start{Allowed{"jitter_position"}, Allowed{"jitter_heading_deg"}, Allowed{"jitter_tilt_deg"},
                              Allowed{"jitter_posture_deg"}};
constexpr std::array of_air{Allowed{"density"}, Allowed{"wind"}};
constexpr std::array of_field{Allowed{"size", Value::word},
                              Allowed{"surface", Value::word},
                              Allowed{"friction_direction"},
                              Allowed{"goals"},
                              Allowed{"nets"},
                              Allowed{"landmark_poles"},
                              Allowed{"friction"}};
constexpr std::array of_view{Allowed{"center"}, Allowed{"width"}, Allowed{"azimuth_deg"}, Allowed{"elevation_deg"}};
constexpr std::array of_light{Allowed{"name", Value::word}, Allowed{"toward"}, Allowed{"brightness"},
                              Allowed{"shadows"}, Allowed{"samples"}};
constexpr std::array of_ball{Allowed{"position"}, Allowed{"velocity"}, Allowed{"radius"},
                             Allowed{"mass"},     Allowed{"hollow"},   Allowed{"material", Value::word},
                             Allowed{"drag"},     Allowed{"lift"},     Allowed{"contact", Value::word},
                             Allowed{"color"},    Allowed{"present"}};
constexpr std::array of_communication{
    Allowed{"range"},         Allowed{"bandwidth"},          Allowed{"delay"}, Allowed{"jitter"}, Allowed{"loss"},
    Allowed{"message_bytes"}, Allowed{"messages_per_second"}};
constexpr std::array of_robots{Allowed{"team", Value::word},
                               Allowed{"model", Value::model},
                               Allowed{"level", Value::word},
                               Allowed{"contact", Value::word},
                               Allowed{"controller", Value::controller},
                               Allowed{"rate"},
                               Allowed{"control_rate"},
                               Allowed{"servo_law", Value::word},
                               Allowed{"motion", Value::motion},
                               Allowed{"command"},
                               Allowed{"position"},
                               Allowed{"heading_deg"},
                               Allowed{"roll_deg"},
                               Allowed{"pitch_deg"},
                               Allowed{"present"},
                               Allowed{"joint_reference", Value::word},
                               Allowed{"integrator", Value::word},
                               Allowed{"base_rigid"},
                               Allowed{"fixed_base"},
                               Allowed{"volume", Value::word},
                               Allowed{"self_collision"},
                               Allowed{"accelerations"},
                               Allowed{"sensors"}};
/// In addition to those that robots also have.
constexpr std::array of_bodies{Allowed{"shape", Value::word},
                               Allowed{"size"},
                               Allowed{"radius"},
                               Allowed{"length"},
                               Allowed{"height_scale"},
                               Allowed{"scale"},
                               Allowed{"thickness"},
                               Allowed{"mass"},
                               Allowed{"density"},
                               Allowed{"material", Value::word},
                               Allowed{"drag"},
                               Allowed{"lift"},
                               Allowed{"color"},
                               Allowed{"static"},
                               Allowed{"jitter"},
                               Allowed{"velocity"},
                               Allowed{"angular_velocity"}};
constexpr std::size_t longest_text = 2000;  // [byte] of an override
constexpr std::size_t longest_word = 64;    // [byte]

using List = std::span<const Allowed>;

const Allowed* find_in(List list, std::string_view key) {
  const auto found = std::ranges::find(list, key, &Allowed::key);
  return found == list.end() ? nullptr : &*found;
}

constexpr Allowed numbers{};

/// Keys of a robot or a body; values for all its joints.
const Allowed* find_of_entities(std::string_view key) {
  if (const Allowed* of_robot = find_in(of_robots, key)) return of_robot;
  return is_of_joints(key) ? &numbers : find_in(of_bodies, key);
}

/// SECTION.KEY; where the first part is no section: ENTITY.KEY.
const Allowed* find_in_section(std::string_view section, std::string_view key) {
  if (section == "start") return find_in(of_start, key);
  if (section == "air") return find_in(of_air, key);
  if (section == "field") return find_in(of_field, key);
  if (section == "view") return find_in(of_view, key);
  if (section == "light") return find_in(of_light, key);
  if (section == "ball") return find_in(of_ball, key);
  if (section == "communication") return find_in(of_communication, key);
  if (section == "defaults") return find_in(of_robots, key);
  if (section == "materials" || section == "body_contact_options") return &numbers;
  return find_section(section) ? nullptr : find_of_entities(key);
}

/// Longer paths: TEAM.ROBOT.KEY, a table of a robot, materials, or a property, which is numeric.
const Allowed* find_below(const std::vector<std::string>& path) {
  const auto keys = names_of(*find_section("robots"));
  const bool of_robot = path.size() == 3 && std::ranges::find(keys, path.back()) != keys.end();
  return of_robot ? find_in(of_robots, path.back()) : &numbers;
}

const Allowed* find_allowed(const std::vector<std::string>& path) {
  MUROSIMF_ASSERT(!path.empty());
  if (path.size() == 1) return find_in(of_scene, path[0]);
  return path.size() == 2 ? find_in_section(path[0], path[1]) : find_below(path);
}

bool is_numbers(const toml::node& value) {
  if (value.is_number() || value.is_boolean()) return true;
  const toml::array* list = value.as_array();
  return list && std::ranges::all_of(*list, [](const toml::node& one) { return one.is_number() || one.is_boolean(); });
}

bool is_word(std::string_view text) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !text.empty() && text.size() <= longest_word && std::ranges::all_of(text, fits);
}

/// Built-in ones by name; others come from plug-ins that were loaded on the command line.
bool may_control(std::string_view name) {
  constexpr std::array<std::string_view, 10> harmless{"none",      "walk",           "trot",  "balance",
                                                      "keyframes", "trajectory",     "drive", "ball_chaser",
                                                      "localize",  "obstacle_course"};
  if (std::ranges::find(harmless, name) != harmless.end()) return true;
  const auto built_in = catalog::built_in_controllers();
  return is_word(name) && std::ranges::find(built_in, name, &catalog::ControllerType::name) == built_in.end();
}

/// Texts could name files: only those that the key needs are accepted.
void check_text(Value kind, const std::string& text, const std::filesystem::path& folder) {
  switch (kind) {
    case Value::number: throw SetupError("takes numbers, true or false here, no texts");
    case Value::word:
      if (!is_word(text)) throw SetupError("takes one name here: letters, digits, _ and -");
      return;
    case Value::controller:
      if (!may_control(text)) throw SetupError("software of one's own is chosen on the command line only");
      return;
    case Value::model: (void)files::find_data_file(text, "models", ".xml", folder); return;
    case Value::motion: (void)robot::find_motion(text, folder); return;
  }
}

/// Numbers are harmless; everything else depends on the key.
void check_value(const Assignment& assignment, Value kind, const std::filesystem::path& folder) {
  const toml::table parsed = assignment.parsed();
  const toml::node& value = *parsed.get("value");
  if (const auto* text = value.as_string()) return check_text(kind, text->get(), folder);
  if (!is_numbers(value)) throw SetupError("takes numbers or a name here, no tables");
  const bool of_file = kind == Value::model || kind == Value::motion || kind == Value::controller;
  if (of_file) throw SetupError("takes a name here");
}

}  // namespace

void check_remote_override(const std::string& override_text, const std::filesystem::path& folder) {
  if (override_text.size() > longest_text) {
    throw SetupError(fmt::format("an override has more than {} bytes", longest_text));
  }
  // a line end would start another entry where the text is logged or written to a file
  if (files::one_line(override_text) != override_text) throw SetupError("an override has more than one line");
  const std::string where = fmt::format("'{}'", override_text);
  const Assignment assignment = split_assignment(override_text, where);
  const Allowed* allowed = find_allowed(assignment.path);
  if (!allowed) {
    throw SetupError(fmt::format("{}: '{}' is not among the settings that may come over a network (docs/supervise.md)",
                                 where, assignment.path.back()));
  }
  with_context(where, [&] { check_value(assignment, allowed->value, folder); });
}

}  // namespace murosimf::scene_file
