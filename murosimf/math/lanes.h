/// lanes.h - the numbers of up to eight equal things, each in its own lane of packs, and back again.
///
/// Numbers of one thing stand in a row of doubles; the same numbers of eight things are a row of packs of the same length. A
/// structure `T<S>` of nothing but numbers is such a row: `T<double>` has as many doubles as `T<Pack8>` has packs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "murosimf/math/assert.h"
#include "murosimf/math/lane_pairs.h"

namespace murosimf {

/// Lanes of a pack, one bit each: bit i is lane i.
using LaneMask = std::uint32_t;

[[nodiscard]] constexpr bool has_lane(LaneMask mask, int lane) { return (mask >> lane & 1U) != 0; }
[[nodiscard]] constexpr LaneMask lane_bit(int lane) { return LaneMask{1} << lane; }

/// Calls visit(lane) for each lane of the mask, in their order.
template <class Visit>
void for_lanes(LaneMask mask, const Visit& visit) {
  for (int lane = 0; lane < Pack8::lanes; ++lane) {
    if (has_lane(mask, lane)) visit(lane);
  }
}

/// The lanes of the mask, for select().
[[nodiscard]] inline Pack8::Mask where(LaneMask mask) {
  using Bits = Pack8::MaskRegister;
  Pack8::Mask result;
  for (int part = 0; part < Pack8::registers; ++part) {
    Bits bits{};
    for (int i = 0; i < register_lanes; ++i) bits[i] = lane_bit(part * register_lanes + i);
    result.part[part] = (bits & (Bits{} + std::int64_t{mask})) == bits;
  }
  return result;
}

/// And back.
[[nodiscard]] inline LaneMask lanes_of(const Pack8::Mask& mask) { return lane_bits(mask); }

/// The same row of numbers of each thing, by lane.
template <class Number>
using LaneRows = std::array<Number*, Pack8::lanes>;

/// Of the lanes of one register of packs.
template <class Number>
[[nodiscard]] MUROSIMF_INLINE lane_pairs::Rows<Number> rows_of_part(const LaneRows<Number>& rows, int part) {
  lane_pairs::Rows<Number> result;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = rows[static_cast<std::size_t>(part) * result.size() + i];
  return result;
}

/// The rows with these numbers, each of one T, into packs: to(k) gets that with the number rows[k], where T is the structure of packs
/// that to(k) refers to.
template <class To>
MUROSIMF_INLINE void gather(const LaneRows<const double>& from, std::span<const std::size_t> rows, const To& to) {
  constexpr std::size_t numbers = sizeof(to(0)) / sizeof(Pack8);
  for (int part = 0; part < Pack8::registers; ++part) {
    const auto sources = rows_of_part(from, part);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      auto* packs = reinterpret_cast<Pack8*>(&to(k));
      const std::size_t first = numbers * rows[k];
      for (std::size_t n = 0; n + 1 < numbers; n += 2)
        lane_pairs::gather_two(sources, first + n, packs[n].part(part), packs[n + 1].part(part));
      if constexpr (numbers % 2 == 1)
        lane_pairs::gather_one(sources, first + numbers - 1, packs[numbers - 1].part(part));
    }
  }
}

/// And back.
template <class From>
MUROSIMF_INLINE void scatter(const From& from, std::span<const std::size_t> rows, const LaneRows<double>& to) {
  constexpr std::size_t numbers = sizeof(from(0)) / sizeof(Pack8);
  for (int part = 0; part < Pack8::registers; ++part) {
    const auto targets = rows_of_part(to, part);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const auto* packs = reinterpret_cast<const Pack8*>(&from(k));
      const std::size_t first = numbers * rows[k];
      for (std::size_t n = 0; n + 1 < numbers; n += 2)
        lane_pairs::scatter_two(packs[n].part(part), packs[n + 1].part(part), targets, first + n);
      if constexpr (numbers % 2 == 1)
        lane_pairs::scatter_one(packs[numbers - 1].part(part), targets, first + numbers - 1);
    }
  }
}

template <template <class> class T>
inline constexpr std::size_t numbers_of = sizeof(T<double>) / sizeof(double);

/// One lane of a structure of numbers.
template <template <class> class T>
void set_lane(T<Pack8>& to, int lane, const T<double>& from) {
  MUROSIMF_ASSERT(lane >= 0 && lane < Pack8::lanes);
  static_assert(sizeof(T<Pack8>) == numbers_of<T> * sizeof(Pack8), "nothing but numbers");
  auto* packs = reinterpret_cast<double*>(&to) + lane;
  const auto* numbers = reinterpret_cast<const double*>(&from);
  for (std::size_t k = 0; k < numbers_of<T>; ++k) packs[k * Pack8::lanes] = numbers[k];
}

/// `to` gets these lanes of `from`, number by number.
template <template <class> class T>
void assign_where(const Pack8::Mask& mask, const T<Pack8>& from, T<Pack8>& to) {
  static_assert(sizeof(T<Pack8>) == numbers_of<T> * sizeof(Pack8), "nothing but numbers");
  const auto* source = reinterpret_cast<const Pack8*>(&from);
  auto* packs = reinterpret_cast<Pack8*>(&to);
  for (std::size_t k = 0; k < numbers_of<T>; ++k) packs[k] = select(mask, source[k], packs[k]);
}

template <template <class> class T>
[[nodiscard]] T<double> lane_of(const T<Pack8>& from, int lane) {
  MUROSIMF_ASSERT(lane >= 0 && lane < Pack8::lanes);
  static_assert(sizeof(T<Pack8>) == numbers_of<T> * sizeof(Pack8), "nothing but numbers");
  T<double> result;
  const auto* packs = reinterpret_cast<const double*>(&from) + lane;
  auto* numbers = reinterpret_cast<double*>(&result);
  for (std::size_t k = 0; k < numbers_of<T>; ++k) numbers[k] = packs[k * Pack8::lanes];
  return result;
}

}  // namespace murosimf
