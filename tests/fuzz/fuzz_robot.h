/// fuzz_robot.h - a robot file, and the first steps of the robot that it makes.
#pragma once

#include "murosimf/dynamics/articulated_dynamics.h"
#include "murosimf/robot/robot_reader.h"
#include "murosimf/runtime/simulation.h"
#include "tests/fuzz/fuzz.h"

namespace murosimf::fuzz {

/// Three steps without contact.
inline void step(const ModelPtr& model) {
  Simulation simulation;
  Entity& robot = simulation.world().add("robot", model);
  simulation.attach<dynamics::ArticulatedDynamics>("articulated_dynamics", robot, 1000);
  simulation.initialize();
  for (int i = 0; i < 3; ++i) simulation.step();
}

inline void feed_robot(const std::uint8_t* data, std::size_t size, const std::string& extension) {
  for (const bool lenient : {false, true}) {
    feed(data, size, extension, [&](const auto& file) { step(robot::read_robot(file, {.lenient = lenient}).model); });
  }
}

}  // namespace murosimf::fuzz
