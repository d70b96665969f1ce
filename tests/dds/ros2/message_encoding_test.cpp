// Messages of ROS 2: alignment of CDR, commands that are read back, damaged ones, requests of services in both forms.
#include <initializer_list>

#include "murosimf/dds/ros2/message_encoding.h"

#include <gtest/gtest.h>

#include "murosimf/dds/ros2/command_messages.h"
#include "murosimf/dds/ros2/ros_names.h"
#include "murosimf/dds/ros2/service.h"

namespace murosimf::dds::ros2 {
namespace {

std::string bytes(std::initializer_list<int> values) {
  std::string text;
  for (const int value : values) text.push_back(static_cast<char>(value));
  return text;
}

TEST(RosWriter, PutsNumbersAtMultiplesOfTheirSizeAfterTheHead) {
  RosWriter out;
  out.u8(7);
  out.u32(0x01020304);
  out.text("ab");
  out.f64(1);
  EXPECT_EQ(out.message(), bytes({0, 1, 0, 0,                              // head
                                  7, 0, 0, 0, 4,   3,   2, 1,              // at 0 and 4
                                  3, 0, 0, 0, 'a', 'b', 0,                 // at 8
                                  0, 0, 0, 0, 0,   0,   0, 0xf0, 0x3f}));  // at 16
}

TEST(RosNames, AreThoseOfRosInDds) {
  EXPECT_EQ(ros_name("blue-1"), "blue_1");
  EXPECT_EQ(ros_name("1"), "_1");
  EXPECT_EQ(topic_name("/blue1/imu"), "rt/blue1/imu");
  EXPECT_EQ(type_name("sensor_msgs/Imu"), "sensor_msgs::msg::dds_::Imu_");
}

RosWriter trajectory(double last_time) {
  RosWriter out;
  out.header({}, "");
  out.texts(std::vector<std::string>{"neck"});
  out.u32(2);
  for (const double time : {0.5, last_time}) {
    out.u32(1);
    out.f64(time);
    for (int i = 0; i < 3; ++i) out.u32(0);
    out.time(from_seconds(time));
  }
  return out;
}

TEST(CommandMessages, OfTrajectoriesAreRead) {
  const auto read = read_trajectory(trajectory(1.25).encoded());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->joints, std::vector<std::string>{"neck"});
  ASSERT_EQ(read->points.size(), 2U);
  EXPECT_EQ(read->points[1].positions, std::vector<double>{1.25});
  EXPECT_DOUBLE_EQ(read->points[1].time, 1.25);
}

TEST(CommandMessages, AreRefusedIfDamaged) {
  EXPECT_FALSE(read_trajectory(trajectory(0.5).encoded())) << "times do not grow";
  const Bytes whole = trajectory(1.25).encoded();
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_FALSE(read_trajectory(std::span(whole).first(size))) << size;
  RosWriter out;
  out.vector({std::nan(""), 0, 0});
  out.vector({});
  EXPECT_FALSE(read_twist(out.encoded()));
}

TEST(CommandMessages, OfTwistsAreForwardLeftAndTurn) {
  RosWriter out;
  out.vector({0.1, 0.2, 9});
  out.vector({9, 9, 0.3});
  const auto read = read_twist(out.encoded());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->x, 0.1);
  EXPECT_EQ(read->y, 0.2);
  EXPECT_EQ(read->z, 0.3);
}

/// Cyclone's requests have 16 bytes before what the others begin with.
TEST(ServiceCall, IsOpenedByTheVendorOfItsSender) {
  RosWriter out;
  for (const std::uint64_t number : {11U, 12U, 13U}) out.u64(number);
  ServiceCall call;
  ASSERT_TRUE(open_call(out.encoded(), {{1, 15}, 1}, call));
  EXPECT_FALSE(call.has_header);
  EXPECT_EQ(CdrReader(call.request).number<std::uint64_t>(), 11U);
  ASSERT_TRUE(open_call(out.encoded(), {{1, 16}, 1}, call));
  EXPECT_TRUE(call.has_header);
  EXPECT_EQ(CdrReader(call.request).number<std::uint64_t>(), 13U);
  EXPECT_EQ(call.header[0], 11);
  EXPECT_FALSE(open_call({0, 1, 0, 0, 7}, {{1, 16}, 1}, call));
  EXPECT_FALSE(open_call({0}, {{1, 15}, 1}, call));
}

}  // namespace
}  // namespace murosimf::dds::ros2
