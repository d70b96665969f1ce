// Ground truth shows true poses and velocities at the instant of its time stamp.
#include "murosimf/sensors/ground_truth.h"

#include <gtest/gtest.h>

#include "tests/physics/rig.h"

namespace murosimf::sensors {
namespace {

TEST(GroundTruth, ShowsWhereEverybodyIs) {
  test::Rig rig;
  Entity& robot = rig.add("robot", test::kid21(), {.position = {1, 2, 0}, .heading = 0.5, .team = "blue"});
  Entity& ball = rig.add("ball", io::ball_model(), {.position = {0, 0, 1}});
  rig.simulation.attach<GroundTruth>("ground_truth", robot, 100, std::vector<Entity*>{&robot, &ball});
  rig.simulation.attach<motion::KinematicWalking>("kinematic_walking", robot, 1000);
  rig.attach_dynamics(ball, {.on_ground = false});
  rig.run(0.1);
  const Vec3d place = test::Rig::place(ball);  // at 0.1 s, when the next sample is due
  rig.simulation.step();
  const GroundTruthData data = robot.base().get(ground_truth);
  EXPECT_EQ(data.time, from_seconds(0.1));
  ASSERT_EQ(data.sightings.size(), 2u);
  EXPECT_TRUE(data.sightings[0].self);
  EXPECT_EQ(data.sightings[0].team, "blue");
  EXPECT_NEAR(data.sightings[0].heading, 0.5, 1e-9);
  EXPECT_NEAR(data.sightings[0].position.x, 1, 1e-9);
  EXPECT_FALSE(data.sightings[1].self);
  EXPECT_EQ(data.sightings[1].position.z, place.z);
  EXPECT_NEAR(data.sightings[1].velocity.z, -test::g * 0.1, 1e-9);
}

}  // namespace
}  // namespace murosimf::sensors
