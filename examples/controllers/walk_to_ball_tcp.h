/// walk_to_ball_tcp.h - the behavior of walk_to_ball.h in a program that is connected over TCP.
#pragma once

#include <cstdint>
#include <string>

#include <murosimf/network/robot_client.h>

#include "walk_to_ball.h"

/// Until the run is over. Throws murosimf::client::ClientError.
inline void walk_to_ball(const std::string& name, std::uint16_t port) {
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
