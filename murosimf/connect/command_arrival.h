/// command_arrival.h - algorithm: applies, in every tick, the commands of control software that have arrived over the robot's link.
#pragma once

#include "murosimf/connect/robot_port.h"
#include "murosimf/model/algorithm.h"

namespace murosimf::connect {

class CommandArrival final : public Algorithm {
 public:
  /// After the ControllerTask that has the port, which must outlive it.
  CommandArrival(Setup& setup, RobotPort& port) : port_(&port) { port.declare_commands(setup); }

  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void step(const Instant& instant) noexcept override { port_->deliver(instant.now); }

 private:
  RobotPort* port_;
};

}  // namespace murosimf::connect
