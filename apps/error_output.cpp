#include "apps/error_output.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <system_error>

#include "murosimf/control_software/crash_note.h"
#include "murosimf/control_software/guard/guarded_call.h"
#include "murosimf/model/error.h"

namespace murosimf::app {
namespace {

constexpr std::string_view no_memory =
    "out of memory; make the scene smaller or the run shorter, log less, or raise the limit (ulimit -v)";

/// As much of it as can be written; no allocation.
void write_all(std::string_view text) noexcept {
  while (!text.empty()) {
    const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// Control characters would make several lines of one.
void write_printable(std::string_view text) noexcept {
  const auto breaks = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 0x7f; };
  while (!text.empty()) {
    const auto* const stop = std::find_if(text.begin(), text.end(), breaks);
    const auto plain = static_cast<std::size_t>(stop - text.begin());
    write_all(text.substr(0, plain));
    if (stop != text.end()) write_all(" ");
    text.remove_prefix(std::min(text.size(), plain + 1));
  }
}

/// For std::terminate: the program cannot go on, and nothing of it is safe to be cleaned up.
[[noreturn]] void end_at_once() noexcept {
  static std::atomic_flag said;
  while (said.test_and_set()) ::pause();  // another thread says it, and ends the program
  if (std::current_exception()) _exit(exit_code_of_exception());
  say_error("unexpected: the program ended itself");
  std::abort();
}

}  // namespace

void say_error(std::string_view text, std::string_view hint) noexcept {
  write_all("murosimf: ");
  write_printable(text);
  write_printable(hint);
  write_all("\n");
}

void say_warning(std::string_view text) noexcept {
  write_all("warning: ");
  write_printable(text);
  write_all("\n");
}

void say_note(std::string_view text) noexcept {
  write_printable(text);
  write_all("\n");
}

void show_on_terminal(std::string_view text) noexcept { write_all(text); }

void report_uncaught_exceptions() { std::set_terminate(end_at_once); }

int exit_code_of_exception() noexcept {
  try {
    throw;
  } catch (const SetupError& error) {
    say_error(error.what());
    return user_error;
  } catch (const control_software::SoftwareCrash&) {
    // said when it happened (control_software/guard/guarded_call.h)
  } catch (const std::bad_alloc&) {
    say_error(no_memory);
  } catch (const std::length_error&) {
    say_error(no_memory);
  } catch (const std::exception& error) {
    say_error("unexpected: ", error.what());
  } catch (...) {
    say_error("unexpected: no reason is known");
  }
  return unexpected;
}

int end_of_program(int code) noexcept {
  if (!control_software::software_has_crashed()) return code;
  (void)std::fflush(nullptr);
  _exit(unexpected);
}

}  // namespace murosimf::app
