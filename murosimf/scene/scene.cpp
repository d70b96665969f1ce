#include "murosimf/scene/scene.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/appearance/entity_appearance.h"
#include "murosimf/collision/body_contact.h"
#include "murosimf/collision/ground_contact.h"
#include "murosimf/files/data_path.h"
#include "murosimf/files/output_file.h"
#include "murosimf/motion/motion_properties.h"
#include "murosimf/motion/odometer.h"
#include "murosimf/motion/torque_watch.h"
#include "murosimf/render/field_picture.h"
#include "murosimf/render/renderer.h"
#include "murosimf/robot/robot_reader.h"
#include "murosimf/scene/field.h"
#include "murosimf/scene/model_constants.h"
#include "murosimf/scene/motion_file.h"
#include "murosimf/scene/property_checks.h"
#include "murosimf/scene/registry.h"

namespace murosimf::scene {
Scene::Scene(const std::filesystem::path& name, const SceneOptions& options)
    : spec_(read_scene(files::find_data_file(name.string(), "scenes", ".toml"), options.overrides, options.events,
                       options.pushes)),
      options_(options),
      simulation_(std::make_unique<Simulation>(options.threads)) {
  if (options.seed) spec_.seed = *options.seed;
  simulation_->world().gravity = spec_.gravity;
  simulation_->stop_if(options.stop);
  add_entities();
  attach_sensors();
  attach_controllers();
  attach_pushes();
  attach_contact();
  attach_motion();
  note_about_sensors();
  warn_about_static_bodies();
  attach_observers();
  scatter_postures();
  warn_about_settings();
  simulation_->after_initialize([this] {
    check_properties();
    apply_settings();
    warn_about_start();
  });
  schedule_events();
}

void Scene::add_entities() {
  World& world = simulation_->world();
  add_field();
  if (spec_.ball) {
    EntityOptions options;
    options.position = spec_.ball->position;
    const ModelPtr model = model_for("ball", ball_model(spec_.ball->options));
    check_materials(*model);
    options.color = model->find(properties::shapes, 0)->front().color;
    ball_ = &world.add("ball", model, options);
    ball_->level = "simplified_dynamics";
    ball_->contact = spec_.ball->contact;
    moving_entities_.push_back(ball_);
  }
  for (const RobotSpec& robot : spec_.robots) add_robot(robot);
  add_bodies();
}

void Scene::add_robot(const RobotSpec& robot) {
  EntityOptions options;
  const RandomStream random(spec_.seed, robot.name + "/start");
  const double j = spec_.jitter_position;
  options.position = robot.position + Vec3d{random.uniform(0, -j, j), random.uniform(1, -j, j), 0};
  options.heading = robot.heading + random.uniform(2, -spec_.jitter_heading, spec_.jitter_heading);
  options.attitude = random_tilt(random) * rotation_y(robot.pitch) * rotation_x(robot.roll);
  options.collision = robot.collision;
  options.team = robot.team;
  for (const TeamSpec& team : spec_.teams) {
    if (team.name == robot.team) options.color = team.color;
  }
  const ModelPtr robot_model = model_for(robot.name, model(robot.model, robot.where));
  Entity& entity = with_context(robot.where, [&]() -> Entity& {
    return simulation_->world().add(robot.name, robot_model, options);
  });
  entity.level = robot.level;
  entity.controller = robot.controller;
  robots_.push_back(&entity);
  moving_entities_.push_back(&entity);
}

/// A turn about any axis, by up to jitter_tilt.
Mat3d Scene::random_tilt(const RandomStream& random) const {
  const double z = random.uniform(3, -1, 1), longitude = random.uniform(4, -pi, pi), across = std::sqrt(1 - z * z);
  return rotation(Vec3d{across * std::cos(longitude), across * std::sin(longitude), z},
                  random.uniform(5, -spec_.jitter_tilt, spec_.jitter_tilt));
}

/// Joint targets away from zero, by up to jitter_posture; controllers that set them are stronger.
void Scene::scatter_postures() {
  if (spec_.jitter_posture == 0) return;
  for (Entity* robot : robots_) {
    const RandomStream random(spec_.seed, robot->name() + "/posture");
    auto& targets = robot->column(properties::joint_target).values;
    for (const int joint : robot->model().joints()) {
      const Vec3d* range = robot->model().find(properties::joint_range, joint);
      const double angle =
          random.uniform(static_cast<std::uint64_t>(joint), -spec_.jitter_posture, spec_.jitter_posture);
      targets[joint] = range ? std::clamp(angle, range->x, range->y) : angle;
    }
  }
}

ModelPtr Scene::model(const std::string& name, const std::string& where) {
  RobotKind& known = models_[name];
  if (known.model) return known.model;
  const auto file =
      with_context(where, [&] { return files::find_data_file(name, "models", ".xml", spec_.file.parent_path()); });
  robot::RobotFile result = robot::read_robot(file, {.lenient = options_.lenient});
  warnings_.insert(warnings_.end(), result.warnings.begin(), result.warnings.end());
  check_materials(*result.model);
  known = {result.model, std::move(result.sensors)};
  return known.model;
}

void Scene::check_materials(const Model& model) const {
  for (const int body : model.bodies()) {
    const Shapes* shapes = model.find(properties::shapes, body);
    if (!shapes) continue;
    for (const PlacedShape& placed : *shapes) {
      if (placed.surface.material.empty() || spec_.materials.knows(placed.surface.material)) continue;
      throw SetupError(fmt::format("model '{}', object '{}': {}", model.name(), model.objects()[body].name,
                                   unknown_name("material", placed.surface.material, spec_.materials.names())));
    }
  }
}

void Scene::attach_controllers() {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const RobotSpec& robot = spec_.robots[i];
    ControllerOptions options;
    options.everybody = moving_entities_;
    options.command = robot.command;
    const FieldSize& field = field_size(spec_.field.size);
    options.half_field = {0.5 * field.length, 0.5 * field.width, 0};
    options.start = {robot.position.x, robot.position.y, robot.heading};
    options.markings = field_markings(field);
    options.seed = spec_.seed;
    for (const TeamSpec& team : spec_.teams) {
      if (team.name == robot.team) options.attacks = team.attacks;
    }
    if (!robot.motion.empty()) {
      options.motion =
          with_context(robot.where, [&] { return read_motion(find_motion(robot.motion, spec_.file.parent_path())); });
    }
    const ControllerType& controller = find_entry(controllers(), "controller", robot.controller);
    with_context(robot.where, [&] { controller.attach(*simulation_, *robots_[i], options); });
  }
}

