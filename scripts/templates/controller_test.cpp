// The controller new_name: the way that a robot walks with it.
#include "murosimf/soccer/new_name.h"

#include <gtest/gtest.h>

#include "murosimf/locomotion/gait_properties.h"
#include "tests/physics/rig.h"

namespace murosimf::soccer {
namespace {

/// kid21 with the controller, as scenes attach it.
struct Walker {
  Walker() : robot(rig.add("robot", test::kid21())) {
    find_entry(catalog::controllers(), "controller", "new_name").attach(rig.simulation, robot, {});
    rig.attach_motion(robot, {.level = "kinematic_walking"});
  }
  [[nodiscard]] Vec3d place() const { return robot.base().get(properties::position); }

  test::Rig rig;
  Entity& robot;
};

TEST(NewName, CommandsItsVelocity) {
  Walker walker;
  walker.rig.run(0.1);
  EXPECT_EQ(norm(walker.robot.base().get(properties::walk_command) - NewNameOptions{}.velocity), 0);
}

// After two seconds it walks steadily. Steps last 0.3 s or so, and the base goes forward by jerks: 10 percent in 4 s.
TEST(NewName, WalksStraightOn) {
  Walker walker;
  walker.rig.run(2.0);
  const Vec3d start = walker.place();
  walker.rig.run(4.0);
  const double way = 4 * NewNameOptions{}.velocity.x;
  EXPECT_NEAR(walker.place().x - start.x, way, 0.1 * way);
  EXPECT_NEAR(walker.place().y - start.y, 0, 0.1 * way);
}

}  // namespace
}  // namespace murosimf::soccer
