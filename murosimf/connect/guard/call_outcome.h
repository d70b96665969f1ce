/// call_outcome.h - how a call of code that one does not trust has ended.
#pragma once

#include <string>

#include "murosimf/connect/guard/process_change.h"

namespace murosimf::connect {

/// How a call of control software has ended.
struct CallOutcome {
  enum Kind {
    good,
    threw,    ///< an exception
    late,     ///< it did not come back and was broken off
    crashed,  ///< it would have ended the program (guarded_call.h): what it has left of the process's memory is unknown
  } kind = good;
  std::string text{};  ///< "its step threw: no such state"
  /// What it has changed of the process or the thread, and what was put back; however it has ended.
  ProcessChanges changes{};

  [[nodiscard]] explicit operator bool() const { return kind == good; }
};

}  // namespace murosimf::connect
