// include/murosimf/sensors.h: readings and pictures by name.
#include "murosimf/sensors.h"

#include <gtest/gtest.h>

#include "murosimf/scene.h"

namespace murosimf::api {
namespace {

TEST(ApiSensor, ShowsTheSpecificForceOfARobotAtRest) {
  Scene scene = Scene::of_robot("kid21", {.set = {"robot.level=simplified_dynamics"}});
  const Robot robot = scene.robot();
  ASSERT_FALSE(robot.sensors().empty());
  const Sensor imu = robot.sensor("imu");
  const std::span<const double> acceleration = imu.values("accelerometer");
  scene.run(1.0);
  EXPECT_EQ(imu.type(), "imu");
  EXPECT_GT(imu.samples(), 10U);
  EXPECT_GT(imu.time(), 0.9);
  EXPECT_NEAR(acceleration[2], 9.81, 0.5) << "the same memory shows new samples";
  EXPECT_EQ(imu.values("accelerometer").data(), acceleration.data());
  std::size_t numbers = 0;
  for (const SensorOutput& output : imu.outputs()) {
    EXPECT_EQ(output.begin, numbers);
    numbers += output.size;
    EXPECT_EQ(output.labels.size(), output.size);
  }
  EXPECT_EQ(imu.values().size(), numbers);
  EXPECT_THROW((void)robot.sensor("imo"), UnknownName);
  EXPECT_THROW((void)imu.values("gyro"), UnknownName);
}

TEST(ApiCamera, DrawsIfItIsAskedForAtTheStart) {
  Scene scene("six_cameras");
  const Robot robot = scene.robot("blue1");
  ASSERT_EQ(robot.cameras(), std::vector<std::string>{"camera"});
  EXPECT_THROW((void)robot.camera("eye"), UnknownName);
  const Camera camera = robot.camera("camera");
  scene.run(0.2);
  if (camera.pictures() == 0) GTEST_SKIP() << "cameras cannot be drawn here";
  const Image image = camera.picture();
  EXPECT_EQ(image.rgb.size(), static_cast<std::size_t>(3 * image.width * image.height));
  EXPECT_GT(image.width, 10);
  EXPECT_LE(camera.time(), scene.time());
  EXPECT_GT(camera.period(), 0);
}

TEST(ApiCamera, DrawsFromWhenItIsAskedFor) {
  Scene scene("six_cameras", {.set = {"*.sensors.camera.always_on=false"}});
  scene.run(0.1);
  const Camera of_file = scene.robot("blue1").camera("camera");
  Robot guest = scene.add(NewRobot{.name = "guest", .model = "kid21", .position = {0, 1.5, 0}});
  for (const std::string& name : guest.cameras()) (void)guest.camera(name);
  EXPECT_EQ(of_file.pictures(), 0U);
  scene.run(0.2);
  EXPECT_GT(of_file.pictures(), 0U);
  EXPECT_GT(of_file.picture().rgb.size(), 100U);
  for (const std::string& name : guest.cameras()) EXPECT_GT(guest.camera(name).pictures(), 0U) << name;
}

TEST(ApiCamera, SaysThatNothingIsDrawn) {
  Scene scene("six_cameras", {.cameras = false});
  scene.step();
  try {
    (void)scene.robot("blue1").camera("camera");
    FAIL() << "it draws nothing";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("nothing is drawn for cameras of this scene"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace murosimf::api
