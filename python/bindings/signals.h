/// signals.h - long calls without the lock of the interpreter, that still answer Ctrl-C.
#pragma once

#include <nanobind/nanobind.h>

#include <chrono>

namespace murosimf::python {

/// Asks the interpreter every 10 ms whether a signal has come. Throws what its handler raises: KeyboardInterrupt.
class Signals {
 public:
  /// Without the lock of the interpreter.
  void check() {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + period;
    const nanobind::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0) throw nanobind::python_error();
  }

 private:
  static constexpr std::chrono::milliseconds period{10};
  std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now() + period;
};

}  // namespace murosimf::python
