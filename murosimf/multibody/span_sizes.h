/// span_sizes.h - whether a kernel's spans have as many rows as its tree, for assertions.
#pragma once

#include "murosimf/model/tree.h"

namespace murosimf::multibody {

template <class... Spans>
[[nodiscard]] bool one_row_per_object(const Tree& tree, const Spans&... spans) noexcept {
  return ((spans.size() == tree.link_of.size()) && ...);
}

template <class... Spans>
[[nodiscard]] bool one_row_per_link(const Tree& tree, const Spans&... spans) noexcept {
  return ((spans.size() == tree.links.size()) && ...);
}

}  // namespace murosimf::multibody
