/// sanitizer.h - what a test does less of where sanitizers make everything several times slower.
#pragma once

namespace murosimf::fixtures {

#ifdef MUROSIMF_ADDRESS_SANITIZER
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

/// How many of `count` random tries are made: a quarter with the sanitizer, which finds an error of memory at the first try that has it.
constexpr int tries(int count) { return sanitized ? count / 4 : count; }

}  // namespace murosimf::fixtures
