/// arrays.h - memory of the library as arrays of NumPy, and the other way round.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace murosimf::python {

namespace nb = nanobind;

/// Numbers that come in: one after the other. The package makes such arrays of what users give.
using Numbers = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
template <class Number>
using Array = nb::ndarray<nb::numpy, Number>;

[[nodiscard]] inline std::span<const double> span_of(const Numbers& numbers) {
  return {numbers.data(), numbers.size()};
}

/// Keeps a copy of `owner` as long as an array lives.
template <class Owner>
[[nodiscard]] nb::capsule keeping(Owner owner) {
  return {new Owner(std::move(owner)), [](void* kept) noexcept { delete static_cast<Owner*>(kept); }};
}

/// Memory of `owner`, which stays where it is.
template <class Number, class Owner>
[[nodiscard]] Array<Number> shown(Number* data, std::initializer_list<std::size_t> shape, Owner owner) {
  return Array<Number>(data, shape, keeping(std::move(owner)));
}

/// An array of its own.
template <class Number>
[[nodiscard]] Array<Number> array_of(std::vector<Number> numbers, std::initializer_list<std::size_t> shape) {
  Number* data = numbers.data();  // moving a vector does not move its memory
  return Array<Number>(data, shape, keeping(std::move(numbers)));
}
template <class Number>
[[nodiscard]] Array<Number> array_of(std::vector<Number> numbers) {
  const std::size_t size = numbers.size();
  return array_of(std::move(numbers), {size});
}

}  // namespace murosimf::python
