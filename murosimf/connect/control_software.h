/// control_software.h - control software of one robot as the simulation sees it, wherever it runs: in a shared library
/// (library_software.h), behind a socket (tcp_software.h) or at a serial line (serial/serial_software.h).
///
/// Whoever makes one gets a RobotPort, asks it for signals and commands by name, and keeps the pointers.
#pragma once

#include <string>

#include "murosimf/connect/guard/call_outcome.h"
#include "murosimf/connect/robot_port.h"
#include "murosimf/connect/software_maker.h"

namespace murosimf::connect {

class ControlSoftware {
 public:
  virtual ~ControlSoftware() = default;

  /// The run begins, or begins again. May set commands.
  [[nodiscard]] virtual CallOutcome start() = 0;
  /// One cycle. Does not throw for what the software does.
  [[nodiscard]] virtual CallOutcome step(Duration now) noexcept = 0;
  /// Something for the report that has happened meanwhile ("reloaded"); empty: nothing.
  [[nodiscard]] virtual std::string news() { return {}; }
  /// Its memory.
  virtual void state(StateArchive&) {}
  /// Whether it remembers more than that: it, or who is behind it, goes on as it is when a state is loaded.
  [[nodiscard]] virtual bool keeps_state() const { return true; }
  /// Whether it writes down what comes from outside, and repeats it (external_input_history.h): a step that is repeated is one as others then.
  [[nodiscard]] virtual bool repeats_itself() const { return false; }
  /// Why nobody steers the robot now, though somebody may come; empty: somebody does.
  [[nodiscard]] virtual std::string absence() const { return {}; }
};

}  // namespace murosimf::connect
