/// processor.h - whether this processor has the instructions that the program was compiled for (MUROSIMF_NATIVE).
#pragma once

#include <span>

namespace murosimf::app {

/// A set of instructions.
struct InstructionSet {
  const char* name;
  bool is_used;   ///< by the program
  bool is_there;  ///< in this processor
};

/// Of this program on this processor.
[[nodiscard]] std::span<const InstructionSet> instruction_sets() noexcept;

/// The name of the first set that the program uses and the processor lacks; null if there is none.
[[nodiscard]] const char* missing_instructions(std::span<const InstructionSet> sets) noexcept;

}  // namespace murosimf::app
