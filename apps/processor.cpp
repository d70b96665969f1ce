#include "apps/processor.h"

#include <algorithm>
#include <array>

namespace murosimf::app {
namespace {

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512BW__) && defined(__AVX512VL__)
constexpr bool uses_avx512 = true;
#else
constexpr bool uses_avx512 = false;
#endif
#if defined(__AVX__)
constexpr bool uses_avx = true;
#else
constexpr bool uses_avx = false;
#endif
#if defined(__AVX2__) && defined(__FMA__)
constexpr bool uses_avx2 = true;
#else
constexpr bool uses_avx2 = false;
#endif

}  // namespace

std::span<const InstructionSet> instruction_sets() noexcept {
#if defined(__x86_64__)
  static const std::array sets{
      InstructionSet{"AVX", uses_avx, __builtin_cpu_supports("avx") != 0},
      InstructionSet{"AVX2", uses_avx2, __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0},
      InstructionSet{"AVX-512", uses_avx512,
                     __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
                         __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512vl") != 0}};
  return sets;
#else
  return {};
#endif
}

const char* missing_instructions(std::span<const InstructionSet> sets) noexcept {
  const auto missing = std::ranges::find_if(sets, [](const InstructionSet& s) { return s.is_used && !s.is_there; });
  return missing == sets.end() ? nullptr : missing->name;
}

}  // namespace murosimf::app
