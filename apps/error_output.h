/// error_output.h - error messages of the program: one line on standard error, even when that is closed or the memory is used up.
#pragma once

#include <string_view>

namespace murosimf::app {

// Exit codes.
constexpr int user_error = 2;
constexpr int unexpected = 3;  ///< no memory, or an error of the program

/// "murosimf: text" in one line on standard error. Never throws: a line that cannot be written is lost, and the exit code
/// still tells of the error.
void say_error(std::string_view text, std::string_view hint = {}) noexcept;

/// "warning: text", likewise.
void say_warning(std::string_view text) noexcept;

/// "text", likewise, for messages that are no errors.
void say_note(std::string_view text) noexcept;

/// The text unchanged, without a line break: for lines that change on a terminal.
void show_on_terminal(std::string_view text) noexcept;

/// From now on memory that is used up where it cannot be caught (in a step, in another thread) ends the program with one line and
/// the exit code `unexpected`.
void report_uncaught_exceptions();

/// Prints one line about the exception that is being handled, and returns the exit code.
int exit_code_of_exception() noexcept;

/// What main() returns. After a crash of control software it does not return: nothing is cleaned up that may hang or crash, too, and the
/// code is `unexpected`.
[[nodiscard]] int end_of_program(int code) noexcept;

}  // namespace murosimf::app
