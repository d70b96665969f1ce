// [[teams]], [defaults] and [[robots]] of a scene file.
#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/component_files/sensor_toml.h"
#include "murosimf/dynamics/servo/servo_law.h"
#include "murosimf/files/toml_color.h"
#include "murosimf/scene_file/all_sections.h"
#include "murosimf/scene_file/robot_options.h"
#include "murosimf/scene_file/section_readers.h"

namespace murosimf::scene_file {
namespace {

using files::TomlTable;

void read_integrator(const TomlTable& table, std::string_view key, RobotSpec& robot) {
  std::string name;
  table.read(key, name);
  robot.integrator = with_context(table.where(key),
                                  [&] { return find_entry(dynamics::integrators(), "integrator", name).integrator; });
}

void read_link(const TomlTable& table, std::string_view key, RobotSpec& robot) {
  const toml::table* link = table.table(key);
  link_section().read(*link, robot.link);
}

/// Texts unchanged; numbers and flags in the notation of xacro.
std::string xacro_text(const toml::node& value) {
  if (const auto* text = value.as_string()) return text->get();
  if (const auto* whole = value.as_integer()) return fmt::format("{}", whole->get());
  if (const auto* number = value.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* flag = value.as_boolean()) return flag->get() ? "true" : "false";
  files::fail_at(value.source(), "arguments of xacro are texts, numbers, true or false");
}

void read_xacro(const TomlTable& table, std::string_view key, RobotSpec& robot) {
  for (const auto& [name, value] : *table.table(key)) robot.xacro[std::string(name.str())] = xacro_text(value);
}

void read_attacks(const TomlTable& table, std::string_view key, TeamSpec& team) {
  std::string side;
  table.read(key, side);
  require(side == "right" || side == "left", table, key, "must be \"right\" (the goal at positive x) or \"left\"");
  team.attacks = side == "right" ? 1 : -1;
}

void read_number(const TomlTable& table, std::string_view key, TeamSpec& team) {
  table.read(key, team.number);
  require(team.number >= 1 && team.number <= 254, table, key, "must be from 1 to 254");
}

/// Records where keys are set, for warnings.
void remember_given(const TomlTable& table, RobotSpec& robot) {
  for (const std::string_view key : robot_section().names()) {
    if (table.find(key)) robot.given[std::string(key)] = {table.where(key)};
  }
}

void read_robot(const TomlTable& table, RobotSpec& robot) {
  robot.where = table.where();
  remember_given(table, robot);
  robot_section().read(table, robot);
}

}  // namespace

const Section<TeamSpec>& team_section() {
  static const Section<TeamSpec> section(
      "[[teams]]", {{"name", &TeamSpec::name, "", "what robots call it", {}, "(needed)"},
                    {"color",
                     [](const TomlTable& table, std::string_view, TeamSpec& team) {
                       team.color = files::read_color(table, team.color);
                     },
                     "",
                     "red, green, blue from 0 to 1",
                     {},
                     "blue, then red"},
                    {"attacks", read_attacks, "", "right: the goal at positive x, left", {}, "right, then left"},
                    {"number", read_number, "", "of the team in a GameController", {}, "by the order there"}});
  return section;
}

const Section<RobotSpec>& robot_section() {
  using Name = Choice<RobotSpec>;
  using Turn = Angle<RobotSpec>;
  const Bounds turns = between(-3600, 3600);
  static const Section<RobotSpec> section(
      "[[robots]]",
      {{"name", &RobotSpec::name, "", "of the entity", {}, "(needed)"},
       {"team", &RobotSpec::team, "", "one of [[teams]]", {}, "none"},
       {"model", &RobotSpec::model, "", "a name in models/, or a file", {}, "(needed)"},
       {"body", &RobotSpec::body, "", "of several robots in its MJCF file that with this body", {}, "most joints"},
       {"xacro", read_xacro, "", "arguments of its .xacro file: {side = \"left\"}", {}, "those of the file"},
       {"level", Name{&RobotSpec::level, "level", [] { return entry_names(catalog::levels()); }}, "",
        "murosimf list levels"},
       {"contact", Name{&RobotSpec::contact, "contact law", [] { return entry_names(catalog::contacts()); }}, "",
        "with the ground: murosimf list contacts"},
       {"controller", Name{&RobotSpec::controller, "controller", [] { return entry_names(catalog::controllers()); }},
        "", "murosimf list controllers"},
       {"rate", &RobotSpec::rate, "Hz",
        "of its motion and contact while no other entity is near: the scene's by a whole number",
        between(slowest_rate, fastest_rate), "the scene's"},
       {"control_rate", &RobotSpec::control_rate, "Hz", "of its controller", between(slowest_rate, fastest_rate),
        "the controller's"},
       {"options", {}, "", "of its controller: murosimf list options", {}, "the controller's"},
       {"level_options", {}, "", "of its level: murosimf list options", {}, "the level's"},
       {"contact_options", {}, "", "of its contact law: murosimf list options", {}, "the law's"},
       {"servo_law",
        Name{&RobotSpec::servo_law, "servo law", [] { return entry_names(dynamics::servo_laws()); }},
        "",
        "of all servos: murosimf list servo_laws",
        {},
        "the model's"},
       {"motion", &RobotSpec::motion, "", "of the controller 'keyframes': a name in motions/, or a file", {}, "none"},
       {"library", &RobotSpec::library, "", "of the controller 'library': a file (docs/library.md)", {}, "none"},
       {"call_budget", &RobotSpec::call_budget, "s", "of wall time for each call of the library", between(0, 3600),
        "any"},
       {"reload", &RobotSpec::reload, "", "whether the library is loaded anew when its file changes"},
       {"link", read_link, "", "between it and its control software: [robots.link]", {}, "none"},
       {"command", &RobotSpec::command, "m/s, rad/s", "first walking velocity: x, y, turning"},
       {"position", &RobotSpec::position, "m", "x and y of the base; z: how high the lowest point stands",
        up_to(farthest_place)},
       {"heading_deg", Turn{&RobotSpec::heading}, "deg", "about the vertical", turns},
       {"roll_deg", Turn{&RobotSpec::roll}, "deg", "about x, before the heading; not at kinematic_walking", turns},
       {"pitch_deg", Turn{&RobotSpec::pitch}, "deg", "about y, before roll and heading; not at kinematic_walking",
        turns},
       {"keyframe", &RobotSpec::keyframe, "", "posture at the start: a key of its MJCF file", {}, "its pose there"},
       {"present", &RobotSpec::present, "", "at the start; an event 'NAME.present = true' brings it"},
       {"joint_reference",
        Name{&RobotSpec::joint_reference, "joint reference", [] { return entry_names(dynamics::joint_references()); }},
        "", "murosimf list joint_references: how joints follow their targets without servos"},
       {"integrator",
        read_integrator,
        "",
        "murosimf list integrators; rk4 needs an explicit contact law",
        {},
        "semi_implicit_euler"},
       {"base_rigid", &RobotSpec::base_rigid, "", "simplified_dynamics by the letter of the paper"},
       {"fixed_base", &RobotSpec::fixed_base, "", "full and articulated dynamics: the base is bolted to the world"},
       {"volume",
        [](const TomlTable& table, std::string_view key, RobotSpec& robot) { table.read(key, robot.collision.volume); },
        "",
        "bounding volumes: murosimf list volumes",
        {},
        "sphere"},
       {"self_collision",
        [](const TomlTable& table, std::string_view key, RobotSpec& robot) {
          table.read(key, robot.collision.self_collision);
        },
        "",
        "whether links of the robot touch each other",
        {},
        "false"},
       {"no_contact",
        [](const TomlTable& table, std::string_view key, RobotSpec& robot) { table.read(key, robot.collision.never); },
        "",
        "pairs of objects that never touch: [[a, b]]",
        {},
        "none"},
       {"accelerations", &RobotSpec::accelerations, "", "whether they are worked out, for logs and programs"},
       {"sensors",
        [](const TomlTable& table, std::string_view key, RobotSpec& robot) {
          component_files::read_sensor_changes(table.find(key), robot.sensors);
        },
        "",
        "false: none; [robots.sensors.NAME]: changes and additions",
        {},
        "the model's"}});
  return section;
}

/// The first team is blue and the second one red unless they say otherwise.
void read_teams(const files::TomlTable& scene, SceneSpec& spec) {
  for (const toml::table* node : scene.tables("teams")) {
    const files::TomlTable table(*node, team_section().names());
    TeamSpec team;
    if (spec.teams.empty()) {
      team.color = {0.1, 0.3, 0.9};
    } else {
      team.color = {0.9, 0.15, 0.1};
      team.attacks = -1;
    }
    team_section().read(table, team);
    require(!team.name.empty(), table, "name", "of the team is missing");
    const auto same = [&](const TeamSpec& other) { return other.name == team.name; };
    require(std::none_of(spec.teams.begin(), spec.teams.end(), same), table, "name", "is the name of two teams");
    const auto as_well = [&](const TeamSpec& other) { return team.number != 0 && other.number == team.number; };
    require(std::none_of(spec.teams.begin(), spec.teams.end(), as_well), table, "number", "is that of two teams");
    spec.teams.push_back(team);
  }
}

void read_robots(const files::TomlTable& scene, SceneSpec& spec) {
  RobotSpec defaults;
  std::map<std::string_view, const toml::table*> default_options;  // by key, existing ones
  if (const toml::table* node = scene.table("defaults")) {
    const files::TomlTable table(*node, names_of(*find_section("defaults")));
    read_robot(table, defaults);
    for (const RobotOptions& one : robot_options()) {
      if (const toml::table* given = table.table(one.key)) default_options.emplace(one.key, given);
    }
    for (auto& [key, given] : defaults.given) given.by_default = true;
  }
  for (const toml::table* node : scene.tables("robots")) {
    const files::TomlTable table(*node, robot_section().names());
    RobotSpec robot = defaults;
    read_robot(table, robot);
    for (const RobotOptions& one : robot_options()) {
      if (default_options.contains(one.key)) read_default_options(one, *default_options.at(one.key), robot);
      if (const toml::table* given = table.table(one.key)) read_options(one, *given, robot);
    }
    require(!robot.name.empty(), table, "name", "of the robot is missing");
    require(!robot.model.empty(), table, "model", "of the robot is missing");
    const auto same_name = [&](const RobotSpec& other) { return other.name == robot.name; };
    const bool taken =
        robot.name == "ball" || robot.name == "field" || std::any_of(spec.robots.begin(), spec.robots.end(), same_name);
    if (taken) files::fail_at(table.find("name")->source(), fmt::format("two entities are called '{}'", robot.name));
    const auto is_team = [&](const TeamSpec& team) { return team.name == robot.team; };
    if (!robot.team.empty() && std::none_of(spec.teams.begin(), spec.teams.end(), is_team)) {
      std::vector<std::string_view> names;
      for (const TeamSpec& team : spec.teams) names.push_back(team.name);
      throw SetupError(fmt::format("{}: {}", table.where("team"), unknown_name("team", robot.team, names)));
    }
    require(robot.controller != "ball_chaser" || spec.ball, table, "controller",
            "ball_chaser needs a [ball] in the scene");
    spec.robots.push_back(robot);
  }
  if (spec.robots.empty()) return;
  for (const RobotOptions& one : robot_options()) {
    if (default_options.contains(one.key)) check_default_options(one, *default_options.at(one.key), spec.robots);
  }
}

}  // namespace murosimf::scene_file
