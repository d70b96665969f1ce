/// air_properties.h - properties of round bodies that say what air does to them.
#pragma once

#include <span>

#include "murosimf/model/property.h"
#include "murosimf/model/value.h"

namespace murosimf::properties {

// clang-format off

// ---- constant: of round bodies ----
inline constexpr Property<double> drag_coefficient {{"drag_coefficient", "1", "-", "C_d of a round body in air"}};
inline constexpr Property<double> lift_coefficient {{"lift_coefficient", "1", "-", "C_l that its spin comes to in the end"}};

// clang-format on

/// Every property of this page.
[[nodiscard]] std::span<const CatalogEntry> air_list();

}  // namespace murosimf::properties
