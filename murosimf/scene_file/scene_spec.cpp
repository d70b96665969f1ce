#include "murosimf/scene_file/scene_spec.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/components/sensor_toml.h"
#include "murosimf/files/toml_color.h"
#include "murosimf/files/toml_reader.h"
#include "murosimf/model/time.h"
#include "murosimf/motion/servo_law.h"
#include "murosimf/render/light.h"
#include "murosimf/scene_file/body_section.h"
#include "murosimf/scene_file/event_section.h"
#include "murosimf/scene_file/field.h"
#include "murosimf/scene_file/material_section.h"
#include "murosimf/scene_file/overrides.h"
#include "murosimf/scene_file/push_section.h"

namespace murosimf::scene_file {
namespace {

constexpr double degree = pi / 180;
constexpr double farthest_place = 1e4;  // [m]

void require(bool condition, const files::TomlTable& table, std::string_view key, std::string_view message) {
  if (!condition) throw SetupError(fmt::format("{}: '{}' {}", table.where(key), key, message));
}

/// An empty name means nothing; it must not look as if it did.
void require_name(const std::string& name, const files::TomlTable& table, std::string_view key) {
  require(!name.empty(), table, key, "is empty: leave it out, or name something");
}

/// Two numbers would be a place on the ground.
void read_gravity(const files::TomlTable& scene, SceneSpec& spec) {
  const toml::node* node = scene.find("gravity");
  const toml::array* list = node ? node->as_array() : nullptr;
  require(!list || list->size() == 3, scene, "gravity", "must be three numbers in brackets: x, y, z in m/s^2");
  scene.read("gravity", spec.gravity);
}

void read_start(const files::TomlTable& scene, SceneSpec& spec) {
  const toml::table* node = scene.table("start");
  if (!node) return;
  const files::TomlTable start(*node, table_keys("start"));
  start.read("jitter_position", spec.jitter_position);
  require(spec.jitter_position >= 0, start, "jitter_position", "must not be negative");
  require(spec.jitter_position <= 1e4, start, "jitter_position", "is more than 10 km");
  const auto read_angle = [&](std::string_view key, double& angle) {
    double angle_deg = 0;
    start.read(key, angle_deg);
    require(angle_deg >= 0, start, key, "must not be negative");
    require(angle_deg <= 360, start, key, "is more than a turn");
    angle = angle_deg * degree;
  };
  read_angle("jitter_heading_deg", spec.jitter_heading);
  read_angle("jitter_tilt_deg", spec.jitter_tilt);
  read_angle("jitter_posture_deg", spec.jitter_posture);
}

void read_field(const files::TomlTable& scene, SceneSpec& spec) {
  const toml::table* node = scene.table("field");
  if (!node) return;
  const files::TomlTable field(*node, table_keys("field"));
  field.read("size", spec.field.size);
  field.read("surface", spec.field.surface);
  field.read("friction_direction", spec.field.friction_direction);
  field.read("goals", spec.field.goals);
  require_name(spec.field.surface, field, "surface");
  if (field.find("friction")) field.read("friction", spec.field.friction.emplace());
  require(spec.field.friction.value_or(0) >= 0, field, "friction", "must not be negative");
  require(spec.field.friction_direction.z == 0, field, "friction_direction", "lies in the ground: [x, y]");
  with_context(field.where("size"), [&] { return field_size(spec.field.size); });
}

void read_view(const files::TomlTable& scene, SceneSpec& spec) {
  const toml::table* node = scene.table("view");
  if (!node) return;
  const files::TomlTable view(*node, table_keys("view"));
  double azimuth_deg = spec.view.azimuth / degree, elevation_deg = spec.view.elevation / degree;
  view.read("center", spec.view.center);
  view.read("width", spec.view.width);
  view.read("azimuth_deg", azimuth_deg);
  view.read("elevation_deg", elevation_deg);
  require(spec.view.width >= 0 && spec.view.width <= farthest_place, view, "width", "must be from 0 to 10000 m");
  require(norm(spec.view.center) <= farthest_place, view, "center", "is further than 10 km away");
  require(std::abs(azimuth_deg) <= 360, view, "azimuth_deg", "is more than a turn");
  require(elevation_deg >= 0 && elevation_deg <= 90, view, "elevation_deg", "must be from 0 to 90");
  spec.view.azimuth = azimuth_deg * degree;
  spec.view.elevation = elevation_deg * degree;
}

void read_light(const files::TomlTable& scene, SceneSpec& spec) {
  const toml::table* node = scene.table("light");
  if (!node) return;
  const files::TomlTable light(*node, table_keys("light"));
  light.read("name", spec.light.name);
  with_context(light.where("name"), [&] { (void)find_entry(render::lights(), "light", spec.light.name); });
  if (light.find("toward")) light.read("toward", spec.light.toward.emplace());
  light.read("brightness", spec.light.brightness);
  light.read("shadows", spec.light.shadows);
  std::uint64_t samples = 1;
  light.read("samples", samples);
  require(!spec.light.toward || spec.light.toward->z > 0, light, "toward",
          "must point upwards: light comes from above");
  require(spec.light.brightness >= 0 && spec.light.brightness <= 100, light, "brightness", "must be from 0 to 100");
  require(samples == 1 || samples == 2 || samples == 4 || samples == 8, light, "samples", "must be 1, 2, 4 or 8");
  spec.light.samples = static_cast<int>(samples);
}

void read_viewpoints(const files::TomlTable& scene, SceneSpec& spec) {
  const toml::table* views = scene.table("views");
  if (!views) return;
  for (const auto& [key, node] : *views) {
    const toml::table* inside = node.as_table();
    if (!inside)
      files::fail_at(node.source(), fmt::format("view '{}' must be a table, like [views.{}]", key.str(), key.str()));
    const files::TomlTable table(*inside, {"eye", "look_at", "fov_deg"});
    ViewpointSpec eye{.name = std::string(key.str())};
    double fov_deg = eye.fov / degree;
    require(table.find("eye") != nullptr, table, "eye", "is missing: where the eye is, [x, y, z] in m");
    table.read("eye", eye.eye);
    table.read("look_at", eye.look_at);
    table.read("fov_deg", fov_deg);
    require(fov_deg >= 1 && fov_deg <= 150, table, "fov_deg", "must be from 1 to 150");
    require(norm(eye.look_at - eye.eye) > 1e-3, table, "look_at", "is where the eye is");
    require(norm(eye.eye) + norm(eye.look_at) <= farthest_place, table, "eye", "is further than 10 km away");
    eye.fov = fov_deg * degree;
    spec.viewpoints.push_back(eye);
  }
}

void read_ball(const files::TomlTable& scene, SceneSpec& spec) {
  const toml::table* node = scene.table("ball");
  if (!node) return;
  const files::TomlTable table(*node, table_keys("ball"));
  BallSpec ball;
  table.read("position", ball.position);
  table.read("velocity", ball.velocity);
  table.read("radius", ball.options.radius);
  table.read("mass", ball.options.mass);
  table.read("hollow", ball.options.hollow);
  table.read("material", ball.options.material);
  table.read("contact", ball.contact);
  require_name(ball.options.material, table, "material");
  with_context(table.where("contact"), [&] { return &find_entry(catalog::contacts(), "contact law", ball.contact); });
  require(ball.options.radius > 0, table, "radius", "must be positive");
  require(ball.options.mass > 0, table, "mass", "must be positive");
  spec.ball = ball;
}

void read_teams(const files::TomlTable& scene, SceneSpec& spec) {
  for (const toml::table* node : scene.tables("teams")) {
    const files::TomlTable table(*node, {"name", "color", "attacks"});
    TeamSpec team;
    table.read("name", team.name);
    require(!team.name.empty(), table, "name", "of the team is missing");
    const auto same = [&](const TeamSpec& other) { return other.name == team.name; };
    require(std::none_of(spec.teams.begin(), spec.teams.end(), same), table, "name", "is the name of two teams");
    team.color = files::read_color(table, spec.teams.empty() ? Color{0.1, 0.3, 0.9} : Color{0.9, 0.15, 0.1});
    std::string attacks = spec.teams.empty() ? "right" : "left";
    table.read("attacks", attacks);
    require(attacks == "right" || attacks == "left", table, "attacks",
            "must be \"right\" (the goal at positive x) or \"left\"");
    team.attacks = attacks == "right" ? 1 : -1;
    spec.teams.push_back(team);
  }
}

void read_robot(const files::TomlTable& table, RobotSpec& robot) {
  robot.where = table.where();
  for (const std::string_view key : robot_keys()) {
    if (table.find(key)) robot.given[std::string(key)] = {table.where(key)};
  }
  table.read("name", robot.name);
  table.read("team", robot.team);
  table.read("model", robot.model);
  table.read("level", robot.level);
  table.read("contact", robot.contact);
  table.read("controller", robot.controller);
  table.read("servo_law", robot.servo_law);
  table.read("motion", robot.motion);
  table.read("joint_reference", robot.joint_reference);
  table.read("base_rigid", robot.base_rigid);
  table.read("fixed_base", robot.fixed_base);
  if (table.find("integrator")) {
    std::string integrator;
    table.read("integrator", integrator);
    robot.integrator = with_context(table.where("integrator"), [&] {
      return find_entry(motion::integrators(), "integrator", integrator).integrator;
    });
  }
  table.read("position", robot.position);
  table.read("command", robot.command);
  const auto read_angle = [&](std::string_view key, double& angle) {
    double angle_deg = angle / degree;
    table.read(key, angle_deg);
    require(std::abs(angle_deg) <= 3600, table, key, "must be between -3600 and 3600");
    angle = angle_deg * degree;
  };
  read_angle("heading_deg", robot.heading);
  read_angle("roll_deg", robot.roll);
  read_angle("pitch_deg", robot.pitch);
  table.read("volume", robot.collision.volume);
  table.read("self_collision", robot.collision.self_collision);
  table.read("no_contact", robot.collision.never);
  components::read_sensor_changes(table.find("sensors"), robot.sensors);
  require(norm(robot.position) <= farthest_place, table, "position", "is further than 10 km away");
  with_context(table.where("level"), [&] { return &find_entry(catalog::levels(), "level", robot.level); });
  with_context(table.where("contact"), [&] { return &find_entry(catalog::contacts(), "contact law", robot.contact); });
  if (!robot.servo_law.empty()) {
    with_context(table.where("servo_law"),
                 [&] { return &find_entry(motion::servo_laws(), "servo law", robot.servo_law); });
  }
  with_context(table.where("controller"),
               [&] { return &find_entry(catalog::controllers(), "controller", robot.controller); });
  require(robot.joint_reference == "filter" || robot.joint_reference == "linear", table, "joint_reference",
          "must be \"filter\" or \"linear\"");
}

void read_robots(const files::TomlTable& scene, SceneSpec& spec) {
  RobotSpec defaults;
  if (const toml::table* node = scene.table("defaults")) {
    read_robot(files::TomlTable(*node, table_keys("defaults")), defaults);
    for (auto& [key, given] : defaults.given) given.by_default = true;
  }
  for (const toml::table* node : scene.tables("robots")) {
    const files::TomlTable table(*node, robot_keys());
    RobotSpec robot = defaults;
    read_robot(table, robot);
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
}

void check_pair(const GivenPair& pair, const std::vector<GivenPair>& earlier) {
  if (pair.a.empty() || pair.b.empty()) throw SetupError(pair.where + ": 'pair' has an empty name");
  for (const GivenPair& other : earlier) {
    if ((other.a != pair.a || other.b != pair.b) && (other.a != pair.b || other.b != pair.a)) continue;
    throw SetupError(fmt::format("{}: the pair of '{}' and '{}' is set twice, first at {}", pair.where, pair.a, pair.b,
                                 other.where));
  }
}

void read_materials(const files::TomlTable& scene, SceneSpec& spec) {
  for (const toml::table* node : scene.tables("materials")) {
    const files::TomlTable table(*node,
                                 {"pair", "friction", "rolling", "restitution", "stiffness", "friction_anisotropy"});
    const toml::array* names = (*node)["pair"].as_array();
    const bool pair_of_texts = names && names->size() == 2 && (*names)[0].is_string() && (*names)[1].is_string();
    require(pair_of_texts, table, "pair", "must be two material names");
    const GivenPair given{**(*names)[0].as_string(), **(*names)[1].as_string(), table.where("pair")};
    check_pair(given, spec.material_pairs);
    spec.material_pairs.push_back(given);
    PairSurface pair;
    table.read("friction", pair.friction);
    table.read("rolling", pair.rolling);
    table.read("restitution", pair.restitution);
    table.read("stiffness", pair.stiffness);
    table.read("friction_anisotropy", pair.friction_anisotropy);
    with_context(table.where(), [&] {
      spec.materials.set(given.a, given.b, pair);
      return 0;
    });
  }
}

}  // namespace

SceneSpec read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                     const std::vector<std::string>& at_options, const std::vector<std::string>& push_options) {
  SceneSpec spec;
  toml::table document = files::parse_toml_file(file);
  if (document.empty()) throw SetupError(fmt::format("{}: the file is empty", file.string()));
  std::vector<MaterialChange> material_changes;
  for (const std::string& text : overrides) {
    if (!take_material_change(text, material_changes)) apply_override(document, text, spec.settings);
  }

  const files::TomlTable scene(document, scene_keys());
  spec.file = file;
  spec.name = file.stem().string();
  scene.read("name", spec.name);
  scene.read("duration", spec.duration);
  scene.read("seed", spec.seed);
  scene.read("rate", spec.rate);
  read_gravity(scene, spec);
  std::string body_contact = "island_gauss_seidel";
  scene.read("body_contact", body_contact);
  spec.body_contact = with_context(scene.where("body_contact"), [&] {
    return find_entry(collision::body_contact_laws(), "law of contact between bodies", body_contact).law;
  });
  require(spec.duration >= 0, scene, "duration", "must not be negative");
  require(spec.duration <= longest_duration, scene, "duration", "is longer than simulated time can count");
  require(spec.rate >= slowest_rate && spec.rate <= fastest_rate, scene, "rate",
          fmt::format("must be from {} to {} Hz", slowest_rate, fastest_rate));
  read_start(scene, spec);
  read_field(scene, spec);
  read_view(scene, spec);
  read_light(scene, spec);
  read_viewpoints(scene, spec);
  read_ball(scene, spec);
  read_teams(scene, spec);
  read_robots(scene, spec);
  read_bodies(scene, spec);
  read_materials(scene, spec);
  apply_material_changes(material_changes, spec);
  spec.events = read_events(document, at_options);
  spec.pushes = read_pushes(document, push_options);
  return spec;
}

}  // namespace murosimf::scene_file
