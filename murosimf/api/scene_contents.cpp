// include/murosimf/scene.h: entities of a scene, contacts, rays, pictures.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "murosimf/api/images.h"
#include "murosimf/api/scene_inside.h"
#include "murosimf/api/told.h"
#include "murosimf/collision/touches.h"
#include "murosimf/render/renderer.h"

namespace murosimf {

namespace api {
namespace {

const std::string& object_name(const Entity& entity, int object) {
  return entity.model().objects()[static_cast<std::size_t>(object)].name;
}

/// Whether the other entity lists the point as well, and comes first.
bool was_listed(const World& world, const std::vector<Entity*>& moving, const collision::Touch& touch) {
  const bool moves = std::ranges::find(moving, touch.other) != moving.end();
  return moves && world.index_of(touch.other) < world.index_of(touch.entity);
}

/// A size that a shape does not use is ignored; those that it uses must be above 0.
Shape shape_of(const NewBody& body) {
  const Vector3& size = body.size;
  const bool is_box = body.shape == NewBody::Shape::box;
  const bool is_long = body.shape == NewBody::Shape::capsule || body.shape == NewBody::Shape::cylinder;
  const bool good = is_finite(size) && size.x > 0 && (!is_box || size.y > 0) && (!(is_box || is_long) || size.z > 0);
  if (!good) throw InputError(fmt::format("size of '{}' is not above 0", body.name));
  switch (body.shape) {
    case NewBody::Shape::box: return Box{0.5 * vec(size)};
    case NewBody::Shape::capsule: return Capsule{size.x, 0.5 * size.z};
    case NewBody::Shape::cylinder: return Cylinder{size.x, 0.5 * size.z};
    case NewBody::Shape::sphere: break;
  }
  return Sphere{size.x};
}

sensors::Perspective perspective_of(const Viewpoint& from) {
  constexpr int largest = 8192;  // [px]
  if (from.width < 1 || from.height < 1 || from.width > largest || from.height > largest) {
    throw InputError(fmt::format("a picture of {} x {} pixels: 1 to {} each", from.width, from.height, largest));
  }
  if (!(from.field_of_view > 0 && from.field_of_view < pi)) {
    throw InputError(fmt::format("a field of view of {} rad: more than 0, less than pi", from.field_of_view));
  }
  const Vec3d toward = vec(from.look_at) - vec(from.eye);
  if (!is_finite(from.eye) || !is_finite(from.look_at) || norm(toward) == 0) {
    throw InputError("eye and look_at are no two places");
  }
  const Vec3d forward = (1 / norm(toward)) * toward;
  Vec3d right = cross(forward, Vec3d{0, 0, 1});
  if (norm(right) == 0) right = {1, 0, 0};  // looking straight down: x to the right
  right = (1 / norm(right)) * right;
  const double side = std::tan(0.5 * from.field_of_view), up = side * from.height / from.width;
  return {.eye = vec(from.eye),
          .axes = {right, cross(forward, right), forward},
          .left = -side,
          .right = side,
          .top = -up,
          .bottom = up,
          .width = from.width,
          .height = from.height};
}

}  // namespace
}  // namespace api

inline namespace v0 {

using api::told;

std::vector<std::string> Scene::robots() const {
  std::vector<std::string> names;
  for (const Entity* robot : inside().scene.parts().robots) names.push_back(robot->name());
  return names;
}

std::vector<std::string> Scene::entities() const {
  std::vector<std::string> names;
  for (const auto& entity : inside().world().entities()) names.push_back(entity->name());
  return names;
}

Robot Scene::robot(std::string_view name) const {
  for (const Entity* robot : inside().scene.parts().robots) {
    if (robot->name() == name) return {inside_, inside().world().index_of(robot)};
  }
  const std::vector<std::string> known = robots();
  api::throw_unknown("robot", name, {known.begin(), known.end()});
}

Robot Scene::robot() const {
  const auto& all = inside().scene.parts().robots;
  if (all.empty()) throw InputError(fmt::format("scene '{}' has no robot", name()));
  return {inside_, inside().world().index_of(all[0])};
}

EntityHandle Scene::entity(std::string_view name) const { return {inside_, inside().number_of(name)}; }

/// The checks are those of scene files; this part only names what a program has given.
Robot Scene::add(const NewRobot& robot) {
  api::check_finite(robot.position, fmt::format("position of '{}'", robot.name));
  scene_file::RobotSpec spec;
  spec.name = robot.name;
  spec.model = robot.model;
  spec.where = "a robot that is added";
  spec.level = robot.level;
  spec.controller = robot.controller;
  spec.team = robot.team;
  spec.position = api::vec(robot.position);
  spec.heading = robot.heading;
  return told([&] {
    const Entity& added = inside().scene.add(std::move(spec));
    inside().begun = true;
    inside().queries.reset();
    return Robot(inside_, inside().world().index_of(&added));
  });
}

EntityHandle Scene::add(const NewBody& body) {
  api::check_finite(body.position, fmt::format("position of '{}'", body.name));
  api::check_finite(body.velocity, fmt::format("velocity of '{}'", body.name));
  scene_file::BodySpec spec;
  spec.name = body.name;
  spec.where = "a body that is added";
  spec.shape = api::shape_of(body);
  spec.mass = body.mass;
  spec.material = body.material;
  spec.position = api::vec(body.position);
  spec.heading = body.heading;
  spec.velocity = api::vec(body.velocity);
  return told([&] {
    const Entity& added = inside().scene.add(std::move(spec));
    inside().begun = true;
    inside().queries.reset();
    return EntityHandle(inside_, inside().world().index_of(&added));
  });
}

void Scene::leave(std::string_view entity) {
  inside().begin();
  told([&] { inside().scene.leave(entity); });
}

void Scene::enter(std::string_view entity) {
  inside().begin();
  told([&] { inside().scene.enter(entity); });
}

std::vector<Contact> Scene::contacts() const {
  inside().begin();
  const World& world = inside().world();
  const std::vector<Entity*>& moving = inside().scene.moving_entities();
  std::vector<Contact> contacts;
  for (const Entity* entity : moving) {
    bool second_of_two = false;  // contacts with itself are listed twice
    for (const collision::Touch& touch : collision::touches(world, *entity)) {
      if (api::was_listed(world, moving, touch)) continue;
      if (touch.other == entity && std::exchange(second_of_two, !second_of_two)) continue;
      contacts.push_back({entity->name(), api::object_name(*entity, touch.object), touch.other->name(),
                          api::object_name(*touch.other, touch.other_object), api::vector_of(touch.point),
                          api::vector_of(touch.normal), api::vector_of(touch.force), touch.depth});
    }
  }
  return contacts;
}

std::optional<RayHit> Scene::cast(const Vector3& origin, const Vector3& direction, double range,
                                  std::string_view without) const {
  api::check_finite(origin, "origin of the ray");
  api::check_finite(direction, "direction of the ray");
  const double length = norm(api::vec(direction));
  if (!(length > 0) || !(range > 0)) throw InputError("a ray has a direction, and a range above 0");
  const Entity* through = without.empty() ? nullptr : &inside().entity(inside().number_of(without));
  const auto hit = inside().fresh_queries().cast({api::vec(origin), (1 / length) * api::vec(direction)},
                                                 {.range = range, .without = through});
  if (!hit) return std::nullopt;
  return RayHit{hit->body.entity->name(), api::object_name(*hit->body.entity, hit->body.object), hit->distance,
                api::vector_of(hit->point), api::vector_of(hit->normal)};
}

/// Queries see the scene as it is now, not as at the last step.
std::optional<double> Scene::distance(std::string_view a, std::string_view b) const {
  const Entity& first = inside().entity(inside().number_of(a));
  const Entity& second = inside().entity(inside().number_of(b));
  return told([&]() -> std::optional<double> {
    const auto gap = inside().fresh_queries().distance({&first}, {&second});
    return gap ? std::optional(gap->distance) : std::nullopt;
  });
}

/// The painter is made at the first picture: most programs want none.
Image Scene::picture(const Viewpoint& from) const {
  const sensors::Perspective perspective = api::perspective_of(from);
  inside().begin();
  return told([&] {
    if (!inside().painter) {
      const auto for_people = [](scene_file::LightSpec& light) { light.shadows = true; };
      inside().painter = std::make_unique<scene::ScenePainter>(inside().scene, for_people);
    }
    sensors::View view;
    render::Renderer& renderer = inside().painter->renderer();
    renderer.draw(perspective, {.color = true, .depth = true, .labels = true}, 0, view);
    if (const std::string trouble = renderer.trouble(); !trouble.empty()) throw SetupError(trouble);
    return api::image_of(view.color, {}, view.depth, view.labels);
  });
}

}  // namespace v0
}  // namespace murosimf