void Scene::attach_contact() {
  // also those that no force moves: they may change their level
  const auto attach = [&](Entity& entity, const std::string& level, const std::string& law) {
    if (find_entry(levels(), "level", level).dynamic) entity.contact = law;
    ground_contacts_.push_back(
        &simulation_->attach<collision::GroundContact>("ground_contact", entity, spec_.rate, field_,
                                                       find_entry(contacts(), "contact law", law).make(),
                                                       spec_.materials));
  };
  if (ball_) attach(*ball_, ball_->level, spec_.ball->contact);
  for (std::size_t i = 0; i < robots_.size(); ++i) attach(*robots_[i], robots_[i]->level, spec_.robots[i].contact);
  for (Entity* body : bodies_) attach(*body, body->level, body->contact);
  simulation_->attach<collision::BodyContact>("body_contact", *field_, spec_.rate, moving_entities_, spec_.materials,
                                              collision::BodyContactOptions{.law = spec_.body_contact});
}

void Scene::note(const RobotSpec& robot, const std::string& text) {
  notes_.push_back(fmt::format("{}: {}", robot.name, text));
}

void Scene::warn(const RobotSpec& robot, const std::string& text) {
  warnings_.push_back(fmt::format("{}: {}", robot.name, text));
}

void Scene::warn_about(const RobotSpec& robot, const Model& model) {
  const LevelType& level = find_entry(levels(), "level", robot.level);
  const bool servos = robot.level == "articulated_dynamics";
  if (level.dynamic) {
    const ContactLawType& law = find_entry(contacts(), "contact law", robot.contact);
    const double longest = servos ? law.longest_servo_step : law.longest_step;
    if (1 / spec_.rate > longest * (1 + 1e-9)) {
      warn(robot, fmt::format("{} under {} is stable with steps up to {:.0f} ms; these are {:.3g} ms long",
                              robot.contact, robot.level, 1e3 * longest, 1e3 / spec_.rate));
    }
  }
  if (!servos) return;
  const auto joints = model.joints();
  const auto without =
      std::count_if(joints.begin(), joints.end(), [&](int i) { return model.find(properties::servo, i) == nullptr; });
  if (without > 0) warn(robot, fmt::format("{} of its {} joints have no servo and hang free", without, joints.size()));
}

