/// course_tcp.h - the behavior of course.h in a program that is connected over TCP.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

#include <murosimf/network/robot_client.h>

#include "course.h"

/// Until the run is over. Throws murosimf::client::ClientError.
inline void cross_course_over_tcp(const std::string& name, std::uint16_t port) {
  murosimf::client::RobotClient robot(
      {.robot = name, .port = port, .rate = 1 / CourseRunner::period, .software = "course_tcp"});
  const auto& position = robot.signal("joint.position");
  auto& command = robot.command("joint.target");
  auto& led = robot.command("robot.led");
  std::array<std::size_t, CourseRunner::joint_count> places{};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto found = std::find(command.labels.begin(), command.labels.end(), CourseRunner::joints[i]);
    if (found == command.labels.end()) throw murosimf::client::ClientError(name + " is no kid21");
    places[i] = static_cast<std::size_t>(found - command.labels.begin());
  }
  CourseRunner runner;
  while (robot.next()) {
    if (robot.starts()) {
      runner = {};
      continue;
    }
    CourseRunner::Angles measured, target;
    for (std::size_t i = 0; i < places.size(); ++i) measured[i] = position.values[places[i]];
    if (runner.step(measured, target)) robot.say("I am there");
    for (std::size_t i = 0; i < places.size(); ++i) command.values[places[i]] = target[i];
    led.values[1] = runner.arrived ? 1 : 0;
  }
}
