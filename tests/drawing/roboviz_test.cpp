// Drawings of programs that use RoboViz: packets in their form, made here byte by byte, and by UDP.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <initializer_list>
#include <random>
#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "murosimf/drawing/drawn.h"
#include "murosimf/drawing/roboviz_server.h"

namespace murosimf::drawing {
namespace {

using namespace std::chrono_literals;
using namespace std::string_literals;

/// As agents of the league write them: 6 characters, cut from a longer text.
std::string number(double x) { return fmt::format("{:.4f}", x).substr(0, 6); }
std::string numbers(std::initializer_list<double> all) {
  std::string bytes;
  for (const double x : all) bytes += number(x);
  return bytes;
}
const std::string orange("\xff\x80\x00", 3);
std::string words(const std::string& text) { return text + '\0'; }
std::string swap(const std::string& set) { return "\0\0"s + words(set); }
std::string circle(const std::string& set, double radius = 0.5) {
  return "\1\0"s + numbers({1.25, -2.5, radius, 2}) + orange + words(set);
}

TEST(RobovizDrawings, NothingIsShownBeforeTheSwap) {
  RobovizDrawings drawings;
  EXPECT_TRUE(drawings.take(circle("blue.1.ball")));
  EXPECT_TRUE(drawings.shown().groups.empty());
  EXPECT_TRUE(drawings.take(swap("blue.1")));
  const ExternalDrawings shown = drawings.shown();
  ASSERT_EQ(shown.groups.size(), 1U);
  EXPECT_EQ(shown.groups[0].name, "blue.1.ball");
  EXPECT_FALSE(shown.groups[0].of_robot);
  ASSERT_EQ(shown.groups[0].shapes.size(), 1U);
  const DrawnShape& shape = shown.groups[0].shapes[0];
  EXPECT_EQ(shape.kind, DrawnShape::circle);
  EXPECT_EQ(shape.points[0].x, 1.25);
  EXPECT_EQ(shape.points[0].y, -2.5);
  EXPECT_EQ(shape.size, 0.5);
  EXPECT_EQ(shape.color.red, 1);
  EXPECT_NEAR(shape.color.green, 0.5, 0.01);
  EXPECT_EQ(shape.color.blue, 0);
}

TEST(RobovizDrawings, ASwapTakesAllSetsOfThatBeginningAndBeginsThemAnew) {
  RobovizDrawings drawings;
  EXPECT_TRUE(drawings.take(circle("blue.1") + circle("blue.2") + circle("red.1") + swap("blue")));
  EXPECT_EQ(drawings.shown().groups.size(), 2U);
  EXPECT_TRUE(drawings.take(circle("blue.1", 0.25) + swap("blue")));
  const ExternalDrawings next = drawings.shown();
  ASSERT_EQ(next.groups.size(), 1U) << "blue.2 was not drawn again";
  EXPECT_EQ(next.groups[0].shapes[0].size, 0.25);
  EXPECT_TRUE(drawings.take(swap("")));
  EXPECT_EQ(drawings.shown().groups.size(), 1U) << "red.1 alone";
  EXPECT_TRUE(drawings.take(swap("")));
  EXPECT_TRUE(drawings.shown().groups.empty());
}

TEST(RobovizDrawings, AllKindsOfShapes) {
  RobovizDrawings drawings;
  const std::string polygon = "\1\4\3"s + orange + "\x80" + numbers({0, 0, 0, 1, 0, 0, 1, 1, 0.5}) + words("a");
  EXPECT_TRUE(drawings.take("\1\1"s + numbers({1, 2, 3, -4, -5, -6, 3}) + orange + words("a")));
  EXPECT_TRUE(drawings.take("\1\2"s + numbers({1, 2, 3, 10}) + orange + words("a")));
  EXPECT_TRUE(drawings.take("\1\3"s + numbers({1, 2, 3, 0.0625}) + orange + words("a")));
  EXPECT_TRUE(drawings.take(polygon));
  EXPECT_TRUE(drawings.take("\2\0"s + numbers({1, 2, 3}) + orange + words("hello") + words("a")));
  EXPECT_TRUE(drawings.take(swap("a")));
  const ExternalDrawings shown = drawings.shown();
  ASSERT_EQ(shown.groups.size(), 1U);
  const auto& shapes = shown.groups[0].shapes;
  ASSERT_EQ(shapes.size(), 5U);
  EXPECT_EQ(shapes[0].kind, DrawnShape::line);
  EXPECT_EQ(shapes[0].points[1].z, -6);
  EXPECT_EQ(shapes[1].kind, DrawnShape::dots);
  EXPECT_NEAR(shapes[1].size, 0.04, 1e-9) << "10 pixels of 4 mm";
  EXPECT_EQ(shapes[2].kind, DrawnShape::sphere);
  EXPECT_EQ(shapes[2].size, 0.0625);
  EXPECT_EQ(shapes[3].kind, DrawnShape::polygon);
  ASSERT_EQ(shapes[3].points.size(), 3U);
  EXPECT_EQ(shapes[3].points[2].z, 0.5);
  EXPECT_NEAR(shapes[3].opacity, 0.5, 0.01);
  EXPECT_EQ(shapes[4].words, "hello");
}

TEST(RobovizDrawings, TextsAtRobots) {
  RobovizDrawings drawings;
  EXPECT_TRUE(drawings.take("\2\1"s + '\1' + orange + words("striker")));
  EXPECT_TRUE(drawings.take("\2\1"s + '\x80' + orange + words("keeper")));
  const std::vector<std::string> teams{"", "blue", "blue", "", "red"};
  const auto drawn = external_drawings(drawings.shown(), teams);
  ASSERT_EQ(drawn.size(), 2U);
  EXPECT_EQ(drawn[0].entity, 2);
  EXPECT_EQ(drawn[0].groups[0].shapes[0].words, "striker");
  EXPECT_TRUE(drawn[0].groups[0].of_robot);
  EXPECT_EQ(drawn[1].entity, 4);
  EXPECT_TRUE(drawings.take("\2\2\1"s));
  EXPECT_EQ(drawings.shown().notes.size(), 1U);
  EXPECT_TRUE(drawings.take("\3\1"s)) << "selects a robot: taken, and nothing happens";
}

TEST(RobovizDrawings, NumbersAsJavaAndCWriteThem) {
  for (const char* text : {"1.5000", "  1.50", "1.5   ", "+1.500", "1.5e0 ", "1.5\0\0\0", "01.500"}) {
    RobovizDrawings drawings;
    const std::string x(text, 6);
    EXPECT_TRUE(drawings.take("\1\0"s + x + numbers({0, 1, 1}) + orange + words("a") + swap("a"))) << text;
    EXPECT_EQ(drawings.shown().groups.at(0).shapes[0].points[0].x, 1.5) << text;
  }
  for (const char* text : {"   nan", "inf   ", "1.5.00", "      ", "1e99  ", "--1.50", "0x1.80"}) {
    RobovizDrawings drawings;
    EXPECT_FALSE(drawings.take("\1\0"s + std::string(text, 6) + numbers({0, 1, 1}) + orange + words("a"))) << text;
  }
}

TEST(RobovizDrawings, WhatIsCutOffAnywhereIsRefused) {
  const std::string whole = circle("set") + swap("set");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    RobovizDrawings drawings;
    EXPECT_EQ(drawings.take(whole.substr(0, size)), size == circle("set").size()) << size;
    EXPECT_TRUE(drawings.shown().groups.empty());
  }
}

TEST(RobovizDrawings, NonsenseIsNeverTooMuch) {
  std::mt19937 random(7);
  RobovizDrawings drawings;
  for (int i = 0; i < 20'000; ++i) {
    std::string packet = circle("s" + std::to_string(i)) + swap("");
    for (int k = 0; k < 3; ++k) packet[random() % packet.size()] = static_cast<char>(random());
    (void)drawings.take(packet);
  }
  EXPECT_LE(drawings.shown().groups.size(), RobovizDrawings::most_sets);
  RobovizDrawings full;
  for (std::size_t i = 0; i < RobovizDrawings::most_shapes; ++i) EXPECT_TRUE(full.take(circle("a")));
  EXPECT_FALSE(full.take(circle("a")));
  EXPECT_FALSE(full.take(circle("a") + swap("a"))) << "no place for one more";
  ASSERT_EQ(full.shown().groups.size(), 1U) << "but the swap behind it counts";
  EXPECT_TRUE(full.take(circle("a")));
}

TEST(RobovizDrawings, AllSetsTogetherAreNeverTooMuch) {
  RobovizDrawings drawings;
  const auto fill = [&](const std::string& set) {
    std::size_t taken = 0;
    for (std::size_t i = 0; i < RobovizDrawings::most_shapes; ++i) taken += drawings.take(circle(set)) ? 1 : 0;
    return taken;
  };
  std::size_t waiting = 0;
  for (int set = 0; set < 30; ++set) waiting += fill("s" + std::to_string(set));
  EXPECT_EQ(waiting, RobovizDrawings::most_in_all);
  EXPECT_FALSE(drawings.take(circle("other")));
  EXPECT_TRUE(drawings.take(swap("")));
  EXPECT_FALSE(drawings.take(circle("other"))) << "what is shown counts, too";
  EXPECT_TRUE(drawings.take(swap(""))) << "nothing was drawn since";
  EXPECT_EQ(fill("other"), RobovizDrawings::most_shapes);
}

void send(std::uint16_t port, const std::string& packet) {
  const int socket = ::socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(port);
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  EXPECT_EQ(::sendto(socket, packet.data(), packet.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to),
            static_cast<ssize_t>(packet.size()));
  ::close(socket);
}

TEST(RobovizServer, TakesPacketsAndCountsNonsense) {
  RobovizServer door({"127.0.0.1", 0});
  ASSERT_NE(door.address().port, 0);
  send(door.address().port, "nonsense");
  send(door.address().port, "");
  send(door.address().port, circle("a") + swap("a"));
  for (int i = 0; i < 2000 && door.packets() < 3; ++i) std::this_thread::sleep_for(1ms);
  EXPECT_EQ(door.packets(), 3U);
  EXPECT_EQ(door.ignored(), 2U);
  ASSERT_EQ(door.shown()->groups.size(), 1U);
  EXPECT_EQ(door.shown(), door.shown()) << "nothing new: the same";
  EXPECT_THROW(RobovizServer({"127.0.0.1", door.address().port}), network::NetworkError);
}

}  // namespace
}  // namespace murosimf::drawing