void Scene::attach_motion() {
  const auto attach = [&](Entity& entity, const LevelOptions& options) {
    const LevelType& level = find_entry(levels(), "level", entity.level);
    simulation_->attach(entity.level, entity, spec_.rate, [&](Setup& setup) { return level.make(setup, options); });
  };
  if (ball_) attach(*ball_, {});
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const RobotSpec& robot = spec_.robots[i];
    warn_about(robot, robots_[i]->model());
    with_context(robot.where, [&] { attach(*robots_[i], level_options(robot)); });
  }
  for (Entity* body : bodies_) with_context(body_spec(*body)->where, [&] { attach(*body, {}); });
}

void Scene::attach_observers() {
  for (Entity* entity : moving_entities_)
    simulation_->attach<motion::Odometer>("odometer", *entity, motion::Odometer::rate_hz);
  if (!options_.paths) return;
  recorder_ = &simulation_->attach<PathRecorder>("path_recorder", *field_, PathRecorder::rate_hz, moving_entities_);
}

void Scene::apply_settings() {
  if (ball_) {
    ball_->base().set(properties::linear_velocity, spec_.ball->velocity);
  }
  start_bodies();
  for (const PropertySetting& setting : spec_.settings) {
    for (const std::string& name : setting.entities) {
      if (is_constant(setting)) {  // done with the model
        simulation_->record(to_text(setting, simulation_->world().entity(name)));
      } else {
        apply(setting, name);
      }
    }
  }
}

RunReport Scene::report(Duration wall, const Lateness& lateness) const {
  RunReport report;
  report.scene = spec_.name;
  report.simulated = seconds(simulation_->now());
  report.wall = seconds(wall);
  report.real_time_factor = wall > Duration{} ? report.simulated / report.wall : 0;
  report.threads = simulation_->threads();
  report.seed = spec_.seed;
  report.state_hash = simulation_->state_hash();
  for (Entity* moving_entity : moving_entities_) {
    const auto base = moving_entity->base();
    const Vec3d since_sample = base.get(properties::position) - base.get(properties::distance_sample);
    EntityReport e{moving_entity->name(),
                   moving_entity->model().name(),
                   moving_entity->level,
                   moving_entity->contact,
                   moving_entity->controller,
                   moving_entity->options().team,
                   base.get(properties::position),
                   base.get(properties::distance_walked) + std::hypot(since_sample.x, since_sample.y),
                   static_cast<int>(base.get(properties::falls)),
                   moving_entity->frozen()};
    report.entities.push_back(std::move(e));
    for (const sensors::Reading* reading : sensors::readings_of(*moving_entity)) {
      report.sensors.push_back({moving_entity->name(), *reading});
    }
  }
  report.algorithms = simulation_->statistics();
  report.events = simulation_->events();
  report.notes = notes_;
  report.warnings = warnings_;
  const auto& frozen = simulation_->warnings();
  report.warnings.insert(report.warnings.end(), frozen.begin(), frozen.end());
  if (auto line = events_to_come(); !line.empty()) report.warnings.push_back(std::move(line));
  for (const Entity* moving_entity : moving_entities_) {
    if (auto line = motion::overload_message(*moving_entity); !line.empty()) report.warnings.push_back(std::move(line));
  }
  if (lateness.late_steps > 0) {
    report.warnings.push_back(fmt::format("late: {} of {} steps ended behind schedule, the worst {:.1f} ms",
                                          lateness.late_steps, lateness.steps, 1e3 * seconds(lateness.worst)));
  }
  return report;
}

/// [m] world; ends where it is now.
std::vector<Vec3d> Scene::path_of(Entity& entity) const {
  std::vector<Vec3d> points;
  if (recorder_) {
    const auto& paths = recorder_->paths();
    points = std::ranges::find(paths, &entity, &PathRecorder::Path::entity)->points;
  }
  points.push_back(entity.base().get(properties::position));
  return points;
}

void Scene::write_picture(const std::filesystem::path& file) const {
  std::vector<render::Path> paths;
  for (Entity* entity : moving_entities_) {
    render::Path path;
    path.name = entity->name();
    path.color = entity->options().color;
    path.points = path_of(*entity);
    path.heading = heading(entity->base().get(properties::orientation));
    path.is_ball = entity == ball_;
    path.number = appearance::jersey_number(entity->name());
    if (path.is_ball) path.size = spec_.ball->options.radius;
    if (const BodySpec* body = body_spec(*entity)) {  // as round things, too
      path.is_ball = true;
      if (body->shape) path.size = bounding_radius(*body->shape);
    }
    paths.push_back(std::move(path));
  }
  const Markings* markings = field_->model().find(properties::markings, 0);
  files::write_file(file, render::field_picture_png(*markings, paths,
                                                    {.title = fmt::format("{}: {:.0f} s", spec_.name,
                                                                          seconds(simulation_->now()))}));
}

}  // namespace murosimf::scene
