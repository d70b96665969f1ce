// A car drives into ten robots (paper, Fig. 12): they fall over, nobody sinks in or flies off, no energy from nowhere.
#include <gtest/gtest.h>

#include "murosimf/collision/ground_points.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/scene/scene.h"
#include "tests/law.h"
#include "tests/physics/mechanics.h"
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

struct Crash {
  Crash() : scene("car_crash") {
    scene.simulation().initialize();
    for (const scene_file::RobotSpec& robot : scene.spec().robots)
      robots.push_back(&scene.simulation().world().entity(robot.name));
  }
  /// [J] kinetic, and potential above the ground.
  [[nodiscard]] double energy() const {
    double sum = 0;
    for (Entity* robot : robots) {
      sum += kinetic_energy(*robot);
      for (const MovingBody& body : moving_bodies(*robot)) sum += body.mass * g * body.center.z;
    }
    return sum;
  }
  /// [W] of the car's motors; the robots' joints stand still.
  [[nodiscard]] double power() const {
    double sum = 0;
    Entity& car = *robots.front();
    for (const int joint : car.model().joints()) {
      sum += car.find(properties::joint_torque)->values[joint] * car.find(properties::joint_velocity)->values[joint];
    }
    return sum;
  }
  /// [m] how deep the lowest point of all bodies is in the ground.
  [[nodiscard]] double depth() const {
    double lowest = 0;
    for (Entity* robot : robots) {
      const auto& r = robot->find(properties::position)->values;
      const auto& R = robot->find(properties::orientation)->values;
      for (const auto& shape : collision::ground_shapes(robot->model())) {
        lowest = std::min(lowest, collision::lowest_point(shape, r[shape.object], R[shape.object], {}));
      }
    }
    return -lowest;
  }

  scene::Scene scene;
  std::vector<Entity*> robots;  // the car is the first
};

TEST(CarCrash, RobotsFallOverAndNoEnergyComesFromNowhere) {
  Crash crash;
  const double start = crash.energy();
  law::Worst gain, depth, height;
  double work = 0;
  for (int i = 1; i <= 4000; ++i) {
    crash.scene.simulation().step();
    work += 1e-3 * crash.power();
    gain.see(crash.energy() - start - work, "time", 1e-3 * i);
    if (i % 20 != 0) continue;
    depth.see(crash.depth(), "time", 1e-3 * i);
    for (Entity* robot : crash.robots) height.see(Rig::place(*robot).z, "time", 1e-3 * i);
  }
  int fallen = 0;
  for (Entity* robot : crash.robots) {
    fallen += robot->base().get(properties::falls) > 0 ? 1 : 0;
    EXPECT_FALSE(robot->frozen()) << robot->name();
    EXPECT_LT(norm(Rig::place(*robot)), 3.5) << robot->name() << " left the field";
  }
  EXPECT_GE(fallen, 5) << "of ten";
  const std::string levels = "articulated car, simplified robots";
  law::expect_below({.law = "a car drives into ten robots: energy above that at the start and the motors' work",
                     .level = levels,
                     .source = "conservation of energy"},
                    gain, 0.5, "J");
  law::expect_below({.law = "a car drives into ten robots: lowest point under the ground",
                     .level = levels,
                     .source = "nobody sinks in, not even for a moment"},
                    depth, 0.02, "m");
  // a point of the heap that carries two robots and the car's weight instead of an eighth of one, which sinks 0.4 mm
  EXPECT_LT(crash.depth(), 0.01) << "at the end";
  law::expect_below({.law = "a car drives into ten robots: highest base, which stands at 0.29 m",
                     .level = levels,
                     .source = "nobody flies off"},
                    height, 0.6, "m");
}

}  // namespace
}  // namespace murosimf::test
