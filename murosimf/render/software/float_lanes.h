/// float_lanes.h - neighboring pixels of a row, each in its own lane of vector registers.
///
/// Every lane goes through the operations that a `float` alone would go through, and no value depends on which pixels are neighbors: pictures
/// have the same bits with registers of any width.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace murosimf::render::software {

// wider registers gain nothing: processors that have them take two turns for each, or have pixels to spare at the ends of triangles
#if defined(__AVX__)
inline constexpr int pixel_lanes = 8;
#else
inline constexpr int pixel_lanes = 4;
#endif

using Floats = float __attribute__((vector_size(pixel_lanes * 4)));
using Ints = std::int32_t __attribute__((vector_size(pixel_lanes * 4)));  ///< also masks: 0 or -1

[[nodiscard]] inline Floats all_lanes(float x) { return x - Floats{}; }  // a sum with zero would lose the sign of -0
[[nodiscard]] inline Ints all_lanes(std::int32_t x) { return x + Ints{}; }

/// 0, 1, 2, ...
[[nodiscard]] inline Floats lane_numbers() {
  Floats numbers{};
  for (int i = 0; i < pixel_lanes; ++i) numbers[i] = static_cast<float>(i);
  return numbers;
}

template <class Lanes, class Number>
[[nodiscard]] Lanes load_lanes(const Number* from) {
  static_assert(sizeof(Number) == 4);
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof(lanes));
  return lanes;
}
template <class Lanes, class Number>
void store_lanes(const Lanes& lanes, Number* to) {
  static_assert(sizeof(Number) == 4);
  std::memcpy(to, &lanes, sizeof(lanes));
}

[[nodiscard]] inline Floats choose(const Ints& mask, const Floats& yes, const Floats& no) { return mask ? yes : no; }
[[nodiscard]] inline Floats least(const Floats& a, const Floats& b) { return a < b ? a : b; }
[[nodiscard]] inline Floats greatest(const Floats& a, const Floats& b) { return a > b ? a : b; }
[[nodiscard]] inline Floats limited(const Floats& x, float low, float high) {
  return least(greatest(x, all_lanes(low)), all_lanes(high));
}
[[nodiscard]] inline Floats magnitude(const Floats& x) {
  return std::bit_cast<Floats>(std::bit_cast<Ints>(x) & all_lanes(0x7fffffff));
}
[[nodiscard]] inline Floats mixed(const Floats& a, const Floats& b, const Floats& t) { return a + (b - a) * t; }
[[nodiscard]] inline Ints whole_numbers(const Floats& x) { return __builtin_convertvector(x, Ints); }
[[nodiscard]] inline Floats floats_of(const Ints& x) { return __builtin_convertvector(x, Floats); }

/// The largest whole number that is not above x; |x| < 2^31.
[[nodiscard]] inline Floats floor_of(const Floats& x) {
#if defined(__AVX__)
  return std::bit_cast<Floats>(_mm256_floor_ps(std::bit_cast<__m256>(x)));
#elif defined(__SSE4_1__)
  return std::bit_cast<Floats>(_mm_floor_ps(std::bit_cast<__m128>(x)));
#endif
  const Floats cut = floats_of(whole_numbers(x));
  return cut - (cut > x ? all_lanes(1.0F) : Floats{});
}
[[nodiscard]] inline Floats fraction(const Floats& x) { return x - floor_of(x); }

[[nodiscard]] inline Floats root(const Floats& x) {
#if defined(__AVX__)
  return std::bit_cast<Floats>(_mm256_sqrt_ps(std::bit_cast<__m256>(x)));
#elif defined(__SSE2__)
  return std::bit_cast<Floats>(_mm_sqrt_ps(std::bit_cast<__m128>(x)));
#else
  Floats result = x;
  for (int i = 0; i < pixel_lanes; ++i) result[i] = std::sqrt(x[i]);
  return result;
#endif
}

/// One bit for each lane of a mask: bit i is lane i.
[[nodiscard]] inline unsigned bits_of(const Ints& mask) {
#if defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_ps(std::bit_cast<__m256>(mask)));
#elif defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_ps(std::bit_cast<__m128>(mask)));
#else
  unsigned bits = 0;
  for (int i = 0; i < pixel_lanes; ++i) bits |= mask[i] != 0 ? 1U << i : 0U;
  return bits;
#endif
}
[[nodiscard]] inline bool any(const Ints& mask) { return bits_of(mask) != 0; }
[[nodiscard]] inline bool all(const Ints& mask) { return bits_of(mask) == (1U << pixel_lanes) - 1; }

/// Three numbers of each pixel: a place, a direction or a color.
struct Floats3 {
  Floats x, y, z;
  friend Floats3 operator+(const Floats3& a, const Floats3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Floats3 operator-(const Floats3& a, const Floats3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Floats3 operator*(const Floats3& a, const Floats& s) { return {a.x * s, a.y * s, a.z * s}; }
  friend Floats3 operator*(const Floats3& a, const Floats3& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
  friend Floats dot(const Floats3& a, const Floats3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend Floats3 mixed(const Floats3& a, const Floats3& b, const Floats& t) {
    return {mixed(a.x, b.x, t), mixed(a.y, b.y, t), mixed(a.z, b.z, t)};
  }
  friend Floats3 choose(const Ints& mask, const Floats3& yes, const Floats3& no) {
    return {choose(mask, yes.x, no.x), choose(mask, yes.y, no.y), choose(mask, yes.z, no.z)};
  }
};

/// Three numbers that all pixels share.
struct Float3 {
  float x = 0, y = 0, z = 0;
};
[[nodiscard]] inline Floats3 all_lanes(const Float3& v) { return {all_lanes(v.x), all_lanes(v.y), all_lanes(v.z)}; }
[[nodiscard]] inline Floats dot(const Floats3& a, const Float3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

}  // namespace murosimf::render::software
