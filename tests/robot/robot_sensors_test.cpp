/// robot_sensors_test - sensors of MJCF and URDF files, and their conversion.
#include "murosimf/robot/robot_sensors.h"

#include <fstream>

#include "murosimf/robot/robot_checks.h"
#include "murosimf/robot/robot_conversion.h"
#include "tests/fixtures.h"
#include "tests/robot/sensor_files.h"

namespace murosimf::robot {
namespace {

using namespace sensor_files;
using robot_formats::urdf::urdf_files::any_contains;
using robot_formats::urdf::urdf_files::contains;
using sensors::SensorSpec;

struct Element {
  const char *element, *type, *frame;
};

void PrintTo(const Element& element, std::ostream* stream) { *stream << element.element; }

class MjcfSensor : public testing::TestWithParam<Element> {};

TEST_P(MjcfSensor, BecomesASensorThatRuns) {
  const auto& [element, type, frame] = GetParam();
  const RobotFile robot = read_with("", element);
  ASSERT_EQ(robot.sensors.size(), 1u);
  const SensorSpec& spec = robot.sensors[0];
  EXPECT_EQ(spec.type, type);
  EXPECT_EQ(spec.name, type) << "one without a name is called as its type";
  EXPECT_EQ(spec.frame, frame);
  EXPECT_TRUE(contains(spec.where, "robot.xml:3"));
  for (const robot::Finding& finding : robot::examine_sensors(robot)) ADD_FAILURE() << robot::to_line(finding);
}

INSTANTIATE_TEST_SUITE_P(
    Elements, MjcfSensor,
    testing::Values(Element{"<gyro site='imu'/>", "gyroscope", "imu"},
                    Element{"<accelerometer site='elbow'/>", "accelerometer", "elbow.site"},
                    Element{"<framequat objtype='site' objname='imu'/>", "orientation", "imu"},
                    Element{"<jointpos joint='elbow'/>", "joint_position", ""},
                    Element{"<jointvel joint='elbow'/>", "joint_velocity", ""},
                    Element{"<jointactuatorfrc joint='elbow'/>", "joint_torque", ""},
                    Element{"<actuatorfrc actuator='m'/>", "joint_torque", ""},
                    Element{"<touch site='imu'/>", "contact_force", "imu"},
                    Element{"<force site='imu'/>", "joint_wrench", "imu"},
                    Element{"<torque site='imu'/>", "joint_wrench", "imu"},
                    Element{"<framepos objtype='xbody' objname='arm'/>", "position", "arm"},
                    Element{"<framelinvel objtype='site' objname='imu'/>", "linear_velocity", "imu"},
                    Element{"<frameangvel objtype='xbody' objname='arm'/>", "angular_velocity", "arm"},
                    Element{"<velocimeter site='imu'/>", "velocimeter", "imu"},
                    Element{"<subtreecom body='base'/>", "center_of_mass", "base"},
                    Element{"<rangefinder site='imu'/>", "rangefinder", "imu"}));

TEST(MjcfSensors, NoiseAndCutoffAreThoseOfAllOutputs) {
  const RobotFile robot = read_with("", "<gyro name='g' site='imu' noise='0.2' cutoff='3'/>");
  const sensors::SignalSpec signal = sensor_of(robot, "g").signal("gyroscope");
  EXPECT_EQ(signal.noise, 0.2);
  EXPECT_EQ(signal.highest, 3);
  EXPECT_EQ(signal.lowest, -3);
}

TEST(MjcfSensors, AFrameOfABodyIsItsCenterOfMass) {
  const RobotFile robot = read_with("", "<framepos name='p' objtype='body' objname='arm'/>");
  EXPECT_EQ(sensor_of(robot, "p").position.x, 0.1);
}

TEST(MjcfSensors, SensorsOfOneKindAreCounted) {
  const RobotFile robot = read_with("", "<gyro site='imu'/><gyro site='imu'/><gyro name='a.b' site='imu'/>");
  ASSERT_EQ(robot.sensors.size(), 3u);
  EXPECT_EQ(robot.sensors[1].name, "gyroscope_2");
  EXPECT_EQ(robot.sensors[2].name, "a_b") << "names stand in paths: robot.sensor.output";
}

TEST(MjcfSensors, WhatIsNotSimulatedIsANote) {
  const RobotFile robot =
      read_with("",
                "<magnetometer site='imu'/><framepos objtype='site' objname='imu' reftype='xbody' refname='arm'/>"
                "<framequat objtype='body' objname='arm'/><actuatorfrc actuator='geared'/>"
                "<subtreecom body='arm'/><clock name='t'/>");
  EXPECT_TRUE(robot.sensors.empty());
  EXPECT_TRUE(any_contains(robot.notes, "robot.xml:3: sensor magnetometer '' at 'imu': not simulated"));
  EXPECT_TRUE(any_contains(robot.notes, "not simulated: it is relative to another frame"));
  EXPECT_TRUE(any_contains(robot.notes, "not simulated: it shows axes of inertia"));
  EXPECT_TRUE(any_contains(robot.notes, "not simulated: the gear of its actuator is not 1"));
  EXPECT_TRUE(any_contains(robot.notes, "not simulated: only the center of mass of the whole robot is"));
  EXPECT_TRUE(any_contains(robot.notes, "sensor clock 't'"));
}

TEST(MjcfSensors, AnUnknownSiteIsAnErrorUnlessLenient) {
  const std::string element = "<gyro name='g' site='imo'/>";
  const std::string what = fixtures::error_of([&] { (void)read_with("", element); });
  EXPECT_TRUE(fixtures::says(what, {"robot.xml:3", "sensor 'g'", "did you mean 'imu'?"}));
  const RobotFile robot = read_with("", element, {.lenient = true});
  EXPECT_TRUE(robot.sensors.empty());
  EXPECT_TRUE(any_contains(robot.warnings, "sensor 'g'"));
}

std::string urdf(const std::string& blocks) {
  using namespace robot_formats::urdf::urdf_files;
  return robot_formats::urdf::urdf_files::robot_xml(
      link("foot", solid()) + link("eye") + joint("revolute", "base", "foot", any_limit, "ankle") +
      joint("fixed", "foot", "eye", "<origin xyz='0 0 1'/>", "fixing") + blocks);
}

RobotFile read_blocks(const std::string& blocks) { return read_robot(write("robot.urdf", urdf(blocks))); }

TEST(UrdfSensors, ImusHaveTheNoiseOfTheirAxes) {
  const RobotFile robot = read_blocks(
      "<gazebo reference='foot'><sensor name='body imu' type='imu'><update_rate>100</update_rate><imu>"
      "<angular_velocity><x><noise type='gaussian'><mean>0</mean><stddev>0.1</stddev><bias_stddev>0.01</bias_stddev>"
      "</noise></x><y><noise type='gaussian'><stddev>0.3</stddev></noise></y></angular_velocity><linear_acceleration>"
      "<z><noise type='gaussian'><mean>2</mean><stddev>0.5</stddev></noise></z></linear_acceleration></imu></sensor>"
      "</gazebo>");
  const SensorSpec& spec = sensor_of(robot, "body_imu");
  EXPECT_EQ(spec.type, "imu");
  EXPECT_EQ(spec.frame, "foot");
  EXPECT_EQ(spec.rate, 100);
  EXPECT_EQ(spec.signal("gyroscope.x").noise, 0.1);
  EXPECT_EQ(spec.signal("gyroscope.x").bias, 0.01);
  EXPECT_EQ(spec.signal("gyroscope.y").noise, 0.3);
  EXPECT_EQ(spec.signal("gyroscope.z"), sensors::SignalSpec{});
  EXPECT_EQ(spec.signal("accelerometer.z").noise, 0.5);
  EXPECT_EQ(spec.signal("accelerometer.z").mean, 2);
  EXPECT_FALSE(any_contains(robot.notes, "noise"));
  EXPECT_TRUE(robot::examine_sensors(robot).empty());
}

TEST(UrdfSensors, ASensorAtAFixedJointIsOnTheLinkBehindIt) {
  const RobotFile robot = read_blocks(
      "<gazebo reference='fixing'><sensor name='a' type='force_torque'/></gazebo>"
      "<gazebo reference='ankle'><sensor name='b' type='force_torque'/><sensor type='contact'/></gazebo>");
  EXPECT_EQ(sensor_of(robot, "a").frame, "eye");
  EXPECT_EQ(sensor_of(robot, "b").frame, "ankle");
  EXPECT_EQ(sensor_of(robot, "contact_force").type, "contact_force");
  EXPECT_EQ(sensor_of(robot, "a").texts.at("behind"), "eye");
  EXPECT_EQ(sensor_of(robot, "b").texts.at("behind"), "foot");
  EXPECT_EQ(sensor_of(robot, "b").texts.at("axes"), "foot");
  const int eye = robot.model->object_index("eye");
  EXPECT_EQ(robot.model->tree().link_of[eye], robot.model->object_index("foot")) << "fixed to it, but not a part of it";
  EXPECT_TRUE(robot::examine_sensors(robot).empty());
}

TEST(UrdfSensors, ForcesAreSeenInTheFrameAndDirectionOfTheFile) {
  const auto texts = [](const std::string& inside) {
    const RobotFile robot =
        read_blocks("<gazebo reference='ankle'><sensor name='f' type='force_torque'><force_torque>" + inside +
                    "</force_torque></sensor></gazebo>");
    return sensor_of(robot, "f").texts;
  };
  using Texts = std::map<std::string, std::string>;
  EXPECT_EQ(texts(""), (Texts{{"behind", "foot"}, {"axes", "foot"}}));
  EXPECT_EQ(texts("<frame>parent</frame><measure_direction>parent_to_child</measure_direction>"),
            (Texts{{"behind", "foot"}, {"axes", "base"}, {"direction", "parent_to_child"}}));
  EXPECT_EQ(texts("<frame>sensor</frame><measure_direction>child_to_parent</measure_direction>"),
            (Texts{{"behind", "foot"}}));
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { (void)texts("<frame>children</frame>"); }),
                             {"robot.urdf:6", "unknown frame of a force_torque sensor 'children'", "'child'"}));
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { (void)texts("<measure_direction>up</measure_direction>"); }),
                             {"unknown measure_direction 'up'"}));
}

