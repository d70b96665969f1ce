// Sensors that show exactly where they are and how they move: a body that flies and turns, a sensor off its origin.
#include "murosimf/sensors/frame_sensors.h"

#include <gtest/gtest.h>

#include "tests/fixtures.h"
#include "tests/sensors/puppet.h"

namespace murosimf::sensors {
namespace {

using fixtures::difference;

const Mat3d turn = rotation_z(0.4) * rotation_x(-0.7);
const Vec3d velocity{1, -2, 0.5}, rate{0.3, 0.7, -1.1}, on_body{0.11, 0.23, 0.28};

/// It stays where it is, whatever its velocity.
test::BodyMotion pose(double) {
  return {.position = {3, 4, 5}, .orientation = turn, .velocity = velocity, .angular_velocity = rate};
}

/// What a sensor beside the frame "corner", turned about y, shows.
template <class S>
Vec3d shown() {
  test::SensorRig<S> rig(pose, {.name = "s",
                                .frame = "corner",
                                .position = on_body - Vec3d{0.1, 0.2, 0.3},
                                .orientation = rotation_y(0.9)});
  rig.run_until(0.01);
  const auto& values = rig.reading().values;
  EXPECT_EQ(values.size(), 3U);
  EXPECT_EQ(rig.reading().info->outputs[0].labels, (std::vector<std::string>{"x", "y", "z"}));
  return {values[0], values[1], values[2]};
}

const Vec3d of_the_place = velocity + cross(rate, turn* on_body);

TEST(FrameSensors, PositionIsThatOfTheSensor) {
  EXPECT_LT(difference(shown<Position>(), Vec3d{3, 4, 5} + turn * on_body), 1e-12);
}

TEST(FrameSensors, VelocitiesAreThoseOfTheSensorInEitherAxes) {
  EXPECT_LT(difference(shown<LinearVelocity>(), of_the_place), 1e-12);
  EXPECT_LT(difference(shown<Velocimeter>(), transpose(turn * rotation_y(0.9)) * of_the_place), 1e-12);
}

TEST(FrameSensors, AngularVelocityIsInAxesOfTheWorld) { EXPECT_LT(difference(shown<AngularVelocity>(), rate), 1e-12); }

}  // namespace
}  // namespace murosimf::sensors
