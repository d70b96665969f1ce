#include "murosimf/soccer/behavior_properties.h"

#include <array>

namespace murosimf::properties {
namespace {

constexpr std::array behavior_entries{variable(pose_estimate), variable(pose_spread), variable(next_waypoint)};

}  // namespace

std::span<const CatalogEntry> behavior_list() { return behavior_entries; }

}  // namespace murosimf::properties
