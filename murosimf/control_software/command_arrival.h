/// command_arrival.h - algorithm: applies, in every tick, the commands of control software that have arrived over the robot's link.
#pragma once

#include "murosimf/control_software/robot_port.h"
#include "murosimf/world/algorithm.h"

namespace murosimf::control_software {

class CommandArrival final : public Algorithm {
 public:
  /// After the ControllerTask that has the port, which must outlive it.
  CommandArrival(Setup& setup, RobotPort& port) : port_(&port) { port.declare_commands(setup); }

  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void step(const Instant& instant) noexcept override { port_->deliver(instant.now); }

 private:
  RobotPort* port_;
};

}  // namespace murosimf::control_software
