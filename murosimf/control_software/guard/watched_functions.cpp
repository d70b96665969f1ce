#include "murosimf/control_software/guard/watched_functions.h"

#include <dlfcn.h>
#include <pthread.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "murosimf/control_software/guard/foreign_call.h"
#include "murosimf/control_software/guard/signal_stack.h"

// The thread sanitizer calls them before it is ready for instrumented code, as these are. In fuzz targets the sanitizer is part
// of the program and defines some of these functions itself.
#if defined(MUROSIMF_THREAD_SANITIZER) || defined(MUROSIMF_FUZZED)
#define MUROSIMF_FUNCTIONS_NOT_WATCHED
#endif

namespace murosimf::control_software {
namespace {

/// The function of the C library.
template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

/// In a guarded call, or in a thread that it has started, this ends the call or thread.
void end_software(CallEnd::Kind kind, const char* function, int code = 0) {
  if (!is_own_process()) return;
  const CallEnd why{.kind = kind, .number = code, .function = function};
  if (ForeignCall* running = ForeignCall::of_thread()) running->end(why);
  ForeignThreads* owner = owner_of_thread();
  if (owner && kind == CallEnd::exit) end_thread(*owner, why);
}

void at_exit() { end_software(CallEnd::exit, "exit"); }

#ifndef MUROSIMF_FUNCTIONS_NOT_WATCHED

void before_a_change() {
  if (ForeignCall* running = ForeignCall::of_thread(); running && is_own_process()) running->keep_process();
}

/// A thread started by control software.
struct Beginning {
  void* (*function)(void*);
  void* argument;
  std::shared_ptr<ForeignThreads> owner;
};

void* begin_thread(void* given) {
  const std::unique_ptr<Beginning> beginning(static_cast<Beginning*>(given));
  set_owner_of_thread(beginning->owner.get());
  const SignalStack stack;
  return beginning->function(beginning->argument);
}

/// Owner of the present call or thread.
std::shared_ptr<ForeignThreads> present_owner() {
  if (const ForeignCall* running = ForeignCall::of_thread()) return running->call.threads;
  ForeignThreads* owner = owner_of_thread();
  return owner ? owner->shared_from_this() : nullptr;
}

#endif

}  // namespace

void watch_functions() { (void)std::atexit(at_exit); }

}  // namespace murosimf::control_software

#ifndef MUROSIMF_FUNCTIONS_NOT_WATCHED

using murosimf::control_software::before_a_change;
using murosimf::control_software::CallEnd;
using murosimf::control_software::end_software;
using murosimf::control_software::next;

/// Defines a function that ends the program.
#define MUROSIMF_ENDS(name)                           \
  extern "C" void name(int code) noexcept {           \
    end_software(CallEnd::exit, #name, code);         \
    static auto* const real = next<void(int)>(#name); \
    real(code);                                       \
    __builtin_unreachable();                          \
  }
// NOLINTBEGIN(bugprone-reserved-identifier): they are those of the C library
MUROSIMF_ENDS(quick_exit)

/// An end of the process inside a call is the end of the software, not of the simulation.
extern "C" void exit(int code) noexcept {
  if (murosimf::control_software::is_child_of_software()) ::_exit(code);
  end_software(CallEnd::exit, "exit", code);
  static auto* const real = next<void(int)>("exit");
  real(code);
  __builtin_unreachable();
}

extern "C" void _exit(int code) {
  end_software(CallEnd::exit, "_exit", code);
  static auto* const real = next<void(int)>("_exit");
  real(code);
  __builtin_unreachable();
}
MUROSIMF_ENDS(_Exit)

extern "C" void pthread_exit(void* result) {
  end_software(CallEnd::thread_exit, "pthread_exit");
  static auto* const real = next<void(void*)>("pthread_exit");
  real(result);
  __builtin_unreachable();
}

/// Defines a function that changes state of the process.
#define MUROSIMF_CHANGES(result, name, parameters, arguments) \
  extern "C" result name parameters noexcept {                \
    static auto* const real = next<result parameters>(#name); \
    before_a_change();                                        \
    return real arguments;                                    \
  }
MUROSIMF_CHANGES(int, chdir, (const char* path), (path))
MUROSIMF_CHANGES(int, fchdir, (int folder), (folder))
MUROSIMF_CHANGES(mode_t, umask, (mode_t mask), (mask))
MUROSIMF_CHANGES(sighandler_t, signal, (int number, sighandler_t handler), (number, handler))
MUROSIMF_CHANGES(int, sigaction, (int number, const struct sigaction* action, struct sigaction* old),
                 (number, action, old))
MUROSIMF_CHANGES(int, sigprocmask, (int how, const sigset_t* set, sigset_t* old), (how, set, old))
MUROSIMF_CHANGES(int, pthread_sigmask, (int how, const sigset_t* set, sigset_t* old), (how, set, old))
MUROSIMF_CHANGES(int, sigaltstack, (const stack_t* stack, stack_t* old), (stack, old))
MUROSIMF_CHANGES(int, setitimer, (__itimer_which_t which, const struct itimerval* value, struct itimerval* old),
                 (which, value, old))
MUROSIMF_CHANGES(unsigned, alarm, (unsigned seconds), (seconds))
MUROSIMF_CHANGES(int, setenv, (const char* name, const char* value, int replace), (name, value, replace))
MUROSIMF_CHANGES(int, unsetenv, (const char* name), (name))
MUROSIMF_CHANGES(int, putenv, (char* text), (text))
MUROSIMF_CHANGES(int, clearenv, (), ())
MUROSIMF_CHANGES(int, dup2, (int from, int to), (from, to))
MUROSIMF_CHANGES(int, dup3, (int from, int to, int flags), (from, to, flags))

/// A standard descriptor is restored afterwards.
extern "C" int close(int file) {
  static auto* const real = next<int(int)>("close");
  if (file >= 0 && file <= STDERR_FILENO) before_a_change();
  return real(file);
}

/// A standard stream could not be opened again: in a guarded call it is only flushed.
extern "C" int fclose(FILE* file) {
  static auto* const real = next<int(FILE*)>("fclose");
  const bool standard = file == stdin || file == stdout || file == stderr;
  murosimf::control_software::ForeignCall* running = murosimf::control_software::ForeignCall::of_thread();
  if (!standard || !running) return real(file);
  before_a_change();
  (void)std::fflush(file);
  return ::close(::fileno(file));
}

/// A thread that control software begins belongs to it.
extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*function)(void*),
                              void* argument) noexcept {
  using murosimf::control_software::Beginning;
  static auto* const real = next<int(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*)>("pthread_create");
  auto owner = murosimf::control_software::present_owner();
  if (!owner) return real(thread, attributes, function, argument);
  auto beginning = std::make_unique<Beginning>(Beginning{function, argument, std::move(owner)});
  const int failed = real(thread, attributes, murosimf::control_software::begin_thread, beginning.get());
  if (failed == 0) (void)beginning.release();
  return failed;
}
// NOLINTEND(bugprone-reserved-identifier)

#endif
