#include "murosimf/dataset/stage.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "murosimf/files/data_path.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/assets.h"

namespace murosimf::dataset {
namespace {

constexpr double aside = 100;   // [m] where people and things wait
constexpr double crowding = 4;  // [m] between them there

const std::array person_models{"person", "person_striding"};

scene_file::BodySpec person(std::size_t number) {
  scene_file::BodySpec body;
  body.name = fmt::format("person{}", number + 1);
  const char* model = person_models[number % person_models.size()];
  body.model = files::find_data_file(model, "datasets", ".xml").string();
  body.position = {aside + crowding * static_cast<double>(number), aside, 0};
  return body;
}

/// Boxes, barrels and bags, of a size that follows from the seed.
scene_file::BodySpec thing(std::size_t number, std::uint64_t seed) {
  Dice dice(seed, "thing", number);
  scene_file::BodySpec body;
  body.name = fmt::format("thing{}", number + 1);
  const double width = dice.in({0.1, 0.4}), height = dice.in({0.1, 0.6});
  switch (dice.one_of(3)) {
    case 0: body.shape = Box{{width, dice.in({0.1, 0.3}), height}}; break;
    case 1: body.shape = Cylinder{0.7 * width, height}; break;
    default: body.shape = Ellipsoid{{width, 0.6 * width, 0.6 * width}}; break;
  }
  body.mass = 1;
  body.color = Color{};  // that of the entity, which is another one in each picture
  body.position = {aside + crowding * static_cast<double>(number), -aside, 0};
  return body;
}

/// Nothing happens in it: it is only looked at.
scene_file::SceneSpec spec_to_look_at(scene_file::SceneSpec spec, const Randomisation& randomisation,
                                      std::uint64_t seed) {
  spec.events.clear();
  spec.pushes.clear();
  for (std::size_t i = 0; i < static_cast<std::size_t>(randomisation.people.count); ++i)
    spec.bodies.push_back(person(i));
  for (std::size_t i = 0; i < static_cast<std::size_t>(randomisation.people.things); ++i) {
    spec.bodies.push_back(thing(i, seed));
  }
  return spec;
}

scene_file::SceneSpec read(const std::filesystem::path& name, const scene::SceneOptions& options) {
  const auto file = files::find_data_file(name.string(), "scenes", ".toml");
  scene_file::SceneSpec spec = scene_file::read_scene(file, options.overrides, options.events, options.pushes);
  if (options.seed) spec.seed = *options.seed;
  return spec;
}

/// Name of the model, and names of keypoints: models of two files, or of one with other arguments, may share either.
using RobotClass = std::pair<std::string, std::vector<std::string>>;

std::vector<std::string> robot_points(const Model& model) {
  std::vector<std::string> names{model.objects()[0].name};
  for (const int joint : model.joints()) names.push_back(model.objects()[static_cast<std::size_t>(joint)].name);
  names.emplace_back("front");
  return names;
}

/// "robot" of one alone; else "robot_kid21", and "robot_kid21_2" where the model's name is taken.
std::vector<std::string> names_of(const std::vector<RobotClass>& kinds) {
  if (kinds.size() == 1) return {"robot"};
  std::vector<std::string> names;
  for (const RobotClass& kind : kinds) {
    const std::string whole = "robot_" + kind.first;
    std::string name = whole;
    for (int next = 2; std::ranges::find(names, name) != names.end(); ++next) name = fmt::format("{}_{}", whole, next);
    names.push_back(name);
  }
  return names;
}

bool begins(const std::string& name, std::string_view word) { return name.starts_with(word); }

}  // namespace

Stage::Stage(const std::filesystem::path& name, const scene::SceneOptions& options,
             const Randomisation& randomisation) {
  scene::SceneOptions shared = options;
  if (!shared.assets) shared.assets = std::make_shared<scene::Assets>();
  const scene_file::SceneSpec spec = read(name, shared);
  postures_ = std::make_unique<PostureBank>(spec, shared, randomisation.robots.recorded);
  shared.cameras = false;
  shared.only_shown = true;
  scene_ = std::make_unique<scene::Scene>(spec_to_look_at(spec, randomisation, spec.seed), shared);
  scene_->simulation().initialize();
  scene_->simulation().poses().take(world(), {}, 0, at_start_);
  markings_ = scene_->parts().field->model().find(properties::markings, 0);
  MUROSIMF_ASSERT(markings_ != nullptr);
  field_ = &scene_file::field_size(spec.field.size);
  crossings_ = crossings_of(*markings_, *field_);
  if (spec.field.goals) goals_ = {goal_points(*field_, -1), goal_points(*field_, 1)};
  add_standing();
  add_actors();
  name_categories();
}

void Stage::add_actors() {
  const auto& moving = scene_->moving_entities();
  for (std::size_t i = 0; i < moving.size(); ++i) actors_.push_back(actor_of(*moving[i], i));
}

/// Uneven ground is what all stands on.
void Stage::add_standing() {
  for (const scene_file::BodySpec& body : scene_->spec().bodies) {
    if (!body.is_static || !body.shape) continue;
    standing_.push_back(footprint_of(*body.shape, {body.position, attitude_of(body)}));
  }
}

void Stage::complete_robot(Actor& robot, const scene_file::RobotSpec& spec) const {
  const auto& teams = scene_->spec().teams;
  robot.role = Actor::Role::robot;
  robot.category = class_robot;
  robot.reach = 0;
  robot.postures = &postures_->of(spec);
  const auto team = std::ranges::find(teams, spec.team, &scene_file::TeamSpec::name);
  if (team != teams.end()) robot.team = static_cast<int>(team - teams.begin());
  robot.cameras = sensors::frames_of(*robot.entity);
}

Actor Stage::actor_of(const Entity& entity, std::size_t number) const {
  const scene::SceneParts& parts = scene_->parts();
  const auto& entities = world().entities();
  Actor actor{.entity = &entity};
  actor.place = static_cast<std::size_t>(
      std::ranges::find(entities, &entity, [](const auto& one) { return one.get(); }) - entities.begin());
  actor.label = static_cast<std::uint16_t>(sensors::label_moving_entity + number);
  const std::size_t first = at_start_.first[actor.place], size = at_start_.first[actor.place + 1] - first;
  actor.height = at_start_.position[first].z;
  actor.reach = ground_reach(entity.model(), std::span(at_start_.position).subspan(first, size),
                             std::span(at_start_.orientation).subspan(first, size));
  if (&entity == parts.ball) {
    actor.role = Actor::Role::ball;
    actor.category = class_ball;
    actor.height = actor.reach = parts.spec.ball->radius;
  }
  const auto robot = std::ranges::find(parts.robots, &entity);
  if (robot != parts.robots.end())
    complete_robot(actor, parts.spec.robots[static_cast<std::size_t>(robot - parts.robots.begin())]);
  if (actor.role != Actor::Role::body) return actor;
  if (at_start_.position[first].x < 0.5 * aside) return actor;  // of the scene itself: it stays where it is
  const bool is_person = begins(entity.name(), "person");
  actor.role = is_person ? Actor::Role::person : Actor::Role::thing;
  actor.category = is_person ? class_person : class_thing;
  return actor;
}

/// Robots of one kind are "robot", of several each kind its own class.
void Stage::name_categories() {
  std::vector<std::string> crossings;
  for (const FieldPoint& point : crossings_) crossings.push_back(point.name);
  categories_ = {{class_ball, "ball", {"center"}},
                 {class_goal, "goal", goal_point_names},
                 {class_person, "person", {}},
                 {class_thing, "thing", {}},
                 {class_ground, "ground", crossings}};
  std::vector<RobotClass> kinds;
  for (Actor& actor : actors_) {
    if (actor.role != Actor::Role::robot) continue;
    const RobotClass kind{actor.entity->model().name(), robot_points(actor.entity->model())};
    const auto known = std::ranges::find(kinds, kind);
    const auto number = static_cast<std::size_t>(known - kinds.begin());
    if (known == kinds.end()) kinds.push_back(kind);
    actor.category = static_cast<std::uint16_t>(number == 0 ? +class_robot : class_next + number - 1);
  }
  const std::vector<std::string> names = names_of(kinds);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const auto number = static_cast<std::uint16_t>(i == 0 ? +class_robot : class_next + i - 1);
    categories_.push_back({number, names[i], kinds[i].second});
  }
  std::ranges::sort(categories_, {}, &Category::number);
}

}  // namespace murosimf::dataset
