// A car follows its commands: straight, along circles of the requested radius, and standing.
#include "murosimf/locomotion/drive.h"

#include <gtest/gtest.h>

#include "murosimf/locomotion/gait_properties.h"
#include "tests/law.h"
#include "tests/physics/rig.h"

namespace murosimf::locomotion {
namespace {

ModelPtr car_model() {
  static const ModelPtr model = robot::read_robot(std::string(MUROSIMF_SOURCE_DIR) + "/models/car.xml").model;
  return model;
}

/// models/car.xml on the ground, driven at one level.
struct Driven {
  Driven(const std::string& level, const Vec3d& command, double slope = 0)
      : rig(0.8, slope), car(rig.add("car", car_model())) {
    rig.simulation.attach<Drive>("drive", car, Drive::rate_hz, command);
    rig.attach_dynamics(car, {.level = level});
  }
  [[nodiscard]] Vec3d place() const { return car.base().get(properties::position); }
  [[nodiscard]] double rate(const char* wheel) const { return car.object(wheel).get(properties::joint_velocity); }

  test::Rig rig;
  Entity& car;
};

/// Position of the middle of the rear axle [m].
Vec3d rear_axle(Entity& car) {
  return 0.5 * (car.object("rear_left_wheel").get(properties::position) +
                car.object("rear_right_wheel").get(properties::position));
}

/// Radius [m] of the circle through three points on the ground.
double radius_through(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d ab = b - a, ac = c - a;
  return norm(ab) * norm(ac) * norm(c - b) / (2 * std::abs(ab.x * ac.y - ab.y * ac.x));
}

class Drives : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Levels, Drives, testing::ValuesIn(test::dynamic_levels()), test::level_name);

// The remaining error: a wheel of 6 cm scrubs while it turns, rolling resistance slips the tires a little, steering servos yield
// by up to half a degree.
TEST_P(Drives, CirclesOfTheWantedRadius) {
  law::Worst error;
  for (const Vec3d& command : {Vec3d{1, 0, 0.5}, Vec3d{1, 0, -0.5}, Vec3d{-1, 0, 0.5}, Vec3d{0.5, 0, 0.5}}) {
    Driven driven(GetParam(), command);
    driven.rig.run(2.0);
    const Vec3d a = rear_axle(driven.car);
    driven.rig.run(1.0);
    const Vec3d b = rear_axle(driven.car);
    driven.rig.run(1.0);
    const double radius = std::abs(command.x / command.z);
    error.see(std::abs(radius_through(a, b, rear_axle(driven.car)) / radius - 1), "turning rate", command.z);
    const double turning = driven.car.base().get(properties::angular_velocity).z;
    EXPECT_GT(turning * command.z, 0) << "turns to the side of the command";
  }
  law::expect_below({.law = "a car on circles of 1 and 2 m at 0.5 and 1 m/s: error of the radius",
                     .level = GetParam() + ", drive",
                     .source = "speed over turning rate"},
                    error, 0.06, "");
}

TEST_P(Drives, StraightAtTheWantedSpeed) {
  Driven driven(GetParam(), {1, 0, 0});
  driven.rig.run(2.0);
  const Vec3d start = driven.place();
  driven.rig.run(2.0);
  law::expect_near({.law = "a car at 1 m/s: way in 2 s", .level = GetParam() + ", drive", .source = "speed times time"},
                   driven.place().x - start.x, 2, 0.01, "m");
  EXPECT_NEAR(driven.place().y, 0, 1e-3);
}

TEST_P(Drives, StaysOnItsFourWheels) {
  Driven driven(GetParam(), {2, 0, 1});
  law::Worst off;
  for (int i = 0; i < 30; ++i) {
    driven.rig.run(0.1);
    off.see(std::abs(driven.place().z - 0.08), "time", 0.1 * i);
  }
  law::expect_below({.law = "a car turns at 2 m/s: axle off its height of 8 cm",
                     .level = GetParam() + ", drive",
                     .source = "tires sink 0.4 mm at most"},
                    off, 2e-3, "m");
}

TEST_P(Drives, DoesNotCreepAtSpeedZero) {
  Driven driven(GetParam(), {});
  driven.rig.run(0.5);
  const Vec3d start = driven.place();
  driven.rig.run(2.0);
  EXPECT_LT(norm(driven.place() - start), 1e-5);
}

// Servos that hold a rate let the tires release their tension: a millimeter.
TEST_P(Drives, StopsAndKeepsItsSteering) {
  Driven driven(GetParam(), {1, 0, 0.5});
  driven.rig.run(1.5);
  const double steering = driven.car.object("steer_left").get(properties::joint_target);
  driven.car.base().set(properties::walk_command, {});
  driven.rig.run(1.5);
  const Vec3d start = driven.place();
  driven.rig.run(1.0);
  EXPECT_LT(norm(driven.place() - start), 2e-3);
  EXPECT_EQ(driven.car.object("steer_left").get(properties::joint_target), steering);
}

TEST_P(Drives, WheelsTurnForEver) {
  Driven driven(GetParam(), {3, 0, 0});
  driven.rig.run(2.0);
  for (int i = 0; i < 20; ++i) {
    driven.rig.run(0.05);
    EXPECT_LE(std::abs(driven.car.object("turn_rear_left").get(properties::joint_position)), pi);
  }
  EXPECT_NEAR(driven.rate("turn_rear_left"), 3 / 0.08, 0.2);
}

TEST(Drive, AxlesOfAllWheelsMeetInOnePoint) {
  Driven driven("full_dynamics", {1, 0, 0.8});
  driven.rig.run(1.0);
  const double left = driven.car.object("steer_left").get(properties::joint_target);
  const double right = driven.car.object("steer_right").get(properties::joint_target);
  // Ackermann: cot(outer) - cot(inner) = distance of the pivots over the wheel base
  EXPECT_NEAR(1 / std::tan(right) - 1 / std::tan(left), 0.23 / 0.38, 1e-12);
  EXPECT_GT(left, right) << "the inner wheel turns more";
}

TEST(Drive, EndsOfTheSteeringLimitTheCurvature) {
  const Vehicle vehicle = find_vehicle(*car_model());
  const double inner = 0.38 / std::tan(0.5) + 0.115;  // [m] radius at which the inner wheel is at its end
  EXPECT_NEAR(vehicle.greatest_curvature, 1 / inner, 1e-12);
  EXPECT_NEAR(vehicle.least_curvature, -1 / inner, 1e-12);
  Driven driven("full_dynamics", {0.5, 0, 9});
  driven.rig.run(1.5);
  EXPECT_NEAR(driven.car.object("steer_left").get(properties::joint_target), 0.5, 1e-12);
  EXPECT_NEAR(driven.car.base().get(properties::gait_velocity).x, 0.5, 1e-12) << "speed is kept";
}

TEST(Drive, FindsWheelsByWhatTheyAre) {
  const Vehicle vehicle = find_vehicle(*car_model());
  ASSERT_EQ(vehicle.wheels.size(), 4u);
  int steered = 0;
  for (const Wheel& wheel : vehicle.wheels) {
    EXPECT_TRUE(wheel.driven);
    EXPECT_EQ(wheel.radius, 0.08);
    EXPECT_NEAR(std::abs(wheel.y + wheel.outside), 0.15, 1e-12);
    EXPECT_NEAR(wheel.x, wheel.steering >= 0 ? 0.38 : 0, 1e-12);
    steered += wheel.steering >= 0 ? 1 : 0;
  }
  EXPECT_EQ(steered, 2);
}

std::string refusal(const Model& model) {
  try {
    (void)find_vehicle(model);
  } catch (const SetupError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Drive, RefusesWhatCannotBeDriven) {
  EXPECT_EQ(refusal(*test::kid21()),
            "model 'kid21' cannot be driven: it has no wheel, a cylinder about an endless hinge along y");
  PlacedShape roll;
  roll.shape = Cylinder{0.1, 0.02};
  roll.orientation = rotation(Vec3d{1, 0, 0}, pi / 2);
  const Model cart("cart", Chain{}.base().revolute("axle", {0, 1, 0}).with(properties::shapes, {roll}));
  EXPECT_EQ(refusal(cart),
            "model 'cart' cannot be driven: no wheel has a servo that follows a rate; give one a <velocity> actuator");
}

}  // namespace
}  // namespace murosimf::locomotion
