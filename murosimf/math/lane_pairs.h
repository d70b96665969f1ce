/// lane_pairs.h - the same numbers of several rows into registers and back, two neighbors of a row at a time.
///
/// A pair of numbers is the least that a register moves at once: by pairs, a transposition takes little more than one instruction for
/// each number, one after the other it takes two.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>

#include "murosimf/math/inline.h"
#include "murosimf/math/pack.h"

namespace murosimf::lane_pairs {

using Register = Pack8::Register;
using Pair = double __attribute__((vector_size(2 * sizeof(double))));

/// Of as many things as a register has lanes.
template <class Number>
using Rows = std::array<Number*, register_lanes>;

[[nodiscard]] MUROSIMF_INLINE Pair pair_at(const double* numbers) {
  Pair pair;
  std::memcpy(&pair, numbers, sizeof(pair));
  return pair;
}

/// Pair number i of a register.
template <int i>
MUROSIMF_INLINE void store(const Register& from, double* numbers) {
  const Pair pair = __builtin_shufflevector(from, from, 2 * i, 2 * i + 1);
  std::memcpy(numbers, &pair, sizeof(pair));
}

/// The pairs at `at` of every second row, beginning with the row `first`: 0 or 1.
[[nodiscard]] MUROSIMF_INLINE Register load(const Rows<const double>& rows, std::size_t first, std::size_t at) {
  const auto pair = [&](std::size_t i) { return pair_at(rows[first + 2 * i] + at); };
#if defined(__AVX512F__)
  const auto low = __builtin_shufflevector(pair(0), pair(1), 0, 1, 2, 3);
  const auto high = __builtin_shufflevector(pair(2), pair(3), 0, 1, 2, 3);
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#elif defined(__AVX__)
  return __builtin_shufflevector(pair(0), pair(1), 0, 1, 2, 3);
#else
  return pair(0);
#endif
}

/// The numbers at even places of a and b, by turns: a0 b0 a2 b2 ...
[[nodiscard]] MUROSIMF_INLINE Register even_places(const Register& a, const Register& b) {
#if defined(__AVX512F__)
  return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
#elif defined(__AVX__)
  return __builtin_shufflevector(a, b, 0, 4, 2, 6);
#else
  return __builtin_shufflevector(a, b, 0, 2);
#endif
}

/// Those at odd places: a1 b1 a3 b3 ...
[[nodiscard]] MUROSIMF_INLINE Register odd_places(const Register& a, const Register& b) {
#if defined(__AVX512F__)
  return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
#elif defined(__AVX__)
  return __builtin_shufflevector(a, b, 1, 5, 3, 7);
#else
  return __builtin_shufflevector(a, b, 1, 3);
#endif
}

/// x gets the numbers at `at` of all rows, y those behind them.
MUROSIMF_INLINE void gather_two(const Rows<const double>& from, std::size_t at, Register& x, Register& y) {
  const Register even = load(from, 0, at), odd = load(from, 1, at);
  x = even_places(even, odd);
  y = odd_places(even, odd);
}

/// And back.
MUROSIMF_INLINE void scatter_two(const Register& x, const Register& y, const Rows<double>& to, std::size_t at) {
  const Register even = even_places(x, y), odd = odd_places(x, y);
  store<0>(even, to[0] + at);
  store<0>(odd, to[1] + at);
  if constexpr (register_lanes >= 4) {
    store<1>(even, to[2] + at);
    store<1>(odd, to[3] + at);
  }
  if constexpr (register_lanes >= 8) {
    store<2>(even, to[4] + at);
    store<2>(odd, to[5] + at);
    store<3>(even, to[6] + at);
    store<3>(odd, to[7] + at);
  }
}

/// The number at `at` of all rows.
MUROSIMF_INLINE void gather_one(const Rows<const double>& from, std::size_t at, Register& x) {
  Register numbers{};
  for (std::size_t lane = 0; lane < from.size(); ++lane) numbers[lane] = from[lane][at];
  x = numbers;
}

MUROSIMF_INLINE void scatter_one(const Register& x, const Rows<double>& to, std::size_t at) {
  const Register numbers = x;
  for (std::size_t lane = 0; lane < to.size(); ++lane) to[lane][at] = numbers[lane];
}

}  // namespace murosimf::lane_pairs
