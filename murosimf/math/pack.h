/// pack.h - eight doubles that behave like one number, so that eight equal robots step through one kernel.
///
/// The lanes are kept in the widest vector registers that the target has (one of 64 bytes with AVX-512, two of 32
/// with AVX, four of 16 otherwise), because g++ makes poor code of vectors wider than a register. Every lane goes
/// through the same operations as a `double` would: a lane equals the scalar bit for bit if the kernel is compiled
/// with -ffp-contract=off.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "murosimf/math/assert.h"
#include "murosimf/math/scalar.h"

namespace murosimf {

#if defined(__AVX512F__)
inline constexpr int register_lanes = 8;
#elif defined(__AVX__)
inline constexpr int register_lanes = 4;
#else
inline constexpr int register_lanes = 2;
#endif

class Pack8 {
 public:
  static constexpr int lanes = 8;
  static constexpr int registers = lanes / register_lanes;
  using Register = double __attribute__((vector_size(register_lanes * sizeof(double))));
  using MaskRegister = std::int64_t __attribute__((vector_size(register_lanes * sizeof(double))));

  struct Mask {
    MaskRegister part[registers];
    friend Mask operator|(Mask a, const Mask& b) {
      for (int i = 0; i < registers; ++i) a.part[i] |= b.part[i];
      return a;
    }
    friend Mask operator&(Mask a, const Mask& b) {
      for (int i = 0; i < registers; ++i) a.part[i] &= b.part[i];
      return a;
    }
  };

  Pack8() = default;
  /// The same number in every lane.
  Pack8(double number) {  // NOLINT(google-explicit-constructor): constants of a model mix with packs
    for (auto& p : part_) p = number - Register{};  // a sum with zero would lose the sign of -0
  }

  [[nodiscard]] double lane(int i) const {
    MUROSIMF_ASSERT(i >= 0 && i < lanes);
    return part_[i / register_lanes][i % register_lanes];
  }
  void set_lane(int i, double number) {
    MUROSIMF_ASSERT(i >= 0 && i < lanes);
    part_[i / register_lanes][i % register_lanes] = number;
  }
  /// The lanes of one register.
  [[nodiscard]] const Register& part(int i) const { return part_[i]; }
  [[nodiscard]] Register& part(int i) { return part_[i]; }

