#include "murosimf/control_software/guard/process_state.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <span>

#include "murosimf/control_software/guard/call_watch.h"
#include "murosimf/math/assert.h"

namespace murosimf::control_software {
namespace {

constexpr mode_t nobody_else = 077;  // permissions denied to files that another thread creates while the umask is read

mode_t present_file_mask() {
  const mode_t mask = ::umask(nobody_else);
  (void)::umask(mask);
  return mask;
}

int signal_of(std::size_t i, std::span<const int> signals) {
  MUROSIMF_ASSERT(i <= signals.size());
  return i < signals.size() ? signals[i] : break_off_signal();
}

/// Flags without a handler are ignored: a function that restores the handler (system) may set other flags.
bool same(const struct sigaction& one, const struct sigaction& other) {
  const bool is_none = one.sa_handler == SIG_DFL || one.sa_handler == SIG_IGN;
  return one.sa_handler == other.sa_handler && (is_none || one.sa_flags == other.sa_flags);
}

bool runs(const itimerval& timer) { return timer.it_value.tv_sec != 0 || timer.it_value.tv_usec != 0; }

bool same_interval(const itimerval& one, const itimerval& other) {
  return one.it_interval.tv_sec == other.it_interval.tv_sec && one.it_interval.tv_usec == other.it_interval.tv_usec;
}

bool same_signals(const sigset_t& one, const sigset_t& other) {
  for (int signal = 1; signal < NSIG; ++signal) {
    if (sigismember(&one, signal) != sigismember(&other, signal)) return false;
  }
  return true;
}

/// Copies the name of the current C locale: the C library frees it when the locale changes.
const char* kept_name() noexcept {
  thread_local std::array<char, 500> name{};
  const char* const present = std::setlocale(LC_ALL, nullptr);
  if (present && std::strcmp(present, name.data()) != 0) std::strncpy(name.data(), present, name.size() - 1);
  return name.data();
}

}  // namespace

CallState::CallState() noexcept : c_locale_(kept_name()), thread_locale_(::uselocale(nullptr)) {}

/// Modes of floating-point numbers would change all results of the simulation from here on.
ProcessChanges CallState::put_back() const noexcept {
  ProcessChanges changes;
  if (const FloatingPointModes now = FloatingPointModes::now(); now != modes_) {
    const bool rounds = !now.rounds_like(modes_), traps = !now.traps_like(modes_);
    changes.add_if(rounds, ProcessChange::rounding);
    changes.add_if(traps, ProcessChange::traps);
    changes.add_if(!rounds && !traps, ProcessChange::tiny_numbers);
    modes_.set();
  }
  put_back_locale(changes);
  if (std::get_terminate() != terminate_) {
    changes.add(ProcessChange::terminate_handler);
    std::set_terminate(terminate_);
  }
  return changes;
}

/// Restores the C++ locale first, because that also sets the C locale.
void CallState::put_back_locale(ProcessChanges& changes) const noexcept {
  if (::uselocale(nullptr) != thread_locale_) {
    changes.add(ProcessChange::locale);
    ::uselocale(thread_locale_);
  }
  if (std::locale() != locale_) {
    changes.add(ProcessChange::locale);
    std::locale::global(locale_);
  }
  const char* const present = std::setlocale(LC_ALL, nullptr);
  if (!present || std::strcmp(present, c_locale_) == 0) return;
  changes.add(ProcessChange::locale);
  std::setlocale(LC_ALL, c_locale_);
}

/// Device and number identify the file also after its descriptor was closed and given to another.
ProcessState::Held ProcessState::hold(int descriptor) {
  Held held;
  struct stat status {};
  if (descriptor < 0 || ::fstat(descriptor, &status) != 0) return held;
  held.descriptor = descriptor;
  held.device = status.st_dev;
  held.number = status.st_ino;
  return held;
}

ProcessState::ProcessState() : file_mask_(present_file_mask()) {
  directory_ = hold(::open(".", O_PATH | O_DIRECTORY | O_CLOEXEC));
  for (int i = 0; i < 3; ++i) files_[static_cast<std::size_t>(i)] = hold(::fcntl(i, F_DUPFD_CLOEXEC, 3));
  for (std::size_t i = 0; i < handlers_.size(); ++i) ::sigaction(signal_of(i, signals), nullptr, &handlers_[i]);
  for (std::size_t i = 0; i < timers_.size(); ++i) ::getitimer(timers[i], &timers_[i]);
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if (const char* value = std::getenv(variables[i])) environment_[i] = value;
  }
  ::pthread_sigmask(SIG_SETMASK, nullptr, &mask_);
  ::sigaltstack(nullptr, &stack_);
}

