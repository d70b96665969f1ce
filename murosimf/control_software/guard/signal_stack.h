/// signal_stack.h - a separate stack for the signal handlers of this thread: its ordinary stack may be the one that overflowed.
#pragma once

#include <csignal>
#include <cstddef>
#include <memory>

namespace murosimf::control_software {

/// From its construction to its destruction, which must be in the same thread. A stack for handlers that the thread already has
/// is kept.
class SignalStack {
 public:
  SignalStack() {
    stack_t present{};
    if (sigaltstack(nullptr, &present) == 0 && (present.ss_flags & SS_DISABLE) == 0) return;  // already set
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

}  // namespace murosimf::control_software
