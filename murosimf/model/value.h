/// value.h - the value of a property as a row of numbers, for interfaces, and in the state hash.
///
/// Specialise ValueTraits for a new value type: numeric types derive from `OfDoubles`; a type that is no row of
/// numbers keeps `numbers = 0` and offers `void append_hash(Hasher&, const T&)` in its namespace.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>

#include "murosimf/math/hash.h"
#include "murosimf/math/quaternion.h"
#include "murosimf/math/spatial.h"

namespace murosimf {

/// Layout of the numbers of one value in memory: number (i, j), row by row as users see them, is at first + i strides[0] + j
/// strides[1], all in doubles. A value with one index has shape[1] = 1.
struct ValueLayout {
  std::array<std::size_t, 2> shape{1, 1};
  std::array<std::ptrdiff_t, 2> strides{0, 0};
  std::ptrdiff_t first = 0;
};

template <class T>
struct ValueTraits {
  static constexpr std::size_t numbers = 0;
};

/// For types that consist of doubles and nothing else.
template <class T>
struct OfDoubles {
  static_assert(sizeof(T) % sizeof(double) == 0);
  static constexpr std::size_t numbers = sizeof(T) / sizeof(double);
  static constexpr ValueLayout layout{{numbers, 1}, {1, 0}, 0};

  static double get(const T& value, std::size_t i) {
    double number = 0;
    // by memcpy: reading members through a pointer to the first one would be undefined
    std::memcpy(&number, reinterpret_cast<const unsigned char*>(&value) + i * sizeof(double), sizeof(double));
    return number;
  }
  static void set(T& value, std::size_t i, double number) {
    std::memcpy(reinterpret_cast<unsigned char*>(&value) + i * sizeof(double), &number, sizeof(double));
  }
};

// clang-format off
template <> struct ValueTraits<double>      : OfDoubles<double> {};
template <> struct ValueTraits<Vec3d>       : OfDoubles<Vec3d> {};
template <> struct ValueTraits<Quaterniond> : OfDoubles<Quaterniond> {};  ///< w, x, y, z
template <> struct ValueTraits<Twistd>     : OfDoubles<Twistd> {};      ///< w, v
template <> struct ValueTraits<SymMat3d>    : OfDoubles<SymMat3d> {};     ///< xx, yy, zz, xy, xz, yz
template <> struct ValueTraits<Sym6d>       : OfDoubles<Sym6d> {};        ///< J, H by columns, M
// clang-format on

/// Users write and read the force first, then the moment, as in MuJoCo; in memory it is n, f.
template <>
struct ValueTraits<Wrenchd> : OfDoubles<Wrenchd> {
  static constexpr ValueLayout layout{{2, 3}, {-3, 1}, 3};
  static double get(const Wrenchd& force, std::size_t i) { return OfDoubles::get(force, (i + 3) % 6); }
  static void set(Wrenchd& force, std::size_t i, double number) { OfDoubles::set(force, (i + 3) % 6, number); }
};

/// Rotations are shown row by row, as users write them.
template <>
struct ValueTraits<Mat3d> : OfDoubles<Mat3d> {
  static constexpr ValueLayout layout{{3, 3}, {1, 3}, 0};
  static double get(const Mat3d& m, std::size_t i) { return OfDoubles::get(m, 3 * (i % 3) + i / 3); }
  static void set(Mat3d& m, std::size_t i, double number) { OfDoubles::set(m, 3 * (i % 3) + i / 3, number); }
};

template <class T>
concept NumericValue = (ValueTraits<T>::numbers > 0);

template <NumericValue T>
void append_hash(Hasher& hasher, const T& value) {
  for (std::size_t i = 0; i < ValueTraits<T>::numbers; ++i) hasher.add(ValueTraits<T>::get(value, i));
}

/// In the order in memory, unlike the order that users see: recorded hashes depend on it.
inline void append_hash(Hasher& hasher, const Wrenchd& force) {
  for (std::size_t i = 0; i < 6; ++i) hasher.add(OfDoubles<Wrenchd>::get(force, i));
}

}  // namespace murosimf
