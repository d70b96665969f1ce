/// behavior_properties.h - properties of a robot's own estimates and plans.
#pragma once

#include <span>

#include "murosimf/model/property.h"
#include "murosimf/model/value.h"

namespace murosimf::properties {

// clang-format off

// ---- variable: one for the whole entity ----
inline constexpr Property<Vec3d>  pose_estimate      {{"pose_estimate", "m, m, rad", "field", "x, y and heading of the robot as it takes them itself", Scope::base}};
inline constexpr Property<Vec3d>  pose_spread        {{"pose_spread", "m, m, rad", "field", "standard deviations of what the robot takes for possible poses", Scope::base}};
inline constexpr Property<double> next_waypoint      {{"next_waypoint", "1", "-", "of the way that the robot walks; 0: the first", Scope::base}};

// clang-format on

/// Every property of this header, constant ones first.
[[nodiscard]] std::span<const CatalogEntry> behavior_list();

}  // namespace murosimf::properties
