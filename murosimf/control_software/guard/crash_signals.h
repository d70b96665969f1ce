/// crash_signals.h - handlers of the signals that end a guarded call: crashes, and that of an overdue call.
#pragma once

namespace murosimf::control_software {

/// Installs the handlers, for all threads. Outside of guarded calls and threads of control software, the previous handlers are called.
void handle_crash_signals();

}  // namespace murosimf::control_software