TEST(UrdfSensors, ForcesHaveTheNoiseOfTheirAxes) {
  const RobotFile robot = read_blocks(
      "<gazebo reference='ankle'><sensor name='f' type='force_torque'><force_torque><force><z><noise type='gaussian'>"
      "<stddev>0.5</stddev></noise></z></force></force_torque></sensor></gazebo>");
  EXPECT_EQ(sensor_of(robot, "f").signal("force.z").noise, 0.5);
  EXPECT_EQ(sensor_of(robot, "f").signal("force.x").noise, 0);
  EXPECT_TRUE(robot::examine_sensors(robot).empty());
}

TEST(UrdfSensors, WhatIsNotSimulatedStaysInTheList) {
  const RobotFile robot = read_blocks("<gazebo reference='eye'><sensor name='c' type='magnetometer'/></gazebo>");
  EXPECT_TRUE(robot.sensors.empty());
  EXPECT_EQ(robot.description.sensors.size(), 1u);
  EXPECT_TRUE(any_contains(robot.notes, "sensor magnetometer 'c' at 'eye': not simulated"));
}

const std::string laser =
    "<gazebo reference='eye'><sensor name='scan' type='ray'><pose>0 0 0.5 0 0 "
    "0</pose><update_rate>40</update_rate><ray>"
    "<scan><horizontal><samples>11</samples><resolution>2</resolution><min_angle>-1</min_angle><max_angle>2</max_angle>"
    "</horizontal></scan><range><min>0.2</min><max>20</max><resolution>0.01</resolution></range><noise>"
    "<type>gaussian</type><stddev>0.03</stddev></noise></ray></sensor></gazebo>";

