/// crash_signals.h - handlers of the signals that end a guarded call: crashes, and that of a call that does not come back.
#pragma once

namespace murosimf::connect {

/// From now on, in all threads. Where no guarded call and no thread of control software is, handlers that were there before are called.
void handle_crash_signals();

}  // namespace murosimf::connect
