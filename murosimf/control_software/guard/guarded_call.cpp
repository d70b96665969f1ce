#include "murosimf/control_software/guard/guarded_call.h"

#include <fmt/format.h>

#include "murosimf/control_software/guard/call_watch.h"
#include "murosimf/control_software/guard/crash_signals.h"
#include "murosimf/control_software/guard/foreign_call.h"
#include "murosimf/control_software/guard/signal_stack.h"
#include "murosimf/control_software/guard/watched_functions.h"
#include "murosimf/math/assert.h"

namespace murosimf::control_software {
namespace {

/// Resources that a thread needs for its calls.
struct ThreadGuard {
  ThreadGuard() : place(CallWatch::the_one().take()) {}
  ~ThreadGuard() { CallWatch::the_one().give_back(place); }
  ThreadGuard(const ThreadGuard&) = delete;
  ThreadGuard& operator=(const ThreadGuard&) = delete;

  SignalStack stack;
  CallWatch::Place& place;
};

/// Exceptions must not pass frames of software that was built by another compiler.
CallOutcome without_exceptions(const GuardedCall& guard, const std::function<void()>& call) {
  try {
    call();
    return {};
  } catch (const std::exception& error) {
    return {CallOutcome::threw, fmt::format("{}: {} threw: {}", guard.name, guard.what, error.what())};
  } catch (...) {
    return {CallOutcome::threw,
            fmt::format("{}: {} threw something that is no std::exception", guard.name, guard.what)};
  }
}

CallOutcome crash(const std::string& name, const std::string& what, const CallEnd& why) {
  CallOutcome outcome{CallOutcome::crashed, fmt::format("{}: {} ", name, what)};
  why.say([&](const char* piece) { outcome.text += piece; });
  return outcome;
}

}  // namespace

CallOutcome outcome_of(const ForeignThreads& threads) {
  return crash(threads.name, "a thread of its own", threads.why);
}

namespace {

CallOutcome outcome_of(const ForeignCall& ended) {
  const GuardedCall& guard = ended.call;
  if (ended.why.kind != CallEnd::late) return crash(guard.name, guard.what, ended.why);
  if (guard.threads && guard.threads->ended) return outcome_of(*guard.threads);  // it waited for the crashed thread
  return {CallOutcome::late,
          fmt::format("{}: {} did not come back within {:g} s", guard.name, guard.what, seconds(guard.limit))};
}

/// The call returned: checks that it has not written beyond its rows.
CallOutcome checked(const GuardedCall& guard, CallOutcome outcome) {
  const GuardedRows::Found found = guard.rows ? guard.rows->damaged() : GuardedRows::Found{};
  if (!found.row) return outcome;
  const CallEnd why{.kind = CallEnd::written_beyond, .row = found};
  announce(guard.name, guard.what, why);
  return crash(guard.name, guard.what, why);
}

/// sigsetjmp stands in a function of its own: after a jump the values of variables changed meanwhile are indeterminate.
CallOutcome jumped_back_or(const std::function<void()>& call, ForeignCall& running, CallWatch::Place& place) {
  const GuardedCall& guard = running.call;
  if (sigsetjmp(running.back, 0) != 0) {
    place.due = 0;
    return outcome_of(running);
  }
  running.enter();
  MUROSIMF_ASSERT(guard.limit > Duration{});
  place.due = running.began + guard.limit.count();
  CallOutcome outcome = without_exceptions(guard, call);
  place.due = 0;
  running.leave();
  return checked(guard, std::move(outcome));
}

}  // namespace

CallOutcome GuardedCall::operator()(const std::function<void()>& call) const noexcept {
  // once, at the first call of the process: handlers must be installed after those of sanitizers and debuggers
  static const bool handled = (know_children(), handle_crash_signals(), watch_functions(), true);
  (void)handled;
  thread_local ThreadGuard thread;
  ForeignCall running(*this);
  if (keeps_process) running.keep_process();
  CallOutcome outcome = jumped_back_or(call, running, thread.place);
  outcome.changes = running.put_back();
  return outcome;
}

}  // namespace murosimf::control_software