TEST(UrdfSensors, ScannersHaveTheirRaysRangeAndNoise) {
  const robot_formats::RobotDescription description =
      robot_formats::urdf::read_urdf(write("robot.urdf", urdf(laser)), {});
  const robot_formats::SensorDescription& sensor = description.sensors.at(0);
  const std::map<std::string, double> numbers{
      {"rays", 22}, {"fov", 3}, {"first_angle", -1}, {"range_min", 0.2}, {"range_max", 20}};
  EXPECT_EQ(sensor.numbers, numbers);
  EXPECT_EQ(sensor.signals.at("").noise, 0.03);
  EXPECT_EQ(sensor.signals.at("").resolution, 0.01);
}

TEST(UrdfSensors, NegativeNumbersAreRefused) {
  const auto what = [](const std::string& inside) {
    return fixtures::error_of([&] {
      (void)read_blocks("<gazebo reference='foot'><sensor name='s' type='imu'>" + inside + "</sensor></gazebo>");
    });
  };
  EXPECT_TRUE(fixtures::says(what("<update_rate>-1</update_rate>"), {"robot.urdf:6: update_rate of the sensor is -1"}));
  EXPECT_TRUE(fixtures::says(what("<imu><noise><rate><stddev>-1</stddev></rate></noise></imu>"),
                             {"robot.urdf:6: a deviation of noise is negative"}));
}

