// The client library: names, labels and first values are those of the robot, and errors are reported in one line.
#include "murosimf/network/robot_client.h"
#include "murosimf/dynamics/motion_properties.h"

#include <gtest/gtest.h>

#include "tests/network/tcp_fixture.h"

namespace murosimf::client {
namespace {

using namespace control_software::fixtures;

TEST(RobotClient, AsksForRowsByName) {
  const Listener listener;
  Software client([&] {
    RobotClient robot({.robot = "walker", .port = listener.port(), .rate = 10});
    EXPECT_EQ(robot.info().model, "kid21");
    EXPECT_EQ(robot.info().period, 0.1);
    EXPECT_EQ(robot.info().seed, 7U);
    EXPECT_TRUE(robot.info().lock_step);
    EXPECT_TRUE(says(error_text([&] { (void)robot.signal("joint.positoin"); }), {"did you mean 'joint.position'"}));
    const Signal& position = robot.signal("joint.position");
    const CommandRow& torque = robot.command("joint.torque_enabled");
    CommandRow& target = robot.command("joint.target");
    EXPECT_TRUE(says(error_text([&] { (void)robot.command("walk.velocity"); }), {"exclude each other"}));
    EXPECT_TRUE(says(error_text([&] { (void)robot.command("joint.target"); }), {"was asked for before"}));
    EXPECT_EQ(torque.values, std::vector<double>(21, 1.0)) << "what holds until it is set";
    EXPECT_EQ(target.labels, position.labels);
    CommandRow& gain = robot.command("joint.position_gain");
    EXPECT_GT(gain.values[0], 0) << "the servo's own";
    CommandRow& led = robot.command("robot.led");
    EXPECT_EQ(led.labels, (std::vector<std::string>{"red", "green", "blue"}));
    const auto head = static_cast<std::size_t>(std::ranges::find(target.labels, "j_head") - target.labels.begin());
    ASSERT_TRUE(robot.next());
    EXPECT_TRUE(robot.starts());
    target.values[head] = 0.3;
    gain.values[head] *= 2;
    led.values = {1, 0.5, 0};
    ASSERT_TRUE(robot.next());
    EXPECT_FALSE(robot.starts());
    EXPECT_EQ(robot.now(), 0);
    int cycles = 1;
    while (robot.next()) ++cycles;
    EXPECT_EQ(cycles, 20);
    EXPECT_EQ(robot.now(), 1'900'000'000);
    EXPECT_EQ(position.time, robot.now());
    EXPECT_EQ(position.samples, 20U);
    EXPECT_NEAR(position.values[head], 0.3, 0.05);
    EXPECT_TRUE(says(error_text([&] { (void)robot.signal("joint.torque"); }), {"after ready()"}));
  });
  {
    scene::Scene scene("walk", {.seed = 7,
                                .overrides = {"walker.controller=tcp", "walker.level=articulated_dynamics"},
                                .cameras = false,
                                .software = listener.server});
    scene.simulation().run(2s);
    const Entity& walker = scene.simulation().world().entity("walker");
    const int head = walker.model().object_index("j_head");
    EXPECT_EQ(walker.find(properties::servo_position_gain)->values[head],
              2 * walker.model().find(properties::servo, head)->position_gain);
    EXPECT_EQ(walker.find(properties::robot_led)->values[0].y, 0.5);
  }
  EXPECT_EQ(client.error(), "");
}

// One thread answers for both, in the order of the robots.
TEST(RobotClient, LetsOneThreadHaveSeveralRobots) {
  const Listener listener;
  int cycles = 0;
  Software both([&] {
    RobotClient left({.robot = "left", .port = listener.port()});
    left.ready();
    RobotClient right({.robot = "right", .port = listener.port()});
    right.ready();
    while (left.next()) {
      left.answer();
      if (!right.next()) break;
      right.answer();
      ++cycles;
    }
  });
  {
    scene::Scene scene(to_the_ball_tcp, two_robots(listener, {"defaults.control_rate=50"}));
    scene.simulation().run(1s);
  }
  EXPECT_EQ(both.error(), "");
  EXPECT_EQ(cycles, 51) << "and the start";
}

TEST(RobotClient, WaitsForASimulatorThatStartsLater) {
  std::uint16_t port = 0;
  { port = Listener().port(); }
  EXPECT_TRUE(says(error_text([&] { RobotClient({.robot = "left", .port = port, .patience = 0.05s}); }),
                   {"127.0.0.1:", "connection refused"}));
}

TEST(RobotClient, IsToldWhyItIsRefused) {
  const Listener listener;
  listener.server->expect({"left", "right"});
  const auto error = [&](const std::string& robot, double rate = 0) {
    return error_text([&] { RobotClient({.robot = robot, .port = listener.port(), .rate = rate, .patience = 5s}); });
  };
  EXPECT_EQ(error("lefd"),
            "the simulator refuses: unknown robot with the controller 'tcp' 'lefd'; did you mean 'left'?");
  EXPECT_EQ(error("left", 1e9),
            "the simulator refuses: it wants a rate of 1000000000 Hz, not between 0.001 and 100000 Hz");
  RawClient first(listener.port());
  first.hello("left");
  std::string second;
  while (second.empty()) second = error("left");
  EXPECT_EQ(second, "the simulator refuses: 'left' has its software already");
}

}  // namespace
}  // namespace murosimf::client
