// Cameras of robot files: their lenses, their directions, and their conversion.
#include <cmath>

#include "murosimf/multibody/kinematics.h"
#include "murosimf/robot/robot_checks.h"
#include "murosimf/robot/robot_conversion.h"
#include "murosimf/robot/robot_sensors.h"
#include "tests/fixtures.h"
#include "tests/robot/sensor_files.h"

namespace murosimf::robot {
namespace {

using namespace sensor_files;
using fixtures::error_of;
using fixtures::says;
using robot_formats::urdf::urdf_files::any_contains;
using robot_formats::urdf::urdf_files::contains;
using robot_formats::urdf::urdf_files::expect_near;
using sensors::SensorSpec;

using Numbers = std::map<std::string, double>;

/// A base with `inside` in line 2; `defaults` in line 1.
std::string mjcf(const std::string& inside, const std::string& defaults = "") {
  return "<mujoco model='r'>" + defaults +
         "<worldbody><body name='base'><freejoint/><inertial mass='1' pos='0 0 0' diaginertia='1 1 1'/>\n" + inside +
         "</body></worldbody></mujoco>";
}

RobotFile read(const std::string& inside, const std::string& defaults = "") {
  return read_robot(write("robot.xml", mjcf(inside, defaults)));
}

Numbers numbers_of(const std::string& attributes) {
  return read("<camera name='eye' " + attributes + "/>").description.sensors.at(0).numbers;
}

std::string error(const std::string& attributes) {
  return error_of([&] { (void)numbers_of(attributes); });
}

TEST(MjcfCameras, HaveTheOpeningOfTheirFovy) {
  const Numbers usual = numbers_of("");
  EXPECT_EQ(usual.at("width"), 640);
  EXPECT_EQ(usual.at("height"), 480);
  const double fy = 240 / std::tan(0.5 * 45 * pi / 180);  // square pixels: fx is the same
  EXPECT_NEAR(320 / std::tan(0.5 * usual.at("fov")), fy, 1e-9);
  const Numbers square = numbers_of("fovy='60' resolution='200 200'");
  EXPECT_NEAR(square.at("fov"), pi / 3, 1e-12);
  EXPECT_EQ(square.at("width"), 200);
}

// Rule: MuJoCo 4.0's own frustum of this camera (mjv_updateScene): at a distance of 0.02 m the picture reaches from
// 0.004 - 0.0128 to 0.004 + 0.0128 m to the right and from -0.0113725 to 0.0074510 m upward.
TEST(MjcfCameras, ShowWhatMuJoCoShowsOfALensOffTheMiddle) {
  const Numbers n =
      numbers_of("resolution='640 480' sensorsize='0.0064 0.0048' focal='0.005 0.0051' principal='0.001 0.0005'");
  EXPECT_FALSE(n.contains("fov"));
  const double distance = 0.02;
  EXPECT_NEAR(distance * (-0.5 - n.at("cx")) / n.at("fx"), 0.004 - 0.0128, 1e-9);
  EXPECT_NEAR(distance * (639.5 - n.at("cx")) / n.at("fx"), 0.004 + 0.0128, 1e-9);
  EXPECT_NEAR(distance * (n.at("cy") + 0.5) / n.at("fy"), 0.007450980, 1e-9);
  EXPECT_NEAR(distance * (n.at("cy") - 479.5) / n.at("fy"), -0.011372549, 1e-9);
  const Numbers in_pixels = numbers_of(
      "resolution='640 480' sensorsize='0.0064 0.0048' focalpixel='500 510' principalpixel='100 50' focal='9 9'");
  for (const auto& [key, number] : n) EXPECT_NEAR(in_pixels.at(key), number, 1e-9) << key;
}

TEST(MjcfCameras, TakeSettingsOfTheirClass) {
  const RobotFile robot =
      read("<camera name='eye' class='wide'/>",
           "<default><default class='wide'><camera fovy='90' resolution='100 50'/></default></default>");
  EXPECT_NEAR(robot.description.sensors.at(0).numbers.at("fov"), 2 * std::atan(2), 1e-12);
}

TEST(MjcfCameras, ImpossibleOnesAreRefused) {
  EXPECT_TRUE(says(error("fovy='180'"), {"robot.xml:2", "fovy 180"}));
  EXPECT_TRUE(says(error("resolution='0 480'"), {"robot.xml:2", "resolution '0 480'"}));
  EXPECT_TRUE(says(error("resolution='64.5 48'"), {"robot.xml:2", "whole numbers"}));
  EXPECT_TRUE(says(error("resolution='200000 48'"), {"robot.xml:2", "up to 100000"}));
  EXPECT_TRUE(says(error("sensorsize='0.01 0.01'"), {"robot.xml:2", "focal"}));
  EXPECT_TRUE(says(error("focal='0.01 0.01'"), {"robot.xml:2", "sensorsize"}));
  EXPECT_TRUE(says(error("mode='follow'"), {"robot.xml:2", "mode of camera"}));
}

/// Direction in the base's frame in which the description's sensor `number` has its axes.
Mat3d axes_in_base(const RobotFile& robot, std::size_t number) {
  const robot_formats::SensorDescription& sensor = robot.description.sensors.at(number);
  const Model& model = *robot.model;
  std::vector<Vec3d> r(model.size());
  std::vector<Mat3d> R(model.size());
  multibody::poses<double>(model.tree(), std::vector<double>(model.size(), 0.0), r, R);
  const int object = model.object_index(sensor.frame);
  const auto& tree = model.tree();
  for (const FixedObject& fixed : tree.fixed) {
    if (fixed.object == object) R[object] = R[tree.links[fixed.link].object] * fixed.turn;
  }
  return R[object] * sensor.place.orientation;
}

TEST(MjcfCameras, LookAlongX) {
  // x of the camera (right) is the base's -y, y (up) is z: it looks forward
  for (const char* name : {"name='eye'", ""}) {
    const RobotFile robot = read("<camera " + std::string(name) + " pos='0.1 0 0.2' xyaxes='0 -1 0 0 0 1'/>");
    const Mat3d axes = axes_in_base(robot, 0);
    expect_near(axes.x, {1, 0, 0});
    expect_near(axes.y, {0, 1, 0});
    expect_near(axes.z, {0, 0, 1});
  }
  // without any turn it looks down, with y up in the picture
  const Mat3d down = axes_in_base(read("<camera name='eye'/>"), 0);
  expect_near(down.x, {0, 0, -1});
  expect_near(down.z, {0, 1, 0});
}

TEST(MjcfCameras, ThatAreNotFixedAreNotes) {
  const RobotFile robot = read("<camera name='viewer' mode='trackcom'/><camera name='map' projection='orthographic'/>");
  EXPECT_TRUE(robot.sensors.empty());
  EXPECT_TRUE(any_contains(robot.notes, "robot.xml:2: sensor camera 'viewer'"));
  EXPECT_TRUE(any_contains(robot.notes, "not simulated"));
  EXPECT_FALSE(robot.model->find_object("viewer")) << "it has no fixed place";
}

std::string urdf_camera(const std::string& inside, const std::string& outside = "") {
  using namespace robot_formats::urdf::urdf_files;
  return robot_formats::urdf::urdf_files::robot_xml(link("head", solid()) +
                                                    joint("revolute", "base", "head", any_limit, "neck") +
                                                    "<gazebo reference='head'><sensor name='eye' type='camera'>" +
                                                    outside + "<camera>" + inside + "</camera></sensor></gazebo>");
}

Numbers urdf_numbers(const std::string& inside) {
  return read_robot(write("robot.urdf", urdf_camera(inside))).description.sensors.at(0).numbers;
}

TEST(UrdfCameras, HaveWhatTheFormatSaysByDefault) {
  EXPECT_EQ(urdf_numbers(""), (Numbers{{"width", 320}, {"height", 240}, {"fov", 1.047}}));
}

TEST(UrdfCameras, HaveTheLensOfTheFile) {
  const Numbers numbers = urdf_numbers(
      "<image><width>640</width><height>480</height></image><lens><intrinsics><fx>500</fx><fy>501</fy>"
      "<cx>320</cx><cy>240</cy></intrinsics></lens><distortion><k1>-0.2</k1><k3>0.1</k3></distortion>");
  EXPECT_EQ(numbers, (Numbers{{"width", 640},
                              {"height", 480},
                              {"fx", 500},
                              {"fy", 501},
                              {"cx", 319.5},
                              {"cy", 239.5},
                              {"k1", -0.2},
                              {"k2", 0},
                              {"k3", 0.1},
                              {"p1", 0},
                              {"p2", 0}}));
}

TEST(UrdfCameras, ImpossibleOnesAreRefused) {
  const auto what = [](const std::string& inside) { return error_of([&] { (void)urdf_numbers(inside); }); };
  EXPECT_TRUE(says(what("<horizontal_fov>0</horizontal_fov>"), {"robot.urdf", "horizontal_fov of the camera is 0"}));
  EXPECT_TRUE(says(what("<image><width>0</width></image>"), {"robot.urdf", "width of the image is 0"}));
  EXPECT_TRUE(says(what("<lens><intrinsics><fx>0</fx></intrinsics></lens>"), {"robot.urdf", "positive"}));
}

TEST(CamerasOfFiles, BecomeSensors) {
  const RobotFile robot = read("<camera name='left.eye' pos='0.1 0 0' xyaxes='0 -1 0 0 0 1'/><camera pos='0 0 0.3'/>");
  ASSERT_EQ(robot.sensors.size(), 2U);
  const SensorSpec &named = sensor_of(robot, "left_eye"), &other = sensor_of(robot, "camera");
  EXPECT_EQ(named.type, "camera");
  EXPECT_EQ(named.frame, "left.eye");
  EXPECT_EQ(named.rate, 25);
  EXPECT_EQ(named.number("width", 0), 640);
  EXPECT_EQ(other.frame, "base");
  EXPECT_EQ(other.position.z, 0.3);
  EXPECT_TRUE(any_contains(robot.notes, "assumed: 25 pictures per second"));
  for (const robot::Finding& finding : robot::examine_sensors(robot)) ADD_FAILURE() << robot::to_line(finding);
}

TEST(CamerasOfFiles, HaveRatesThatStepsAllow) {
  const auto period = [](const std::string& rate) {
    const RobotFile robot = read_robot(write("robot.urdf", urdf_camera("", "<update_rate>" + rate + "</update_rate>")));
    return 1000 / sensor_of(robot, "eye").rate;  // [ms]
  };
  EXPECT_EQ(period("30"), 34);
  EXPECT_EQ(period("20"), 50);
  EXPECT_EQ(period("100"), 10);
  EXPECT_EQ(period("5000"), 1);
}

RobotFile converted(const std::filesystem::path& file, std::string& mjcf) {
  const auto out = write("out/robot.xml", "");
  const RobotConversion conversion = convert_robot(file, {.folder = out.parent_path()});
  write("out/robot.toml", conversion.toml);
  mjcf = conversion.text;
  return read_robot(write("out/robot.xml", conversion.text));
}

TEST(ConvertedCameras, OfMjcfAreElementsAgain) {
  const auto file =
      write("robot.xml", mjcf("<camera name='a' pos='0.1 0 0' euler='10 20 30' fovy='70' resolution='64 48'/>"
                              "<camera name='b' resolution='640 480' sensorsize='0.0064 0.0048' "
                              "focal='0.005 0.0051' principal='0.001 0.0005'/>"
                              "<camera name='viewer' mode='track'/>"));
  std::string text;
  const RobotFile before = read_robot(file), after = converted(file, text);
  ASSERT_EQ(after.description.sensors.size(), 2U) << text;
  for (std::size_t i = 0; i < 2; ++i) {
    const robot_formats::SensorDescription &camera = after.description.sensors[i],
                                           &same = before.description.sensors[i];
    EXPECT_EQ(camera.name, same.name);
    ASSERT_EQ(camera.numbers.size(), same.numbers.size());
    for (const auto& [key, number] : same.numbers) EXPECT_NEAR(camera.numbers.at(key), number, 1e-9) << key;
    EXPECT_LT(fixtures::difference(axes_in_base(after, i), axes_in_base(before, i)), 1e-12);
  }
  EXPECT_TRUE(contains(text, "<!-- sensor camera 'viewer' at 'base' -->")) << text;
}

TEST(ConvertedCameras, OfUrdfAndWithoutNameAreInTheTomlFile) {
  const std::vector<std::filesystem::path> files{
      write("robot.urdf", urdf_camera("<distortion><p2>0.01</p2></distortion>", "<pose>1 2 3 0.1 0.2 0.3</pose>")),
      write("other.xml", mjcf("<camera pos='0.1 0 0' euler='10 20 30'/>"))};
  for (const auto& file : files) {
    std::string text;
    const RobotFile before = read_robot(file), after = converted(file, text);
    ASSERT_EQ(after.sensors.size(), 1U);
    for (const robot::Finding& finding : robot::examine_sensors(after)) ADD_FAILURE() << robot::to_line(finding);
    const SensorSpec &spec = after.sensors[0], &same = before.sensors.at(0);
    EXPECT_EQ(spec.name, same.name);
    EXPECT_EQ(spec.type, "camera");
    EXPECT_EQ(spec.frame, same.frame);
    EXPECT_EQ(spec.rate, same.rate);
    EXPECT_EQ(spec.numbers, same.numbers);
    EXPECT_LT(fixtures::difference(spec.orientation, same.orientation), 1e-12);
    expect_near(spec.position, same.position);
  }
}

}  // namespace
}  // namespace murosimf::robot
