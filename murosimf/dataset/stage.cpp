#include "murosimf/dataset/stage.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "murosimf/files/data_path.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/assets.h"

namespace murosimf::dataset {
namespace {

constexpr double aside = 100;                             // [m] where people and things wait
constexpr double crowding = 4;                            // [m] between them there
constexpr double robot_reach = 0.3, person_reach = 0.35;  // [m]

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
  add_actors();
  name_categories();
}

void Stage::add_actors() {
  const auto& moving = scene_->moving_entities();
  for (std::size_t i = 0; i < moving.size(); ++i) actors_.push_back(actor_of(*moving[i], i));
}

Actor Stage::actor_of(const Entity& entity, std::size_t number) const {
  const scene::SceneParts& parts = scene_->parts();
  const auto& entities = world().entities();
  Actor actor{.entity = &entity};
  actor.place = static_cast<std::size_t>(
      std::ranges::find(entities, &entity, [](const auto& one) { return one.get(); }) - entities.begin());
  actor.label = static_cast<std::uint16_t>(sensors::label_moving_entity + number);
  const std::size_t first = at_start_.first[actor.place];
  actor.height = at_start_.position[first].z;
  actor.reach = robot_reach;
  if (&entity == parts.ball) {
    actor.role = Actor::Role::ball;
    actor.category = class_ball;
    actor.height = actor.reach = parts.spec.ball->radius;
  }
  const auto robot = std::ranges::find(parts.robots, &entity);
  if (robot != parts.robots.end()) {
    const auto& spec = parts.spec.robots[static_cast<std::size_t>(robot - parts.robots.begin())];
    actor.role = Actor::Role::robot;
    actor.category = class_robot;
    actor.postures = &postures_->of(spec);
    const auto team = std::ranges::find(parts.spec.teams, spec.team, &scene_file::TeamSpec::name);
    if (team != parts.spec.teams.end()) actor.team = static_cast<int>(team - parts.spec.teams.begin());
    actor.cameras = sensors::frames_of(entity);
  }
  if (actor.role != Actor::Role::body) return actor;
  if (at_start_.position[first].x < 0.5 * aside) return actor;  // of the scene itself: it stays where it is
  const bool is_person = begins(entity.name(), "person");
  actor.role = is_person ? Actor::Role::person : Actor::Role::thing;
  actor.category = is_person ? class_person : class_thing;
  actor.reach = is_person ? person_reach : 0.45;
  return actor;
}

/// Robots of one model are "robot", of several each model its own class.
void Stage::name_categories() {
  std::vector<std::string> crossings;
  for (const FieldPoint& point : crossings_) crossings.push_back(point.name);
  categories_ = {{class_ball, "ball", {"center"}},
                 {class_goal, "goal", goal_point_names},
                 {class_person, "person", {}},
                 {class_thing, "thing", {}},
                 {class_ground, "ground", crossings}};
  std::map<const Model*, std::uint16_t> numbers;
  const auto robots = [this] {
    std::vector<Actor*> all;
    for (Actor& actor : actors_) {
      if (actor.role == Actor::Role::robot) all.push_back(&actor);
    }
    return all;
  }();
  for (Actor* robot : robots) {
    const Model& model = robot->entity->model();
    const auto next = static_cast<std::uint16_t>(numbers.empty() ? +class_robot : class_next + numbers.size() - 1);
    robot->category = numbers.try_emplace(&model, next).first->second;
  }
  for (const auto& [model, number] : numbers) {
    Category category{number, numbers.size() == 1 ? "robot" : "robot_" + model->name(), {model->objects()[0].name}};
    for (const int joint : model->joints()) {
      category.keypoints.push_back(model->objects()[static_cast<std::size_t>(joint)].name);
    }
    category.keypoints.emplace_back("front");
    categories_.push_back(std::move(category));
  }
  std::ranges::sort(categories_, {}, &Category::number);
}

}  // namespace murosimf::dataset
