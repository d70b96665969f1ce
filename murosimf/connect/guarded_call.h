/// guarded_call.h - calls code that one does not trust: exceptions, crashes and calls that do not come back end the call, not the
/// program.
///
/// A crash is one of SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT in the thread of the call. One line about it goes to standard error at
/// once, since nothing is certain afterwards; then the call is left by a jump. What the code held (memory, locks) stays so; it must
/// not be called again. A program that has not ended a minute after a crash is ended. A call is broken off by a signal that a
/// thread of its own sends when the limit has passed.
#pragma once

#include <functional>
#include <string>

#include "murosimf/connect/control_software.h"

namespace murosimf::connect {

struct GuardedCall {
  std::string who;   ///< "library 'libwalk.so' of blue1"
  std::string what;  ///< "its step"
  Duration limit{};  ///< of wall time

  /// Any thread; several at the same time.
  [[nodiscard]] CallOutcome operator()(const std::function<void()>& call) const noexcept;
};

}  // namespace murosimf::connect
