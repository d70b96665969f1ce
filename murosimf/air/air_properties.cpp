#include "murosimf/air/air_properties.h"

#include <array>

namespace murosimf::properties {
namespace {

constexpr std::array air_entries{constant(drag_coefficient), constant(lift_coefficient)};

}  // namespace

std::span<const CatalogEntry> air_list() { return air_entries; }

}  // namespace murosimf::properties