RobotFile converted(const std::filesystem::path& file, std::string* mjcf = nullptr) {
  const auto out = write("out/robot.xml", "");
  const RobotConversion conversion = convert_robot(file, {.folder = out.parent_path()});
  write("out/robot.toml", conversion.toml);
  if (mjcf) *mjcf = conversion.text;
  return read_robot(write("out/robot.xml", conversion.text));
}

void expect_same_sensors(const RobotFile& after, const RobotFile& before) {
  ASSERT_EQ(after.sensors.size(), before.sensors.size());
  for (const SensorSpec& spec : before.sensors) {
    const SensorSpec& same = sensor_of(after, spec.name);
    EXPECT_EQ(same.type, spec.type);
    EXPECT_EQ(same.frame, spec.frame);
    EXPECT_EQ(same.rate, spec.rate);
    EXPECT_EQ(same.objects, spec.objects);
    EXPECT_EQ(same.numbers, spec.numbers);
    EXPECT_EQ(same.position.z, spec.position.z);
    EXPECT_EQ(same.signal("gyroscope").noise, spec.signal("gyroscope").noise);
    EXPECT_EQ(same.signal("").highest, spec.signal("").highest);
  }
}

TEST(ConvertedSensors, OfMjcfAreElementsAgain) {
  const RobotFile before =
      read_with("",
                "<gyro name='g' site='imu' noise='0.1' cutoff='9'/><jointpos joint='elbow'/><actuatorfrc name='t' "
                "actuator='m'/><framepos name='p' objtype='body' objname='arm'/><accelerometer site='elbow'/>");
  std::string mjcf;
  expect_same_sensors(converted(before.description.file, &mjcf), before);
  EXPECT_TRUE(contains(mjcf, "<gyro name=\"g\" site=\"imu\" noise=\"0.1\" cutoff=\"9\"/>")) << mjcf;
}

TEST(ConvertedSensors, OfUrdfAreInTheTomlFile) {
  const RobotFile before = read_blocks(
      "<gazebo reference='eye'><sensor name='i' type='imu'><pose>0 0 0.5 0 0 0</pose><update_rate>50</update_rate><imu>"
      "<noise><rate><stddev>0.2</stddev></rate></noise></imu></sensor><sensor name='c' type='magnetometer'/></gazebo>" +
      laser);
  const RobotFile after = converted(before.description.file);
  ASSERT_GE(after.sensors.size(), 1u);
  expect_same_sensors(after, before);
}

TEST(ConvertedSensors, ATableThatChangesAUrdfSensorIsWarnedOf) {
  write("robot.toml", "[sensors.i]\nrate = 50\n");
  const auto file = write("robot.urdf", urdf("<gazebo reference='eye'><sensor name='i' type='imu'/></gazebo>"));
  EXPECT_TRUE(any_contains(convert_robot(file).warnings, "robot.toml:1:"));
}

}  // namespace
}  // namespace murosimf::robot
