/// sensor_table_test - sensors from the TOML file beside a robot and from parts; errors have their place.
#include "murosimf/component_files/sensor_table.h"

#include <cmath>

#include "murosimf/component_files/sensor_sections.h"
#include "murosimf/files/data_path.h"
#include "murosimf/math/scalar.h"
#include "murosimf/robot/robot_checks.h"
#include "tests/fixtures.h"
#include "tests/robot/sensor_files.h"

namespace murosimf::component_files {
namespace {

using namespace robot::sensor_files;
using robot_formats::urdf::urdf_files::contains;
using sensors::SensorSpec;

TEST(SensorTable, ReadsAllThatASensorMayHave) {
  const robot::RobotFile robot = read_with(
      "[sensors.eyes]\ntype = 'imu'\nframe = 'imu'\nposition = [0.1, 0.2, 0.3]\nrpy_deg = [0, 0, 90]\nrate = 500\n"
      "delay = 0.002\nnoise = 0.5\n[sensors.eyes.gyroscope]\nrange = 34.9\nbits = 16\nlow_pass = 40\n"
      "[sensors.elbows]\ntype = 'joint_position'\njoints = ['elbow']\n");
  const SensorSpec& imu = sensor_of(robot, "eyes");
  EXPECT_EQ(imu.type, "imu");
  EXPECT_EQ(imu.frame, "imu");
  EXPECT_EQ(imu.position.y, 0.2);
  EXPECT_NEAR(imu.orientation.x.y, 1, 1e-15);  // x of the sensor is y of the frame
  EXPECT_EQ(imu.rate, 500);
  EXPECT_EQ(imu.delay, 0.002);
  EXPECT_EQ(imu.signal("accelerometer").noise, 0.5);
  EXPECT_EQ(imu.signal("gyroscope").noise, 0.5);
  EXPECT_EQ(imu.signal("gyroscope").lowest, -34.9);
  EXPECT_EQ(imu.signal("gyroscope").highest, 34.9);
  EXPECT_EQ(imu.signal("gyroscope").bits, 16);
  EXPECT_EQ(imu.signal("gyroscope").low_pass, 40);
  EXPECT_EQ(imu.signal("accelerometer").bits, 0);
  EXPECT_EQ(sensor_of(robot, "elbows").objects, std::vector<std::string>{"elbow"});
  EXPECT_TRUE(contains(imu.where, "robot.toml:1:"));
}

TEST(SensorTable, KeysOfTheSensorWinOverThoseOfItsPart) {
  write("mine.toml",
        "type = 'imu'\nrate = 100\ndelay = 0.01\nbias = 1\n[gyroscope]\nnoise_density = 2\nbits = 12\nrange = 4\n"
        "[accelerometer]\nnoise_density = 3\n");
  const robot::RobotFile robot = read_with(
      "[sensors.a]\npart = 'mine'\ndelay = 0.02\nnoise = 0.1\n[sensors.a.gyroscope]\nresolution = 0.25\n"
      "[sensors.b]\ntype = 'gyroscope'\npart = 'mine'\n");
  const SensorSpec& a = sensor_of(robot, "a");
  EXPECT_EQ(a.type, "imu");
  EXPECT_EQ(a.part, "mine");
  EXPECT_EQ(a.rate, 100);
  EXPECT_EQ(a.delay, 0.02);
  EXPECT_EQ(a.signal("gyroscope").noise_density, 2);
  EXPECT_EQ(a.signal("gyroscope").noise, 0.1) << "what stands in the sensor holds for all outputs, those of parts too";
  EXPECT_EQ(a.signal("gyroscope").bias, 1) << "and so does what stands at the top of the part";
  EXPECT_EQ(a.signal("gyroscope").resolution, 0.25);
  EXPECT_EQ(a.signal("gyroscope").bits, 0) << "a resolution takes the place of bits";
  EXPECT_EQ(a.signal("orientation").noise, 0.1);
  EXPECT_EQ(a.signal("orientation").noise_density, 0);
  EXPECT_EQ(sensor_of(robot, "b").signal("gyroscope").bits, 12);
  EXPECT_TRUE(robot::examine_sensors(robot).empty()) << "a gyroscope need not have the other outputs of its part";
}

TEST(SensorTable, ATableWithoutTypeChangesTheSensorOfTheFile) {
  const std::string gyro =
      "<gyro name='g' site='imu' noise='0.2'/><accelerometer name='a' site='imu'/>"
      "<velocimeter name='v' site='imu'/>";
  const robot::RobotFile robot =
      read_with("[sensors]\nv = false\n[sensors.g]\nrate = 250\n[sensors.a]\ntype = 'gyroscope'\n", gyro);
  EXPECT_EQ(robot.sensors.size(), 2u);
  EXPECT_EQ(sensor_of(robot, "g").rate, 250);
  EXPECT_EQ(sensor_of(robot, "g").frame, "imu");
  EXPECT_EQ(sensor_of(robot, "g").signal("gyroscope").noise, 0.2);
  EXPECT_EQ(sensor_of(robot, "a").type, "gyroscope");
  EXPECT_EQ(sensor_of(robot, "a").frame, "") << "one with a type takes its place and has nothing of it";
}

TEST(SensorTable, SectionsReadBackAsTheSameSensors) {
  const std::string text =
      "[sensors.a]\npart = 'bmi088'\nframe = 'imu'\nposition = [0.1, 0, -0.25]\nrpy_deg = [10, -20, 150]\nrate = 200\n"
      "[sensors.b]\ntype = 'joint_velocity'\njoints = ['elbow']\nrate = 30\nphase = 0.25\ndelay = 0.5\nlowest = "
      "-1\nhighest = 3\n"
      "[sensors.c]\ntype = 'contact_force'\nthreshold = 2.5\nrange = inf\n";
  const robot::RobotFile before = read_with(text);
  const robot::RobotFile after = read_with(sensor_sections(before.sensors));
  ASSERT_EQ(after.sensors.size(), 3u);
  const SensorSpec &a = sensor_of(before, "a"), &a2 = sensor_of(after, "a");
  EXPECT_EQ(a2.frame, a.frame);
  EXPECT_EQ(a2.position.z, a.position.z);
  for (const Vec3d& column : {a.orientation.x - a2.orientation.x, a.orientation.y - a2.orientation.y}) {
    EXPECT_LT(norm(column), 1e-13);
  }
  EXPECT_EQ(a2.signal("gyroscope").noise_density, a.signal("gyroscope").noise_density);
  EXPECT_EQ(a2.signal("accelerometer").highest, a.signal("accelerometer").highest);
  EXPECT_EQ(sensor_of(after, "b").signal("rate").lowest, -1);
  EXPECT_EQ(sensor_of(after, "b").delay, 0.5);
  EXPECT_EQ(sensor_of(after, "b").rate, 30);
  EXPECT_EQ(sensor_of(after, "b").phase, 0.25);
  EXPECT_EQ(sensor_of(after, "c").number("threshold", 0), 2.5);
  EXPECT_EQ(sensor_sections(after.sensors), sensor_sections(read_with(sensor_sections(after.sensors)).sensors));
}

class Part : public testing::TestWithParam<std::string> {};

TEST_P(Part, MakesASensorThatRuns) {
  robot::RobotFile robot = robot::read_robot(files::find_data_file("kid21", "models", ".xml"));
  robot.sensors.clear();
  SensorTable table{.name = "x", .where = "here", .values = {}, .outputs = {}};
  table.values["part"] = {GetParam(), "here"};
  table.values["frame"] = {std::string("l_sole"), "here"};
  change_sensors(robot.sensors, {table}, {});
  for (const robot::Finding& finding : robot::examine_sensors(robot)) ADD_FAILURE() << robot::to_line(finding);
  EXPECT_EQ(robot.sensors.at(0).part, GetParam());
  EXPECT_FALSE(robot.sensors.at(0).signals.empty() && robot.sensors.at(0).numbers.empty());
}

INSTANTIATE_TEST_SUITE_P(Shipped, Part, testing::ValuesIn(sensor_parts()), [](const auto& p) { return p.param; });

TEST(SensorParts, DensitiesAreTwoSided) {
  // IEEE 952: rms in a bandwidth B is N sqrt(2 B); the MPU-6050's data sheet: 0.05 deg/s rms in 100 Hz
  const robot::RobotFile robot = read_with("[sensors.a]\npart = 'mpu6050'\n");
  const double rms = sensor_of(robot, "a").signal("gyroscope").noise_density * std::sqrt(2 * 100.0);
  EXPECT_NEAR(rms, 0.05 * pi / 180, 0.001 * rms);
}

struct Error {
  const char* name;
  std::string text;
  int line;          ///< of the TOML file, that the message names
  const char* says;  ///< part of the message
};

void PrintTo(const Error& error, std::ostream* stream) { *stream << error.name; }

class SensorMistake : public testing::TestWithParam<Error> {};

TEST_P(SensorMistake, IsOneLineThatSaysWhere) {
  const Error& error = GetParam();
  write("bad.toml", "type = 'imu'\nrays = 3\n");
  std::string what = "no error";
  try {
    const robot::RobotFile robot = read_with(error.text);
    for (const robot::Finding& finding : robot::examine_sensors(robot))
      what = finding.where + ": " + finding.what + "; " + finding.advice;
  } catch (const SetupError& error) {
    what = error.what();
  }
  EXPECT_TRUE(contains(what, ".toml:" + std::to_string(error.line) + ":")) << what;
  EXPECT_TRUE(contains(what, error.says)) << what;
  EXPECT_FALSE(contains(what, "\n")) << what;
}

std::string imu(const std::string& lines) { return "[sensors.imu]\ntype = 'imu'\n" + lines; }
std::string gyro(const std::string& lines) { return "[sensors.imu]\ntype = 'imu'\n[sensors.imu.gyroscope]\n" + lines; }

std::vector<Error> errors() {
  return {
      {"UnknownTable", "[sensor.imu]\ntype = 'imu'\n", 1, "did you mean 'sensors'?"},
      {"NoTable", "[sensors]\nimu = 3\n", 2, "sensor 'imu' must be a table"},
      {"True", "[sensors]\nimu = true\n", 2, "sensor 'imu' must be a table"},
      {"TwoOfOneName", imu("[sensors.imu]\ntype = 'imu'\n"), 3, "imu"},
      {"NoType", "[sensors.imu]\nrate = 10\n", 1, "sensor 'imu' needs type"},
      {"UnknownType", "[sensors.imu]\ntype = 'gyroskope'\n", 2, "did you mean 'gyroscope'?"},
      {"TypeIsANumber", "[sensors.imu]\ntype = 3\n", 2, "'type' must be a name in quotes"},
      {"BadName", "[sensors.'a.b']\ntype = 'imu'\n", 1, "'a.b' is no name of a sensor"},
      {"UnknownKey", imu("rat = 10\n"), 3, "did you mean 'rate'?"},
      {"KeyOfAnotherType", imu("threshold = 1\n"), 3, "unknown key of sensor type 'imu', 'threshold'"},
      {"UnknownPart", imu("part = 'mpu605'\n"), 3, "unknown part 'mpu605'; did you mean 'mpu6050'?"},
      {"WrongPart", imu("part = 'bad'\n"), 2, "'rays'"},
      {"UnknownFrame", imu("frame = 'imo'\n"), 1, "did you mean 'imu'?"},
      {"FlatPosition", imu("position = [0, 1]\n"), 3, "three numbers in brackets"},
      {"InfinitePosition", imu("position = [0, 1, inf]\n"), 3, "it must be in the range 0 to 10000 m"},
      {"FarAway", imu("position = [1e308, 1e308, 0]\n"), 3,
       "'position' is [1e+308, 1e+308, 0]; it must be in the range 0 to 10000 m"},
      {"TinyRate", imu("rate = 1e-300\n"), 3, "'rate' is 1e-300; it must be in the range 0.001 to 1e+06 Hz"},
      {"RateZero", imu("rate = 0\n"), 3, "'rate' is 0; it must be in the range 0.001 to 1e+06 Hz"},
      {"NegativeRate", imu("rate = -5\n"), 3, "'rate' is -5; it must be in the range"},
      {"RateAboveTheSteps", imu("rate = 2000\n"), 1, "faster than"},
      {"RateAboveThatOfSteps", imu("rate = 1200\n"), 1, "is faster than the simulation's"},
      {"RateIsAText", imu("rate = 'fast'\n"), 3, "'rate' is a text; it must be a number"},
      {"NanRate", imu("rate = nan\n"), 3, "'rate' is nan; it must be"},
      {"NegativeDelay", imu("delay = -1\n"), 3, "'delay' is -1; it must be in the range 0 to 10 s"},
      {"LongDelay", imu("delay = 11\n"), 3, "'delay' is 11; it must be in the range 0 to 10 s"},
      {"TableForANumber", imu("[sensors.imu.rate]\nx = 1\n"), 4, "unknown key of a sensor's output 'x'"},
      {"TableInATable", gyro("[sensors.imu.gyroscope.x]\ny = 1\n"), 4, "'x' must not be a table"},
      {"UnknownOutput", imu("[sensors.imu.gyroskope]\nbias = 1\n"), 1, "did you mean 'gyroscope'?"},
      {"UnknownKeyOfAnOutput", gyro("noise_densty = 1\n"), 4, "did you mean 'noise_density'?"},
      {"NegativeNoise", gyro("noise_density = -1\n"), 4,
       "'noise_density' is -1; it must be in the range from 0 unit/sqrt(Hz)"},
      {"InfiniteBias", gyro("bias = inf\n"), 4, "'bias' is inf; it must be in the range from 0 unit"},
      {"NegativeRange", gyro("range = -1\n"), 4, "'range' is -1; it must be in the range above 0 unit"},
      {"RangeTwice", gyro("range = 1\nlowest = 0\n"), 4, "keep one"},
      {"EmptyRange", gyro("lowest = 1\nhighest = 0\n"), 1, "is empty"},
      {"BitsWithoutRange", gyro("bits = 12\n"), 1, "bits needs a range"},
      {"BitsAndResolution", gyro("range = 1\nbits = 12\nresolution = 1\n"), 1, "keep one"},
      {"HalfABit", gyro("range = 1\nbits = 1.5\n"), 5, "'bits' is 1.5; it must be a whole number in the range 0 to 32"},
      {"ManyBits", gyro("range = 1\nbits = 99\n"), 5, "'bits' is 99; it must be a whole number"},
      {"UnknownJoint", "[sensors.a]\ntype = 'joint_position'\njoints = ['elbo']\n", 1, "elbo"},
      {"JointTwice", "[sensors.a]\ntype = 'joint_position'\njoints = ['elbow', 'elbow']\n", 3, "stands twice"},
      {"NoJoints", "[sensors.a]\ntype = 'joint_position'\njoints = []\n", 3, "names nothing"},
      {"JointsAreNumbers", "[sensors.a]\ntype = 'joint_position'\njoints = [1]\n", 3, "must be a list of names"},
      {"ADate", imu("rate = 2026-01-01\n"), 3, "date"},
      {"MixedList", imu("position = ['a', 1]\n"), 3, "list of numbers, or of names"},
      {"OptionOutOfItsRange", "[sensors.a]\ntype = 'laser'\nrays = 0\n", 3,
       "'rays' is 0; it must be a whole number in the range"},
      {"OptionOfAnotherType", "[sensors.a]\ntype = 'camera'\ndepth = 1\n", 3,
       "'depth' is a number; it must be true or false"},
      {"OptionThatIsAList", "[sensors.a]\ntype = 'laser'\nfov = [1, 2]\n", 3, "'fov' is a list; it must be a number"},
      {"OptionWithoutText", "[sensors.a]\ntype = 'camera'\nlens = ''\n", 3, "'lens' is empty"},
      {"NoneOfTheChoices", "[sensors.a]\ntype = 'camera'\nmosaic = 'rgbg'\n", 3,
       "unknown mosaic 'rgbg'; did you mean 'rggb'?"},
      {"NothingToRemove", "[sensors]\nimu = false\n", 2, "there is no sensor 'imu' to remove"},
  };
}

INSTANTIATE_TEST_SUITE_P(Toml, SensorMistake, testing::ValuesIn(errors()), [](const auto& m) { return m.param.name; });

}  // namespace
}  // namespace murosimf::component_files
