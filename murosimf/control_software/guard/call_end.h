/// call_end.h - reason why a call of untrusted code ended early, and its text.
#pragma once

#include <array>

#include "murosimf/control_software/guard/guarded_row.h"

namespace murosimf::control_software {

struct CallEnd {
  enum Kind {
    signal,          ///< `number`
    late,            ///< it was aborted
    exit,            ///< it called a function that ends the program, with the code `number`
    thread_exit,     ///< it called a function that ends the thread
    terminate,       ///< std::terminate: an exception that must not leave a function, or a call of it
    written_beyond,  ///< it returned, but had written beyond a row
  } kind = signal;
  int number = 0;
  const char* function = "";          ///< that it called
  GuardedRows::Found row{};           ///< whose bounds it crossed; null: none
  std::array<char, 200> exception{};  ///< its text; empty: there was none

  /// Writes "crashed (SIGSEGV)", piece by piece and without allocation: may be called in signal handlers. put(const char*).
  template <class Put>
  void say(const Put& put) const;
};

/// "SIGSEGV"
[[nodiscard]] const char* crash_name(int signal) noexcept;

/// A number as text, without allocation.
struct NumberText {
  explicit NumberText(int number) noexcept;
  std::array<char, 16> text{};
};

template <class Put>
void CallEnd::say(const Put& put) const {
  if (row.row) {
    const bool inside = row.side == GuardedRow::Side::inside, behind = row.side == GuardedRow::Side::behind;
    put(inside ? "wrote to '" : behind ? "went beyond the end of '" : "went before the beginning of '");
    put(row.row->name().c_str());
    put(inside ? "', which is to be read only" : "', which has ");
    if (!inside) put(row.row->size().c_str());
  } else if (kind == exit) {
    put("called ");
    put(function);
    put("(");
    put(NumberText(number).text.data());
    put(")");
  } else if (kind == thread_exit) {
    put("called ");
    put(function);
  } else if (kind == terminate) {
    put("called std::terminate");
    if (exception.front() != 0) put(": ");
    put(exception.data());
  } else {
    put("crashed");
  }
  if (kind != signal) return;
  put(" (");
  put(crash_name(number));
  put(")");
}

}  // namespace murosimf::control_software
