/// signal_stack.h - a stack for the signal handlers of this thread: its own one may be what has overflowed.
#pragma once

#include <csignal>
#include <cstddef>
#include <memory>

namespace murosimf::connect {

/// From its construction to its destruction, which must be in the same thread. Where somebody has given the thread a stack for
/// handlers already, that stays.
class SignalStack {
 public:
  SignalStack() {
    stack_t present{};
    if (sigaltstack(nullptr, &present) == 0 && (present.ss_flags & SS_DISABLE) == 0) return;  // somebody's
    memory_ = std::make_unique<char[]>(size);
    stack_t stack{};
    stack.ss_sp = memory_.get();
    stack.ss_size = size;
    sigaltstack(&stack, nullptr);
  }
  ~SignalStack() {
    if (!memory_) return;
    stack_t none{};
    none.ss_flags = SS_DISABLE;
    sigaltstack(&none, nullptr);
  }
  SignalStack(const SignalStack&) = delete;
  SignalStack& operator=(const SignalStack&) = delete;

 private:
  static constexpr std::size_t size = 64 * 1024;  // [byte]
  std::unique_ptr<char[]> memory_;
};

}  // namespace murosimf::connect
