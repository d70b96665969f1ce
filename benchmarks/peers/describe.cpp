/// murosimf_peer_describe FOLDER SECONDS - writes FOLDER/description.json of FOLDER/scene.toml: robots, what stands around them, and what
/// our controllers ask of the joints for so many simulated seconds.
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "benchmarks/peers/description.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/math/quaternion.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"

namespace {

using namespace murosimf;

constexpr double cycle = 0.01;  // [s] of control software

peers::Vector numbers(const Vec3d& v) { return {v.x, v.y, v.z}; }
peers::Quaternion numbers(const Quaterniond& q) { return {q.w, q.x, q.y, q.z}; }

/// False for a plane, which every engine has as its ground.
bool describe(const PlacedShape& shape, const Transformd& object, std::vector<peers::Shape>& shapes) {
  const Transformd place = object * shape.place();
  peers::Shape result{.position = numbers(place.position), .rotation = numbers(from_matrix(place.orientation))};
  result.kind = shape_name(shape.shape);
  if (const auto* sphere = std::get_if<Sphere>(&shape.shape)) {
    result.size = {sphere->radius, 0, 0};
  } else if (const auto* box = std::get_if<Box>(&shape.shape)) {
    result.size = numbers(box->half_size);
  } else if (const auto* capsule = std::get_if<Capsule>(&shape.shape)) {
    result.size = {capsule->radius, capsule->half_length, 0};
  } else if (std::get_if<Plane>(&shape.shape)) {
    return false;
  } else {
    throw SetupError(fmt::format("a shape of the kind {}: peers know spheres, boxes and capsules", result.kind));
  }
  shapes.push_back(std::move(result));
  return true;
}

void describe_shapes(const Model& model, int object, std::vector<peers::Shape>& shapes) {
  const auto* own = model.find(properties::shapes, object);
  if (!own) return;
  const FixedObject place = model.placement(object);
  for (const PlacedShape& shape : *own) {
    if (shape.collides) describe(shape, {place.offset, place.turn}, shapes);
  }
}

void describe_servo(const Model& model, int joint, peers::Link& link) {
  const Servo* servo = model.find(properties::servo, joint);
  if (!servo) throw SetupError(fmt::format("joint {} has no servo", link.joint));
  link.gain = servo->position_gain;
  link.damping = servo->stall_torque / servo->no_load_speed + servo->friction.viscous;
  link.limit = servo->stall_torque;
  link.armature = servo->rotor_inertia;
  link.friction = servo->friction.coulomb;
}

std::vector<peers::Link> describe_links(const Model& model) {
  std::vector<peers::Link> links;
  for (const Link& link : model.tree().links) {
    const SymMat3d& I = link.inertia;
    peers::Link result{.parent = link.parent,
                       .axis = numbers(link.axis),
                       .offset = numbers(link.offset),
                       .rotation = numbers(from_matrix(link.turn)),
                       .mass = link.mass,
                       .center = numbers(link.com),
                       .inertia = {I.xx, I.yy, I.zz, I.xy, I.xz, I.yz}};
    if (link.kind == LinkKind::prismatic) throw SetupError("a joint that slides: peers know hinges");
    if (link.kind == LinkKind::base) {
      result.rotation = {1, 0, 0, 0};
    } else {
      result.joint = model.objects()[static_cast<std::size_t>(link.object)].name;
      describe_servo(model, link.object, result);
    }
    links.push_back(std::move(result));
  }
  for (int i = 0; i < model.size(); ++i) {
    describe_shapes(model, i,
                    links[static_cast<std::size_t>(model.tree().link_of[static_cast<std::size_t>(i)])].shapes);
  }
  return links;
}

void append_joints(const Entity& robot, const Property<double>& property, std::vector<double>& values) {
  const auto& column = robot.find(property)->values;
  const auto& links = robot.model().tree().links;
  for (std::size_t i = 1; i < links.size(); ++i) values.push_back(column[static_cast<std::size_t>(links[i].object)]);
}

std::vector<Entity*> robots_of(scene::Scene& scene) {
  std::vector<Entity*> robots;
  for (const auto& robot : scene.spec().robots) robots.push_back(&scene.simulation().world().entity(robot.name));
  if (robots.empty()) throw SetupError("the scene has no robots");
  for (const Entity* robot : robots) {
    if (&robot->model() != &robots.front()->model()) throw SetupError("robots of several models: peers know one");
  }
  return robots;
}

peers::Description describe(scene::Scene& scene, double duration) {
  Simulation& simulation = scene.simulation();
  simulation.initialize();
  const auto robots = robots_of(scene);
  peers::Description result{.step = 1.0 / scene.spec().rate,
                            .friction = scene.spec().field.friction.value_or(0),
                            .links = describe_links(robots.front()->model())};
  result.steps_per_cycle = static_cast<int>(std::lround(cycle / result.step));
  const Model& field = simulation.world().entity("field").model();
  for (int i = 0; i < field.size(); ++i) describe_shapes(field, i, result.statics);
  for (Entity* robot : robots) {
    peers::Start start{.position = numbers(robot->base().get(properties::position)),
                       .rotation = numbers(robot->base().get(properties::base_quaternion))};
    append_joints(*robot, properties::joint_position, start.joints);
    result.robots.push_back(std::move(start));
  }
  while (seconds(simulation.now()) < duration) {
    simulation.run(from_seconds(cycle));
    auto& row = result.targets.emplace_back();
    for (const Entity* robot : robots) append_joints(*robot, properties::joint_target, row);
  }
  return result;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    if (count != 3) throw SetupError("usage: murosimf_peer_describe FOLDER SECONDS");
    char* end = nullptr;
    const double duration = std::strtod(arguments[2], &end);
    if (*end != 0 || !(duration > 0 && duration <= 1000)) {
      throw SetupError(fmt::format("seconds '{}': write a number above 0, up to 1000", arguments[2]));
    }
    const std::filesystem::path folder = arguments[1];
    scene::Scene scene(folder / "scene.toml", {.cameras = false});
    const peers::Description description = describe(scene, duration);
    peers::write_description(description, folder / "description.json");
    fmt::print("{{\"robots\": {}, \"cycles\": {}}}\n", description.robots.size(), description.targets.size());
  } catch (const std::exception& error) {
    fmt::print(stderr, "murosimf_peer_describe: {}\n", error.what());
    return 1;
  }
}
