/// ridge_contact.h - edges and corners of uneven ground inside of boxes, cylinders, ellipsoids and polyhedra.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "murosimf/collision/relief/relief_contact.h"

namespace murosimf::collision {

/// Of edge k of a triangle: the part of it that is inside has two ends, 0 and 1, and a middle, 2.
[[nodiscard]] constexpr std::uint32_t ridge_feature(int triangle, std::size_t k, std::uint32_t place) {
  return 0x40000000u + (3 * static_cast<std::uint32_t>(triangle) + static_cast<std::uint32_t>(k)) * 4 + place;
}
[[nodiscard]] constexpr std::uint32_t corner_feature(std::uint32_t vertex) { return 0x20000000u + vertex; }

/// Appends those of one triangle that it owns; `at` and results in the frame of the surface.
void find_ridge_contacts(const Relief& relief, int triangle, const Shape& shape, const Transformd& at,
                         std::vector<ReliefContact>& found);

}  // namespace murosimf::collision
