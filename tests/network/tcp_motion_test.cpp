// The motion engine over TCP: software reads its state, and requests a kick.
#include <gtest/gtest.h>

#include "tests/network/tcp_fixture.h"

namespace murosimf::control_software {
namespace {

using namespace fixtures;

/// Values that the software has received.
struct Seen {
  std::vector<double> modes;  // one after the other, each once
  std::vector<std::string> motions;
  double heading = 0;  // [rad] at the end
  bool fallen = false;
};

Seen kick_to_the_left(std::uint16_t port) {
  client::RobotClient robot({.robot = "left", .port = port, .rate = 20});
  const auto& mode = robot.signal("motion.mode");
  const auto& phase = robot.signal("motion.phase");
  const auto& odometry = robot.signal("motion.odometry");
  const auto& fallen = robot.signal("motion.fallen");
  auto& kick = robot.command("motion.kick");
  Seen seen;
  for (int i = 0; robot.next(); ++i) {
    if (mode.samples == 0) continue;
    if (seen.modes.empty() || seen.modes.back() != mode.values[0]) seen.modes.push_back(mode.values[0]);
    for (std::size_t k = 0; k < phase.values.size(); ++k) {
      if (phase.values[k] >= 0 && (seen.motions.empty() || seen.motions.back() != phase.labels[k]))
        seen.motions.push_back(phase.labels[k]);
    }
    seen.heading = odometry.values[2];
    seen.fallen = seen.fallen || fallen.values[0] != 0;
    if (i == 10) kick.values = {1, 0.4, -1, 0, 0};  // with the right foot, after a turn on the spot
  }
  return seen;
}

TEST(TcpMotions, SoftwareReadsTheEngineAndHasItKick) {
  const Listener listener;
  Seen seen;
  Software left([&] { seen = kick_to_the_left(listener.port()); });
  Software right([&] { walk_to_ball("right", listener.port()); });
  {
    scene::Scene scene(to_the_ball_tcp, two_robots(listener, {"left.level=kinematic_walking"}));
    scene.simulation().run(10s);
  }
  EXPECT_EQ(left.error(), "");
  ASSERT_GE(seen.modes.size(), 4U);
  EXPECT_EQ(seen.modes.front(), 0) << "stands";
  EXPECT_EQ(seen.modes[1], 1) << "turns";
  EXPECT_EQ(seen.modes[seen.modes.size() - 2], 2) << "kicks";
  EXPECT_EQ(seen.modes.back(), 0) << "stands";
  EXPECT_EQ(seen.motions, std::vector<std::string>{"kick_right"});
  EXPECT_NEAR(seen.heading, 0.4, 0.15);
  EXPECT_FALSE(seen.fallen);
}

}  // namespace
}  // namespace murosimf::control_software
