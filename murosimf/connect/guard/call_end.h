/// call_end.h - what has ended a call of code that one does not trust before it came back, and how that is said.
#pragma once

#include <array>

#include "murosimf/connect/guard/guarded_row.h"

namespace murosimf::connect {

struct CallEnd {
  enum Kind {
    signal,          ///< `number`
    late,            ///< it was broken off
    exit,            ///< it has called a function that ends the program, with the code `number`
    thread_exit,     ///< it has called one that ends the thread
    terminate,       ///< std::terminate: an exception that must not leave a function, or a call of it
    written_beyond,  ///< it came back, and has written beyond a row before
  } kind = signal;
  int number = 0;
  const char* function = "";          ///< that it has called
  GuardedRows::Found row{};           ///< that it has gone beyond; null: none
  std::array<char, 200> exception{};  ///< what that said; empty: there was none

  /// "crashed (SIGSEGV)", piece by piece and without memory of its own: may be called in signal handlers. put(const char*).
  template <class Put>
  void say(const Put& put) const;
};

/// "SIGSEGV"
[[nodiscard]] const char* crash_name(int signal) noexcept;

/// A number as text, without memory of its own.
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

}  // namespace murosimf::connect
