/// urdf_noise_test - errors of sensors in gazebo blocks: those with an effect, and those that are reported.
#include "murosimf/robot_formats/urdf/gazebo_schema.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot_formats::urdf {
namespace {

using namespace urdf_files;
using sensors::SignalSpec;

robot_formats::RobotDescription read_sensor_of_base(const std::string& type, const std::string& inside) {
  return read(
      robot_xml("<gazebo reference='base'><sensor name='s' type='" + type + "'>" + inside + "</sensor></gazebo>"));
}

/// The noise that is read for the x axis of an accelerometer.
SignalSpec signal_of(const std::string& noise) {
  const auto description =
      read_sensor_of_base("imu", "<imu><linear_acceleration><x>" + noise + "</x></linear_acceleration></imu>");
  const auto& signals = description.sensors.at(0).signals;
  const auto found = signals.find("accelerometer.x");
  return found == signals.end() ? SignalSpec{} : found->second;
}

std::string noise(const std::string& inside, const std::string& type = "gaussian") {
  return "<noise type='" + type + "'>" + inside + "</noise>";
}

bool names(const robot_formats::RobotDescription& description, const std::string& word) {
  return std::ranges::find(description.unused, word, &robot_formats::Unused::word) != description.unused.end();
}

// Every element of noise, one after the other: the schema has no other.
TEST(UrdfNoise, EveryElementActs) {
  const std::map<std::string, std::pair<std::string, SignalSpec>> probes{
      {"mean", {noise("<mean>0.1</mean>"), {.mean = 0.1}}},
      {"stddev", {noise("<stddev>0.2</stddev>"), {.noise = 0.2}}},
      {"bias_mean", {noise("<bias_mean>0.3</bias_mean>"), {.bias_mean = 0.3}}},
      {"bias_stddev", {noise("<bias_stddev>0.4</bias_stddev>"), {.bias = 0.4}}},
      {"dynamic_bias_stddev",
       {noise("<dynamic_bias_stddev>0.5</dynamic_bias_stddev><dynamic_bias_correlation_time>60"
              "</dynamic_bias_correlation_time>"),
        {.bias_random_walk = 0.5, .bias_correlation_time = 60}}},
      {"dynamic_bias_correlation_time",
       {noise("<dynamic_bias_stddev>0.5</dynamic_bias_stddev><dynamic_bias_correlation_time>6"
              "</dynamic_bias_correlation_time>"),
        {.bias_random_walk = 0.5, .bias_correlation_time = 6}}},
      {"precision", {noise("<precision>0.7</precision>", "gaussian_quantized"), {.resolution = 0.7}}},
      {"type", {"<noise><type>none</type><stddev>1</stddev></noise>", {}}},
  };
  for (const std::string_view element : gazebo_schema().at("noise").children) {
    const auto probe = probes.find(std::string(element));
    ASSERT_NE(probe, probes.end()) << element;
    EXPECT_EQ(signal_of(probe->second.first), probe->second.second) << element;
  }
  EXPECT_EQ(signal_of(noise("<stddev>1</stddev>", "none")), SignalSpec{});
}

TEST(UrdfNoise, ThatIsTheSameForAllAxesIsThatOfTheOutput) {
  const std::string axis = noise("<stddev>1</stddev>");
  const auto description = read_sensor_of_base("imu", "<imu><angular_velocity><x>" + axis + "</x><y>" + axis +
                                                          "</y><z>" + axis + "</z></angular_velocity></imu>");
  ASSERT_EQ(description.sensors.at(0).signals.size(), 1u);
  EXPECT_EQ(description.sensors[0].signals.at("gyroscope").noise, 1);
}

TEST(UrdfNoise, OfOldFilesIsThatOfAllAxes) {
  const auto description = read_sensor_of_base(
      "imu",
      "<imu><noise><type>gaussian</type><rate><bias_mean>0.1</bias_mean></rate><accel><stddev>2</stddev></accel>"
      "</noise></imu>");
  EXPECT_EQ(description.sensors.at(0).signals.at("gyroscope").bias_mean, 0.1);
  EXPECT_EQ(description.sensors[0].signals.at("accelerometer").noise, 2);
}

TEST(UrdfNoise, NamesWhatHasNoEffect) {
  const std::string begin = "<imu><angular_velocity><x>", end = "</x></angular_velocity></imu>";
  EXPECT_TRUE(names(read_sensor_of_base("imu", begin + noise("<precision>1</precision>") + end), "noise/precision"));
  EXPECT_TRUE(names(read_sensor_of_base("imu", begin + noise("<dynamic_bias_stddev>1</dynamic_bias_stddev>") + end),
                    "noise/dynamic_bias"));
  const auto camera = read_sensor_of_base("camera", "<always_on>1</always_on><camera><clip/>" +
                                                        noise("<mean>0.1</mean><stddev>0.02</stddev>") + "</camera>");
  EXPECT_EQ(camera.sensors.at(0).numbers.at("read_noise"), 0.02);
  for (const char* word : {"always_on", "clip", "camera/noise"}) EXPECT_TRUE(names(camera, word)) << word;
  const auto unknown = read_sensor_of_base("imu", "<imu><smell/></imu>");
  EXPECT_TRUE(any_contains(unknown.warnings, "unknown element in imu 'smell'"));
}

TEST(UrdfNoise, ACameraStandsWhereItsOwnPoseSays) {
  const auto description =
      read_sensor_of_base("camera", "<pose>1 0 0 0 0 0</pose><camera><pose>0 2 0 0 0 0</pose></camera>");
  expect_near(description.sensors.at(0).place.position, {1, 2, 0});
}

}  // namespace
}  // namespace murosimf::robot_formats::urdf
