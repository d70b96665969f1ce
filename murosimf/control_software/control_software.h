/// control_software.h - control software of one robot as the simulation sees it, wherever it runs: in a shared library
/// (library_software.h), behind a socket (tcp_software.h) or at a serial line (serial/serial_software.h).
///
/// A constructor receives a RobotPort, requests signals and commands by name, and keeps the pointers.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "murosimf/control_software/guard/call_outcome.h"
#include "murosimf/control_software/robot_port.h"
#include "murosimf/control_software/software_maker.h"

namespace murosimf::control_software {

class ControlSoftware {
 public:
  virtual ~ControlSoftware() = default;

  /// The run begins, or begins again. May set commands.
  [[nodiscard]] virtual CallOutcome start() = 0;
  /// One cycle. Does not throw for what the software does.
  [[nodiscard]] virtual CallOutcome step(Duration now) noexcept = 0;
  /// Something for the report that has happened meanwhile ("reloaded"); empty: nothing.
  [[nodiscard]] virtual std::string news() { return {}; }
  /// Reads or writes the memory of the software.
  virtual void state(StateArchive&) {}
  /// Whether the software holds state beyond that: it, or the program behind it, continues unchanged when a state is loaded.
  [[nodiscard]] virtual bool keeps_state() const { return true; }
  /// The run has this seed from now on.
  virtual void reseed(std::uint64_t) {}
  /// Whether external input is logged and repeated (external_input_history.h): a repeated step then runs like any other step.
  [[nodiscard]] virtual bool repeats_itself() const { return false; }
  /// What it has written besides commands, so that it can be repeated without the software (controller_task.h).
  [[nodiscard]] virtual std::vector<double> written() const { return {}; }
  virtual void write(const std::vector<double>&) noexcept {}
  /// Reason why no client controls the robot at present, though one may still connect; empty: a client is connected.
  [[nodiscard]] virtual std::string absence() const { return {}; }
};

}  // namespace murosimf::control_software
