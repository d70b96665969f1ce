#include "murosimf/collision/contact_properties.h"

#include <array>

#include "murosimf/collision/relief/relief.h"

namespace murosimf::properties {
namespace {

constexpr std::array contact_entries{constant(excluded_pairs),   constant(allowed_pairs),     constant(relief),
                                     variable(applied_force),    variable(interaction_force), variable(external_force),
                                     variable(external_damping), variable(dynamic),           variable(stance_foot),
                                     variable(separation),       variable(absorbed_impulse)};

}  // namespace

std::span<const CatalogEntry> contact_list() { return contact_entries; }

}  // namespace murosimf::properties
