/// interruption.h - Ctrl-C and its like end a long command early, without losing its results.
///
/// SIGINT (Ctrl-C), SIGTERM (kill, timeout, a cluster's scheduler) and SIGHUP (the terminal went away) are treated alike.
/// At first each ends the program at once. After end_gently() the first of them is only a request: the command checks
/// interrupted() in its loops, ends them, writes its results, and returns exit_code(). The next one, unless it comes within
/// a tenth of a second (`timeout` sends two), ends the program at once. At once means: as if it were not caught, except that
/// half-written files are removed and programs that it has started are ended (files/cleanup_guard.h).
///
/// SIGXFSZ, which comes when a file reaches the limit of sizes (ulimit -f), is ignored: writing fails then as on a full disk.
///
/// The library does not handle signals; its loops have a `stop` function (Simulation::stop_if).
#pragma once

#include <string>

namespace murosimf::app {

/// To be called once, first of all. A SIGHUP that is ignored (nohup) stays ignored.
void catch_signals();
/// For commands that check interrupted().
void end_gently();

[[nodiscard]] bool interrupted();
/// "SIGINT", "SIGTERM" or "SIGHUP"; empty: nothing has come.
[[nodiscard]] std::string signal_name();
/// 128 + number of the signal, as shells have it: 130, 143 or 129; 0: nothing has come.
[[nodiscard]] int exit_code();

}  // namespace murosimf::app
