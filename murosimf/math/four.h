/// four.h - four doubles side by side, for sums over short rows: each has the operations, and so the bits, of a `double`.
///
/// They are kept in registers of the target as packs are (pack.h), but in none of more than four.
#pragma once

#include <cstddef>

#include "murosimf/math/assert.h"

namespace murosimf {

class Four {
 public:
#if defined(__AVX__)
  static constexpr std::size_t width = 4;
#else
  static constexpr std::size_t width = 2;
#endif
  static constexpr std::size_t registers = 4 / width;
  using Register = double __attribute__((vector_size(width * sizeof(double))));

  Four() = default;
#if defined(__AVX__)
  Four(double a, double b, double c, double d) : part_{Register{a, b, c, d}} {}
#else
  Four(double a, double b, double c, double d) : part_{Register{a, b}, Register{c, d}} {}
#endif
  [[nodiscard]] double operator[](std::size_t i) const {
    MUROSIMF_ASSERT(i < 4);
    return part_[i / width][i % width];
  }

  friend Four operator+(const Four& a, const Four& b) {
    Four sum;
    for (std::size_t i = 0; i < registers; ++i) sum.part_[i] = a.part_[i] + b.part_[i];
    return sum;
  }
  friend Four operator-(const Four& a, const Four& b) {
    Four difference;
    for (std::size_t i = 0; i < registers; ++i) difference.part_[i] = a.part_[i] - b.part_[i];
    return difference;
  }
  friend Four operator*(const Four& a, double b) { return b * a; }
  friend Four operator*(double a, const Four& b) {
    Four product;
    for (std::size_t i = 0; i < registers; ++i) product.part_[i] = a * b.part_[i];
    return product;
  }

 private:
  alignas(32) Register part_[registers]{};
};

}  // namespace murosimf
