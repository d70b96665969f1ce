/// range_rig.h - worlds without gravity in which things hang, fly and tumble, to be looked at by sensors.
#pragma once

#include <limits>

#include "murosimf/component_files/sensor_types.h"
#include "murosimf/dynamics/motion_properties.h"
#include "tests/fixtures.h"
#include "tests/physics/rig.h"

namespace murosimf::test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

struct RangeRig : Rig {
  explicit RangeRig(int threads = 1) : Rig(0.8, 0, 1000, threads) { simulation.world().gravity = {}; }

  /// Something that moves; where, says put().
  Entity& add_moving_entity(const std::string& name, ModelPtr model, const std::string& volume = "sphere") {
    EntityOptions options;
    options.collision.volume = volume;
    moving_entities.push_back(&add(name, std::move(model), options));
    return *moving_entities.back();
  }
  /// A box of 4.3 kg, 0.30 x 0.20 x 0.10 m.
  Entity& add_box(const std::string& name, const std::string& volume = "sphere") {
    return add_moving_entity(name, box_model(), volume);
  }
  Entity& add_ball(const std::string& name, double radius = 0.1) {
    return add_moving_entity(name, std::make_shared<const Model>(fixtures::ball_model(radius, 0.4)));
  }
  /// Boxes that stand in the world.
  void add_walls(const Shapes& walls) {
    add("walls", std::make_shared<const Model>("walls", Chain{}.base("walls").with(properties::shapes, walls)));
  }

  /// After all moving entities were added.
  const sensors::Reading& attach(Entity& robot, sensors::SensorSpec spec, std::uint64_t seed = 1) {
    if (spec.name.empty()) spec.name = spec.type;
    return component_files::attach_sensor(simulation, robot, spec, {seed, moving_entities}, rate).reading();
  }
  /// After all sensors were attached.
  void begin() {
    for (Entity* moving_entity : moving_entities) attach_dynamics(*moving_entity, {.on_ground = false});
    simulation.initialize();
  }
  static void put(Entity& entity, const Vec3d& place, const Mat3d& turn = {}) {
    entity.base().set(properties::position, place);
    entity.base().set(properties::orientation, turn);
    entity.base().set(properties::base_quaternion, from_matrix(turn));
  }

  std::vector<Entity*> moving_entities;
};

/// A sensor with the numbers that differ from their defaults.
inline sensors::SensorSpec sensor(const std::string& type, const std::map<std::string, double>& numbers = {}) {
  sensors::SensorSpec spec;
  spec.name = spec.type = type;
  spec.numbers = numbers;
  return spec;
}

/// Message of the error of attaching a sensor to a box beside a ball.
inline std::string error(const sensors::SensorSpec& spec) {
  RangeRig rig;
  Entity& robot = rig.add_box("robot");
  rig.add_ball("ball");
  return fixtures::error_of([&] { rig.attach(robot, spec); });
}

}  // namespace murosimf::test
