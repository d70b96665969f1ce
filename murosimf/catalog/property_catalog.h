/// property_catalog.h - every property of the library that is a row of numbers or a constant: the lists of all rooms.
///
/// Collected by explicit calls: self-registration would fail where the linker drops the object file as unused.
#pragma once

#include <vector>

#include "murosimf/model/property.h"

namespace murosimf::properties {

/// Constants first; otherwise room by room, the lowest first.
[[nodiscard]] const std::vector<CatalogEntry>& catalog();

}  // namespace murosimf::properties
