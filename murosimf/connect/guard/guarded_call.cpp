#include "murosimf/connect/guard/guarded_call.h"

#include <fmt/format.h>

#include "murosimf/connect/guard/call_watch.h"
#include "murosimf/connect/guard/crash_signals.h"
#include "murosimf/connect/guard/foreign_call.h"
#include "murosimf/connect/guard/signal_stack.h"
#include "murosimf/connect/guard/watched_functions.h"

namespace murosimf::connect {
namespace {

/// What a thread needs for its calls.
struct ThreadGuard {
  ThreadGuard() : place(CallWatch::the_one().take()) {}
  ~ThreadGuard() { CallWatch::the_one().give_back(place); }
  ThreadGuard(const ThreadGuard&) = delete;
  ThreadGuard& operator=(const ThreadGuard&) = delete;

  SignalStack stack;
  CallWatch::Place& place;
};

CallOutcome without_exceptions(const GuardedCall& guard, const std::function<void()>& call) {
  try {
    call();
    return {};
  } catch (const std::exception& error) {
    return {CallOutcome::threw, fmt::format("{}: {} threw: {}", guard.who, guard.what, error.what())};
  } catch (...) {
    return {CallOutcome::threw, fmt::format("{}: {} threw something that is no std::exception", guard.who, guard.what)};
  }
}

CallOutcome crash(const std::string& who, const std::string& what, const CallEnd& why) {
  CallOutcome outcome{CallOutcome::crashed, fmt::format("{}: {} ", who, what)};
  why.say([&](const char* piece) { outcome.text += piece; });
  return outcome;
}

}  // namespace

CallOutcome outcome_of(const ForeignThreads& threads) { return crash(threads.who, "a thread of its own", threads.why); }

namespace {

CallOutcome outcome_of(const ForeignCall& ended) {
  const GuardedCall& guard = ended.call;
  if (ended.why.kind != CallEnd::late) return crash(guard.who, guard.what, ended.why);
  if (guard.threads && guard.threads->ended) return outcome_of(*guard.threads);  // it waited for them
  return {CallOutcome::late,
          fmt::format("{}: {} did not come back within {:g} s", guard.who, guard.what, seconds(guard.limit))};
}

/// It came back; but to what?
CallOutcome checked(const GuardedCall& guard, CallOutcome outcome) {
  const GuardedRows::Found found = guard.rows ? guard.rows->damaged() : GuardedRows::Found{};
  if (!found.row) return outcome;
  const CallEnd why{.kind = CallEnd::written_beyond, .row = found};
  announce(guard.who, guard.what, why);
  return crash(guard.who, guard.what, why);
}

/// With the jump back in a function that does nothing else: of variables that change meanwhile a jump may forget the values.
CallOutcome jumped_back_or(const std::function<void()>& call, ForeignCall& running, CallWatch::Place& place) {
  const GuardedCall& guard = running.call;
  if (sigsetjmp(running.back, 0) != 0) {
    place.due = 0;
    return outcome_of(running);
  }
  running.enter();
  place.due = running.began + guard.limit.count();
  CallOutcome outcome = without_exceptions(guard, call);
  place.due = 0;
  running.leave();
  return checked(guard, std::move(outcome));
}

}  // namespace

CallOutcome GuardedCall::operator()(const std::function<void()>& call) const noexcept {
  static const bool handled = (know_children(), handle_crash_signals(), watch_functions(), true);
  (void)handled;
  thread_local ThreadGuard thread;
  ForeignCall running(*this);
  if (keeps_process) running.keep_process();
  CallOutcome outcome = jumped_back_or(call, running, thread.place);
  outcome.changes = running.put_back();
  return outcome;
}

}  // namespace murosimf::connect
