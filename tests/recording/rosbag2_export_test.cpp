// Bags of ROS 2: alignment of CDR, definitions of types, markers that go, names, and what cannot become a bag. Values of a whole run:
// tests/oracle/bags_with_rosbags.py.
#include "murosimf/recording/rosbag2/rosbag2_export.h"

#include <filesystem>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "murosimf/dds/ros2/ros_writer.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/foxglove_messages.h"
#include "murosimf/recording/mcap/mcap_writer.h"
#include "murosimf/recording/mcap/protobuf.h"
#include "murosimf/recording/rosbag2/ros_markers.h"
#include "murosimf/recording/rosbag2/ros_messages.h"
#include "murosimf/recording/rosbag2/ros_types.h"
#include "tests/recording/small_recording.h"
#include "tests/temp_folder.h"

namespace murosimf {
namespace {

using namespace recording;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

std::string bytes(std::initializer_list<int> values) {
  std::string text;
  for (const int value : values) text.push_back(static_cast<char>(value));
  return text;
}

TEST(RosTypes, DefineEachTypeThatTheyContainOnce) {
  EXPECT_EQ(ros_definition("rosgraph_msgs/Clock"), "builtin_interfaces/Time clock\n" + std::string(80, '=') +
                                                       "\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n");
  const std::string markers = ros_definition("visualization_msgs/MarkerArray");
  const std::size_t first = markers.find("MSG: std_msgs/ColorRGBA\n");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(markers.find("MSG: std_msgs/ColorRGBA\n", first + 1), std::string::npos);
}

TEST(RosNames, LoseWhatRosDoesNotAllow) {
  EXPECT_EQ(ros_name("blue-1"), "blue_1");
  EXPECT_EQ(ros_name("1"), "_1");
  EXPECT_EQ(ros_name(""), "_");
}

std::string scene(std::size_t cubes) {
  std::string update;
  ProtobufWriter(update).message(2, [&](ProtobufWriter& entity) {
    entity.text(2, "world");
    entity.text(3, "forces");
    for (std::size_t i = 0; i < cubes; ++i)
      entity.message(8, [](ProtobufWriter& cube) { put_vector(cube, 2, {1, 1, 1}); });
  });
  return update;
}

std::uint32_t count_of(const std::string& cdr) { return static_cast<unsigned char>(cdr[4]); }

TEST(RosMarkers, GoWhenTheSceneHasFewerAndWithTheirEntity) {
  std::map<std::string, int> shown;
  EXPECT_EQ(count_of(ros_markers(scene(3), shown)), 3U);
  EXPECT_EQ(count_of(ros_markers(scene(1), shown)), 3U);  // two of them are deletions
  EXPECT_EQ(shown["forces"], 1);
  EXPECT_EQ(count_of(ros_markers(scene(1), shown)), 1U);
  std::string all_go;
  ProtobufWriter(all_go).message(1, [](ProtobufWriter& deletion) { deletion.varint(2, 1); });
  EXPECT_EQ(count_of(ros_markers(all_go, shown)), 1U);
  EXPECT_EQ(shown["forces"], 0);
}

TEST(RosMessages, EffortIsLeftOutWhereAJointHasNone) {
  std::string joints;
  ProtobufWriter out(joints);
  for (const char* name : {"blue/knee", "blue/ankle"}) {
    out.message(2, [&](ProtobufWriter& joint) {
      joint.text(1, name);
      joint.present_number(2, 1);
      joint.present_number(3, 2);
      if (std::string(name) == "blue/knee") joint.present_number(5, 3);
    });
  }
  RosMessages messages;
  const auto made = messages.of({.id = 1, .topic = "/joints"}, joints, 0ms);
  ASSERT_EQ(made.size(), 1U);
  EXPECT_EQ(made[0].topic, "/blue/joint_states");
  dds::ros2::RosWriter wanted;
  wanted.header({}, "");
  wanted.u32(2);
  wanted.text("knee");
  wanted.text("ankle");
  wanted.u32(2);
  wanted.f64(1);
  wanted.f64(1);
  wanted.u32(2);
  wanted.f64(2);
  wanted.f64(2);
  wanted.u32(0);
  EXPECT_EQ(made[0].data, wanted.message());
}

TEST(RosMessages, OfASensorHaveItsZeros) {
  Channel channel{.id = 1, .topic = "/sensors/robot/imu", .metadata = {}};
  int field = 2;
  for (const char* output : {"gyroscope", "accelerometer"}) {
    for (const char axis : {'x', 'y', 'z'})
      channel.metadata[std::to_string(field++)] = std::string(output) + "." + axis + " [1]";
  }
  std::string sample;
  ProtobufWriter(sample).number(7, 9.81);  // zeros are no fields
  RosMessages messages;
  const auto made = messages.of(channel, sample, 0ms);
  ASSERT_EQ(made.size(), 1U);
  EXPECT_EQ(made[0].type, "sensor_msgs/Imu");
  dds::ros2::RosWriter wanted;
  wanted.header({}, "robot/imu");
  wanted.quaternion({1, 0, 0, 0});
  for (int i = 0; i < 9; ++i) wanted.f64(i == 0 ? -1 : 0);
  wanted.vector({});
  for (int i = 0; i < 9; ++i) wanted.f64(0);
  wanted.vector({0, 0, 9.81});
  for (int i = 0; i < 9; ++i) wanted.f64(0);
  EXPECT_EQ(made[0].data, wanted.message());
}

std::string refusal(const fs::path& recording, const fs::path& bag) {
  try {
    (void)write_rosbag2(McapReader(recording), bag);
  } catch (const SetupError& error) {
    return error.what();
  }
  return "";
}

TEST(Rosbag2, ARefusedBagLeavesNoFolder) {
  const fs::path folder = fixtures::temp_folder(), file = folder / "small.mcap";
  fixtures::write_small_recording(file);
  EXPECT_NE(refusal(file, folder / "bag").find("nothing that ROS 2 has messages for"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder / "bag"));
  EXPECT_FALSE(fs::exists(folder / "bag.part"));
  fs::create_directory(folder / "old");
  EXPECT_NE(refusal(file, folder / "old").find("exists; a bag is a new folder"), std::string::npos);
  EXPECT_NE(refusal(file, folder / "no" / "bag").find("cannot write"), std::string::npos);
}

TEST(Rosbag2, ADamagedMessageIsNamedAndLeavesNoFolder) {
  const fs::path folder = fixtures::temp_folder(), file = folder / "damaged.mcap";
  McapWriter out(file, {.library = "test"});
  out.write(out.add_channel("/tf", "protobuf", 0), 0ms, bytes({0x0a, 0x7f}));
  out.close();
  EXPECT_NE(refusal(file, folder / "bag").find("a message ends too early"), std::string::npos)
      << refusal(file, folder / "bag");
  EXPECT_FALSE(fs::exists(folder / "bag"));
}

}  // namespace
}  // namespace murosimf
