/// hash.h - a 64-bit hash of state, for "the same scene and seed give the same state, bit for bit".
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

namespace murosimf {

/// Order-sensitive; not for security. Mixing step: splitmix64 (Steele, Lea, Flood, OOPSLA 2014).
class Hasher {
 public:
  void add(std::uint64_t word) noexcept {
    state_ = (state_ ^ word) + 0x9E3779B97F4A7C15u;
    state_ = (state_ ^ (state_ >> 30)) * 0xBF58476D1CE4E5B9u;
    state_ = (state_ ^ (state_ >> 27)) * 0x94D049BB133111EBu;
    state_ ^= state_ >> 31;
  }
  /// By its bits, but all that are no number are one: which of them an operation gives is the compiler's choice.
  void add(double number) noexcept {
    const double known = number == number ? number : std::numeric_limits<double>::quiet_NaN();
    add(std::bit_cast<std::uint64_t>(known));
  }
  void add(std::string_view text) noexcept {
    add(static_cast<std::uint64_t>(text.size()));
    for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  }
  [[nodiscard]] std::uint64_t value() const noexcept { return state_; }

 private:
  std::uint64_t state_ = 0;
};

}  // namespace murosimf
