/// floating_point.h - how this thread's processor rounds: direction, tiny numbers as zero, traps, x87 precision.
///
/// Code that is not ours may change it, and then the same simulation gives other bits. So everything that steps runs with the modes
/// that a program begins with (StandardFloatingPoint), whatever its caller has, and calls of others' code put back what they found.
/// Flags of what has happened (inexact, overflow) are no modes, and stay as they are.
#pragma once

#include <cfenv>
#include <cstdint>

namespace murosimf {

/// Two numbers on x86-64 and one on AArch64: a few nanoseconds to look and to compare.
struct FloatingPointModes {
#if defined(__x86_64__)
  std::uint32_t sse = 0x1f80;  ///< MXCSR without its flags
  std::uint16_t x87 = 0x037f;  ///< control word

  [[nodiscard]] static FloatingPointModes now() noexcept {
    FloatingPointModes modes;
    modes.sse = __builtin_ia32_stmxcsr() & ~flags;
    __asm__ volatile("fnstcw %0" : "=m"(modes.x87));
    return modes;
  }
  void set() const noexcept {
    __builtin_ia32_ldmxcsr(sse | (__builtin_ia32_stmxcsr() & flags));
    // without what has happened meanwhile: the next instruction would raise it where the mode traps
    __asm__ volatile("fnclex\n\tfldcw %0" : : "m"(x87));
  }
  [[nodiscard]] bool rounds_like(const FloatingPointModes& other) const noexcept {
    return (sse & 0x6000U) == (other.sse & 0x6000U) && (x87 & 0x0f00U) == (other.x87 & 0x0f00U);
  }
  [[nodiscard]] bool traps_like(const FloatingPointModes& other) const noexcept {
    return (sse & 0x1f80U) == (other.sse & 0x1f80U) && (x87 & 0x003fU) == (other.x87 & 0x003fU);
  }
#elif defined(__aarch64__)
  std::uint64_t control = 0;  ///< FPCR

  [[nodiscard]] static FloatingPointModes now() noexcept {
    FloatingPointModes modes;
    __asm__ volatile("mrs %0, fpcr" : "=r"(modes.control));
    return modes;
  }
  void set() const noexcept { __asm__ volatile("msr fpcr, %0" : : "r"(control)); }
  [[nodiscard]] bool rounds_like(const FloatingPointModes& other) const noexcept {
    return (control & 0xc00000U) == (other.control & 0xc00000U);
  }
  [[nodiscard]] bool traps_like(const FloatingPointModes& other) const noexcept {
    return (control & 0x9f00U) == (other.control & 0x9f00U);
  }
#else
  int direction = FE_TONEAREST;

  [[nodiscard]] static FloatingPointModes now() noexcept { return {std::fegetround()}; }
  void set() const noexcept { (void)std::fesetround(direction); }
  [[nodiscard]] bool rounds_like(const FloatingPointModes& other) const noexcept {
    return direction == other.direction;
  }
  [[nodiscard]] bool traps_like(const FloatingPointModes&) const noexcept { return true; }
#endif

  friend bool operator==(const FloatingPointModes&, const FloatingPointModes&) = default;

 private:
#if defined(__x86_64__)
  static constexpr std::uint32_t flags = 0x3f;
#endif
};

/// Puts back what was there when it was made.
class KeptFloatingPoint {
 public:
  KeptFloatingPoint() noexcept : before_(FloatingPointModes::now()) {}
  ~KeptFloatingPoint() {
    if (FloatingPointModes::now() != before_) before_.set();
  }
  KeptFloatingPoint(const KeptFloatingPoint&) = delete;
  KeptFloatingPoint& operator=(const KeptFloatingPoint&) = delete;

 private:
  FloatingPointModes before_;
};

/// The modes that programs begin with, as long as it exists.
class StandardFloatingPoint : public KeptFloatingPoint {
 public:
  StandardFloatingPoint() noexcept { again(); }
  /// After others' code.
  void again() const noexcept {
    if (FloatingPointModes::now() != FloatingPointModes{}) FloatingPointModes{}.set();
  }
};

}  // namespace murosimf
