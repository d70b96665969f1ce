/// assert.h - contracts: what a function relies on, checked in debug builds and in the sanitized builds of continuous integration.
///
///     MUROSIMF_ASSERT(q.size() == tree.links.size());
///     MUROSIMF_ASSERT(time >= now_ && "time does not run backwards");
///
/// An assertion that fails is an error of the library or of the program that uses it, never of a file or a user (these get a
/// SetupError): it prints the condition and its place, and aborts, so it may stand in noexcept functions. In release builds the
/// condition is compiled but not evaluated: it costs nothing, and names that only assertions use count as used.
/// -DMUROSIMF_ASSERTIONS=ON checks in release builds, too: for runs too long for a debug build.
#pragma once

namespace murosimf {

/// Whether assertions are checked: for what is too long for one condition, and for tests that a contract is kept.
#if !defined(NDEBUG) || defined(MUROSIMF_ASSERTIONS)
inline constexpr bool assertions_checked = true;
#define MUROSIMF_ASSERT(...) \
  (static_cast<bool>(__VA_ARGS__) ? void() : ::murosimf::assertion_failed(#__VA_ARGS__, __FILE__, __LINE__, __func__))
#else
inline constexpr bool assertions_checked = false;
#define MUROSIMF_ASSERT(...) static_cast<void>(sizeof(static_cast<bool>(__VA_ARGS__)))
#endif

/// Writes "FILE:LINE: FUNCTION: assertion 'CONDITION' failed" to the error output and aborts.
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line, const char* function) noexcept;

}  // namespace murosimf