ProcessState::~ProcessState() {
  for (const Held& held : {directory_, files_[0], files_[1], files_[2]}) {
    if (held.descriptor >= 0) ::close(held.descriptor);
  }
}

ProcessChanges ProcessState::put_back() const noexcept {
  ProcessChanges changes;
  changes.add_if(put_back_directory(), ProcessChange::directory);
  changes.add_if(present_file_mask() != file_mask_, ProcessChange::file_mask);
  (void)::umask(file_mask_);
  changes.add_if(put_back_handlers(), ProcessChange::handlers);
  changes.add_if(put_back_mask(), ProcessChange::signal_mask);
  changes.add_if(put_back_stack(), ProcessChange::signal_stack);
  changes.add_if(put_back_timers(), ProcessChange::timers);
  changes.add_if(put_back_environment(), ProcessChange::environment);
  changes.add_if(put_back_files(), ProcessChange::standard_files);
  return changes;
}

bool ProcessState::put_back_directory() const noexcept {
  struct stat now {};
  if (directory_.descriptor < 0) return false;
  if (::stat(".", &now) == 0 && now.st_dev == directory_.device && now.st_ino == directory_.number) return false;
  (void)!::fchdir(directory_.descriptor);
  return true;
}

/// A handler of software would catch the program's own crashes.
bool ProcessState::put_back_handlers() const noexcept {
  bool changed = false;
  for (std::size_t i = 0; i < handlers_.size(); ++i) {
    struct sigaction now {};
    const int signal = signal_of(i, signals);
    if (::sigaction(signal, nullptr, &now) != 0 || same(now, handlers_[i])) continue;
    changed = true;
    ::sigaction(signal, &handlers_[i], nullptr);
  }
  return changed;
}

bool ProcessState::put_back_mask() const noexcept {
  sigset_t now{};
  ::pthread_sigmask(SIG_SETMASK, &mask_, &now);
  return !same_signals(now, mask_);
}

bool ProcessState::put_back_stack() const noexcept {
  stack_t now{};
  ::sigaltstack(nullptr, &now);
  if (now.ss_sp == stack_.ss_sp && now.ss_flags == stack_.ss_flags) return false;
  ::sigaltstack(&stack_, nullptr);
  return true;
}

/// A timer that ran before continues.
bool ProcessState::put_back_timers() const noexcept {
  bool changed = false;
  for (std::size_t i = 0; i < timers_.size(); ++i) {
    itimerval now{};
    ::getitimer(timers[i], &now);
    if (runs(now) == runs(timers_[i]) && same_interval(now, timers_[i])) continue;
    changed = true;
    ::setitimer(timers[i], &timers_[i], nullptr);
  }
  return changed;
}

/// Only variables on which the library's results depend.
bool ProcessState::put_back_environment() const noexcept {
  bool changed = false;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const char* const now = std::getenv(variables[i]);
    const auto& before = environment_[i];
    if (before ? now && *before == now : !now) continue;
    changed = true;
    if (before) {
      ::setenv(variables[i], before->c_str(), 1);
    } else {
      ::unsetenv(variables[i]);
    }
  }
  return changed;
}

bool ProcessState::put_back_files() const noexcept {
  bool changed = false;
  for (int i = 0; i < 3; ++i) {
    const Held& held = files_[static_cast<std::size_t>(i)];
    struct stat now {};
    if (held.descriptor < 0) continue;
    if (::fstat(i, &now) == 0 && now.st_dev == held.device && now.st_ino == held.number) continue;
    changed = true;
    ::dup2(held.descriptor, i);
  }
  return changed;
}

}  // namespace murosimf::control_software
