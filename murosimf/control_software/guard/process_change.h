/// process_change.h - state of the whole process or thread that control software must not change: changes made by a call
/// are undone and counted.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace murosimf::control_software {

enum class ProcessChange : std::uint8_t {
  rounding,
  tiny_numbers,
  traps,
  locale,
  directory,
  file_mask,
  handlers,
  signal_mask,
  signal_stack,
  timers,
  environment,
  standard_files,
  terminate_handler,
};

inline constexpr std::array<std::string_view, 13> process_change_names{
    "the rounding mode",
    "what becomes of tiny numbers",
    "floating-point traps",
    "the locale",
    "the working directory",
    "the umask",
    "signal handlers",
    "the signal mask",
    "the stack of signal handlers",
    "a timer of the process",
    "the environment",
    "standard input, output or errors",
    "the terminate handler",
};

/// Several of them.
class ProcessChanges {
 public:
  void add(ProcessChange change) { bits_ |= 1U << static_cast<unsigned>(change); }
  void add_if(bool changed, ProcessChange change) {
    if (changed) add(change);
  }
  void add(ProcessChanges others) { bits_ |= others.bits_; }
  [[nodiscard]] bool has(ProcessChange change) const { return (bits_ >> static_cast<unsigned>(change) & 1U) != 0; }
  [[nodiscard]] bool empty() const { return bits_ == 0; }

 private:
  std::uint32_t bits_ = 0;
};

}  // namespace murosimf::control_software
