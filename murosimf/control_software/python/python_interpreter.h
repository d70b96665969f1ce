/// python_interpreter.h - Python for classes of control software: the module murosimf-python.so, and in the program `murosimf` the library of
/// Python itself, both loaded when the first class is. In a Python program its own interpreter is used.
#pragma once

#include "murosimf/control_software/python/python_backend.h"

namespace murosimf::control_software {

/// Begins Python at the first call. Throws SetupError in one line: there is no module, no Python, or no NumPy in it.
[[nodiscard]] PythonBackend& python_backend();

/// Whether this is a Python program, with an interpreter of its own.
[[nodiscard]] bool in_python_program();

/// Before the first class is loaded: from then on calls of classes are ended while `asked` says so. A Python program does this itself.
void end_python_calls_if(bool (*asked)());

}  // namespace murosimf::control_software
