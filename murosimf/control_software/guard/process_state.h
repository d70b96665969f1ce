/// process_state.h - state of the process and the thread that a call of control software could change, saved before it, restored after it.
#pragma once

#include <sys/time.h>
#include <sys/types.h>

#include <array>
#include <clocale>
#include <csignal>
#include <exception>
#include <locale>
#include <optional>
#include <string>

#include "murosimf/control_software/guard/process_change.h"
#include "murosimf/math/floating_point.h"

namespace murosimf::control_software {

/// The part that needs no system call (some ten nanoseconds): floating-point modes, locales, terminate handler.
class CallState {
 public:
  CallState() noexcept;
  /// Restores the state and returns what had changed since construction.
  [[nodiscard]] ProcessChanges put_back() const noexcept;

 private:
  void put_back_locale(ProcessChanges& changes) const noexcept;

  FloatingPointModes modes_ = FloatingPointModes::now();
  const char* c_locale_;  // its name; a copy
  locale_t thread_locale_;
  std::locale locale_;
  std::terminate_handler terminate_ = std::get_terminate();
};

/// The rest, by some forty system calls.
class ProcessState {
 public:
  ProcessState();
  ~ProcessState();
  ProcessState(const ProcessState&) = delete;
  ProcessState& operator=(const ProcessState&) = delete;

  [[nodiscard]] ProcessChanges put_back() const noexcept;

 private:
  /// A file that is kept open by a descriptor of its own; -1: there is none.
  struct Held {
    int descriptor = -1;
    dev_t device{};
    ino_t number{};
  };
  static constexpr std::array signals{SIGHUP,  SIGINT,   SIGQUIT, SIGTERM, SIGPIPE, SIGCHLD,  SIGALRM,
                                      SIGUSR1, SIGUSR2,  SIGXFSZ, SIGTSTP, SIGCONT, SIGSEGV,  SIGBUS,
                                      SIGFPE,  SIGILL,   SIGABRT, SIGTRAP, SIGSYS,  SIGPROF,  SIGIO,
                                      SIGURG,  SIGWINCH, SIGTTIN, SIGTTOU, SIGXCPU, SIGVTALRM};
  static constexpr std::array timers{ITIMER_REAL, ITIMER_VIRTUAL, ITIMER_PROF};
  static constexpr std::array variables{"LC_ALL",      "LC_NUMERIC",  "LC_CTYPE", "LC_TIME",  "LC_COLLATE",
                                        "LC_MESSAGES", "LC_MONETARY", "LANG",     "LANGUAGE", "TZ",
                                        "PATH",        "HOME",        "TMPDIR"};

  [[nodiscard]] static Held hold(int descriptor);
  [[nodiscard]] bool put_back_directory() const noexcept;
  [[nodiscard]] bool put_back_handlers() const noexcept;
  [[nodiscard]] bool put_back_timers() const noexcept;
  [[nodiscard]] bool put_back_environment() const noexcept;
  [[nodiscard]] bool put_back_files() const noexcept;
  [[nodiscard]] bool put_back_mask() const noexcept;
  [[nodiscard]] bool put_back_stack() const noexcept;

  Held directory_;
  std::array<Held, 3> files_;
  mode_t file_mask_;
  std::array<struct sigaction, signals.size() + 1> handlers_{};  // and that of break_off_signal()
  std::array<itimerval, timers.size()> timers_{};
  std::array<std::optional<std::string>, variables.size()> environment_;
  sigset_t mask_{};
  stack_t stack_{};
};

}  // namespace murosimf::control_software
