// Control software in a program of its own: the behavior of walk_to_ball.h over TCP.
//   murosimf run examples/controllers/to_the_ball_tcp.toml --listen 5000 &
//   walk_to_ball_tcp 5000 left & walk_to_ball_tcp 5000 right
#include <cstdio>
#include <cstdlib>
#include <string>

#include <murosimf/client/robot_client.h>

#include "walk_to_ball.h"

namespace {

void walk(const std::string& name, std::uint16_t port) {
  murosimf::client::RobotClient robot({.robot = name, .port = port, .rate = 20, .software = "walk_to_ball_tcp"});
  const auto& ball = robot.signal("ground_truth.ball_position");
  const auto& place = robot.signal("ground_truth." + name + "_position");
  const auto& heading = robot.signal("ground_truth." + name + "_heading");
  auto& velocity = robot.command("walk.velocity");
  WalkToBall behavior;
  while (robot.next()) {
    if (robot.starts()) behavior.arrived = false;
    if (robot.starts() || ball.samples == 0) continue;
    const Seen seen{ball.values.data(), place.values.data(), heading.values[0]};
    if (behavior.step(seen, velocity.values.data())) robot.say("I am at the ball");
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::fprintf(stderr, "usage: walk_to_ball_tcp PORT ROBOT\n");
    return 2;
  }
  try {
    walk(arguments[2], static_cast<std::uint16_t>(std::strtoul(arguments[1], nullptr, 10)));
    return 0;
  } catch (const murosimf::client::ClientError& error) {
    std::fprintf(stderr, "%s: %s\n", arguments[2], error.what());
    return 1;
  }
}
