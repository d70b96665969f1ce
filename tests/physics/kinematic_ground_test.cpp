// Kinematic walking on what stands on the field: plates, ramps, steps.
#include <gtest/gtest.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/feet.h"
#include "murosimf/scene/scene.h"
#include "tests/law.h"
#include "tests/physics/rig.h"
#include "tests/written_scene.h"

namespace murosimf::test {
namespace {

const std::string walker =
    "[field]\ngoals = false\n[[robots]]\nname = 'r'\nmodel = 'kid21'\nsensors = false\ncontroller = 'walk'\n";

/// A robot at kinematic_walking on a field with a body.
struct Walker {
  Walker(const std::string& robot, const std::string& body)
      : scene(fixtures::write_scene(walker + robot + "\n[[bodies]]\nname = 'body'\nstatic = true\n" + body)),
        entity(scene.simulation().world().entity("r")) {}
  void run(double s) { scene.simulation().run(from_seconds(s)); }
  [[nodiscard]] Vec3d place() { return entity.base().get(properties::position); }
  /// [m] of the foot that stands, above z = 0.
  [[nodiscard]] double standing_height() {
    const auto feet = feet_of(entity.model());
    const auto& foot = feet[entity.base().get(properties::stance_foot) != 0 ? 1 : 0];
    const ObjectAccess sole(entity, foot.object);
    return sole.get(properties::position).z;
  }

  scene::Scene scene;
  Entity& entity;
};

// The case of a stranger: from servos to the kinematic level and back, on a plate of 19 mm.
TEST(KinematicGround, ARobotOnAPlateStaysThere) {
  Walker robot("level = 'articulated_dynamics'\ncommand = [0, 0, 0]\nposition = [0, 0, 0.019]",
               "shape = 'box'\nsize = [0.6, 0.6, 0.019]\n");
  robot.run(1);
  const double before = robot.place().z;
  robot.scene.exchange_level("r", "kinematic_walking");
  law::Worst way;
  double last = before;
  for (int i = 0; i < 1000; ++i) {
    robot.run(1e-3);
    way.see(1e3 * std::abs(robot.place().z - last), "step", i);
    last = robot.place().z;
  }
  EXPECT_NEAR(robot.standing_height(), 0.019, 1e-3);
  robot.scene.exchange_level("r", "articulated_dynamics");
  for (int i = 0; i < 1000; ++i) {
    robot.run(1e-3);
    way.see(1e3 * std::abs(robot.place().z - last), "step", 1000 + i);
    last = robot.place().z;
  }
  law::expect_below(
      {.law = "a robot on a plate changes to kinematic_walking and back: way of the base in a step, up or down",
       .level = "kinematic_walking, articulated_dynamics",
       .source = "it stands on the plate at either"},
      way, 0.3, "mm");
  EXPECT_NEAR(robot.place().z, before, 5e-3);
}

// The walk on a slope is that on the plane, turned: the way along it is the same, and the base stands across it.
TEST(KinematicGround, WalksUpARampAsOnThePlane) {
  const double angle = 6 * degree;
  // its top goes through the origin
  const double lowest = -0.05 / std::cos(angle) - 4 * std::sin(angle) - 0.05 * std::cos(angle);
  const std::string body =
      "shape = 'box'\nsize = [8, 2, 0.1]\npitch_deg = -6\nposition = [0, 0, " + std::to_string(lowest) + "]\n";
  Walker plane("level = 'kinematic_walking'\ncommand = [0.15, 0, 0]",
               "shape = 'box'\nsize = [0.1, 0.1, 0.1]\nposition = [5, 5, 0]\n");
  plane.run(1);
  Walker ramp("level = 'kinematic_walking'\ncommand = [0.15, 0, 0]\nposition = [0.5, 0, 0.0526]", body);
  ramp.run(1);
  const Vec3d plane_start = plane.place(), start = ramp.place();
  plane.run(6);
  ramp.run(6);
  const Vec3d flat = plane.place() - plane_start, up = ramp.place() - start;
  law::expect_near({.law = "kinematic walk up a ramp of 6 degrees: slope of its way",
                    .level = "kinematic_walking",
                    .source = "the ramp's"},
                   std::atan2(up.z, up.x) / degree, 6, 0.3, "deg");
  law::expect_near({.law = "kinematic walk up a ramp of 6 degrees: way in 6 s, as a part of that on the plane",
                    .level = "kinematic_walking",
                    .source = "the same walk, turned"},
                   std::hypot(up.x, up.z) / flat.x, 1, 0.03, "");
  const Vec3d z = ramp.entity.base().get(properties::orientation).z;
  const Vec3d level = plane.entity.base().get(properties::orientation).z;
  EXPECT_NEAR(std::atan2(z.x, z.z) - std::atan2(level.x, level.z), -angle, 1.5 * degree);
}

// Up a step of 15 mm and down again behind it: smooth, and on it while it is there.
TEST(KinematicGround, StepsUpAndDown) {
  Walker robot("level = 'kinematic_walking'\ncommand = [0.2, 0, 0]",
               "shape = 'box'\nsize = [1, 2, 0.015]\nposition = [0.9, 0, 0]\n");
  robot.run(1e-3);
  double highest = 0, last = robot.place().z;
  law::Worst way;
  for (int i = 0; i < 12000; ++i) {
    robot.run(1e-3);
    highest = std::max(highest, robot.standing_height());
    way.see(1e3 * std::abs(robot.place().z - last), "step", i);
    last = robot.place().z;
  }
  EXPECT_NEAR(highest, 0.015, 3e-3);
  EXPECT_GT(robot.place().x, 1.7);
  EXPECT_NEAR(robot.standing_height(), 0, 2.5e-3) << "behind the step it stands on the field";
  law::expect_below({.law = "kinematic walk over a step of 15 mm: way of the base in a step of 1 ms, up or down",
                     .level = "kinematic_walking",
                     .source = "what falls 15 mm is as fast as 0.54 m/s"},
                    way, 0.6, "mm");
}

// Rule: a wall is no ground, however near, and neither is what is higher than a foot can step.
TEST(KinematicGround, AWallIsNoGround) {
  Walker robot("level = 'kinematic_walking'\ncommand = [0.2, 0, 0]",
               "shape = 'box'\nsize = [0.5, 2, 0.5]\nposition = [0.6, 0, 0]\n");
  for (int i = 0; i < 60; ++i) {
    robot.run(0.1);
    EXPECT_LT(std::abs(robot.standing_height()), 5e-3);
  }
  EXPECT_LT(robot.place().x, 0.4) << "it walks against it";
}

}  // namespace
}  // namespace murosimf::test
