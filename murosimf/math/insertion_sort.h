/// insertion_sort.h - puts a few things in order: stable, and the fastest way for up to about sixteen.
///
/// std::sort has a second half for more than sixteen elements. It is never reached where these are at most eight, but g++ 14
/// looks at it and warns of an access beyond the array.
#pragma once

#include <functional>
#include <utility>

namespace murosimf {

template <class Iterator, class Less = std::less<>>
constexpr void insertion_sort(Iterator begin, Iterator end, Less less = {}) {
  if (begin == end) return;
  for (Iterator next = begin + 1; next != end; ++next) {
    auto value = std::move(*next);
    Iterator place = next;
    for (; place != begin && less(value, *(place - 1)); --place) *place = std::move(*(place - 1));
    *place = std::move(value);
  }
}

}  // namespace murosimf
