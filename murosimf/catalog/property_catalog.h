/// property_catalog.h - every property of the library that is a row of numbers or a constant: the lists of all folders.
///
/// Collected by calls: a list that registered itself would be missing wherever the linker takes its file for unused.
#pragma once

#include <vector>

#include "murosimf/model/property.h"

namespace murosimf::properties {

/// Constant ones first; otherwise folder by folder, the lowest first.
[[nodiscard]] const std::vector<CatalogEntry>& catalog();

}  // namespace murosimf::properties
