/// call_outcome.h - how a call of untrusted code has ended.
#pragma once

#include <string>

#include "murosimf/control_software/guard/process_change.h"

namespace murosimf::control_software {

/// How a call of control software has ended.
struct CallOutcome {
  enum Kind {
    good,
    threw,    ///< an exception
    late,     ///< it did not return and was aborted
    crashed,  ///< it would have ended the program (guarded_call.h): the process's memory is in an unknown state
  } kind = good;
  std::string text{};  ///< "its step threw: no such state"
  /// Properties of the process or the thread that it changed and that were restored, however it ended.
  ProcessChanges changes{};

  [[nodiscard]] explicit operator bool() const { return kind == good; }
};

}  // namespace murosimf::control_software