  friend Pack8 operator+(const Pack8& a, const Pack8& b) {
    return each<Pack8>([&](int i) { return a.part_[i] + b.part_[i]; });
  }
  friend Pack8 operator-(const Pack8& a, const Pack8& b) {
    return each<Pack8>([&](int i) { return a.part_[i] - b.part_[i]; });
  }
  friend Pack8 operator*(const Pack8& a, const Pack8& b) {
    return each<Pack8>([&](int i) { return a.part_[i] * b.part_[i]; });
  }
  friend Pack8 operator/(const Pack8& a, const Pack8& b) {
    return each<Pack8>([&](int i) { return a.part_[i] / b.part_[i]; });
  }
  friend Pack8 operator-(const Pack8& a) {
    return each<Pack8>([&](int i) { return -a.part_[i]; });
  }
  friend Mask operator<(const Pack8& a, const Pack8& b) {
    return each<Mask>([&](int i) { return MaskRegister(a.part_[i] < b.part_[i]); });
  }
  friend Mask operator>(const Pack8& a, const Pack8& b) { return b < a; }
  friend Mask operator==(const Pack8& a, const Pack8& b) {
    return each<Mask>([&](int i) { return MaskRegister(a.part_[i] == b.part_[i]); });
  }
  friend Pack8 select(const Mask& mask, const Pack8& yes, const Pack8& no) {
    return each<Pack8>([&](int i) { return mask.part[i] ? yes.part_[i] : no.part_[i]; });
  }
  friend bool any(const Mask& mask) {
    MaskRegister merged = mask.part[0];
    for (int i = 1; i < registers; ++i) merged |= mask.part[i];
    return bits_of(merged) != 0;
  }
  friend bool all(const Mask& mask) {
    MaskRegister merged = mask.part[0];
    for (int i = 1; i < registers; ++i) merged &= mask.part[i];
    return bits_of(merged) == (1U << register_lanes) - 1;
  }
  /// The lanes of a mask, one bit each: bit i is lane i.
  friend std::uint32_t lane_bits(const Mask& mask) {
    std::uint32_t bits = 0;
    for (int i = 0; i < registers; ++i) bits |= bits_of(mask.part[i]) << (i * register_lanes);
    return bits;
  }
  friend Pack8 sqrt(const Pack8& a) {
    return each<Pack8>([&](int i) {
      Register root;
      for (int k = 0; k < register_lanes; ++k) root[k] = std::sqrt(a.part_[i][k]);
      return root;
    });
  }
  friend Pack8 abs(const Pack8& a) {
    return each<Pack8>([&](int i) {
      const MaskRegister magnitude = MaskRegister{} + std::int64_t{0x7fffffffffffffff};
      return reinterpret_cast<Register>(reinterpret_cast<MaskRegister>(a.part_[i]) & magnitude);
    });
  }
  friend Pack8 binary_exponent(const Pack8& a) {
    return each<Pack8>([&](int i) {
      const MaskRegister shifted =
          (reinterpret_cast<MaskRegister>(a.part_[i]) >> 52) | (MaskRegister{} + two_to_52_bits);
      return reinterpret_cast<Register>(shifted) - exponent_bias;
    });
  }
  friend Pack8 binary_fraction(const Pack8& a) {
    return each<Pack8>([&](int i) {
      const MaskRegister fraction = reinterpret_cast<MaskRegister>(a.part_[i]) & (MaskRegister{} + fraction_mask);
      return reinterpret_cast<Register>(fraction | (MaskRegister{} + one_bits));
    });
  }
  friend Pack8 times_power_of_two(const Pack8& a, const Pack8& n) {
    return each<Pack8>([&](int i) {
      const Register biased = n.part_[i] + round_bias;
      return reinterpret_cast<Register>(reinterpret_cast<MaskRegister>(a.part_[i]) +
                                        (reinterpret_cast<MaskRegister>(biased) << 52));
    });
  }

 private:
  /// The lanes of one register, of numbers that are 0 or -1. By built-in functions: g++ takes the lanes out one by one where an instruction
  /// does all of them, and the header of the instructions has pragmas that a precompiled header does not bear.
  [[nodiscard]] static std::uint32_t bits_of(const MaskRegister& mask) {
#if defined(__AVX512F__) && !defined(__clang__)
    using Eight = long long __attribute__((vector_size(8 * sizeof(long long))));  // NOLINT(google-runtime-int)
    return __builtin_ia32_ptestmq512(reinterpret_cast<Eight>(mask), reinterpret_cast<Eight>(mask), 0xff);
#elif defined(__AVX__)
    using Four = double __attribute__((vector_size(4 * sizeof(double))));
    const auto numbers = reinterpret_cast<Register>(mask);
    const auto bits = [](const Four& four) { return static_cast<std::uint32_t>(__builtin_ia32_movmskpd256(four)); };
    constexpr int high = register_lanes - 4;  // 0: the same ones again
    return bits(__builtin_shufflevector(numbers, numbers, 0, 1, 2, 3)) |
           bits(__builtin_shufflevector(numbers, numbers, high, high + 1, high + 2, high + 3)) << high;
#else
    return static_cast<std::uint32_t>((mask[0] & 1) | (mask[1] & 2));
#endif
  }

  template <class Result, class F>
  static Result each(const F& f) {
    Result result;
    for (int i = 0; i < registers; ++i) {
      if constexpr (std::is_same_v<Result, Mask>) {
        result.part[i] = f(i);
      } else {
        result.part_[i] = f(i);
      }
    }
    return result;
  }

  alignas(64) Register part_[registers]{};
};

}  // namespace murosimf
