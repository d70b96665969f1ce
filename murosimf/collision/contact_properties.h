/// contact_properties.h - properties of forces on bodies: contacts, users, and which entities can be pushed.
///
/// Frames as in model/properties.h: "world" means world axes.
#pragma once

#include <span>

#include "murosimf/model/property.h"
#include "murosimf/model/shape.h"
#include "murosimf/model/value.h"

namespace murosimf::properties {

// clang-format off

// ---- constant: which shapes of a model may touch each other ----
inline constexpr Property<ExcludedPairs> excluded_pairs {{"excluded_pairs", "-", "-", "objects of the robot that never touch each other", Scope::base}};
inline constexpr Property<AllowedPairs> allowed_pairs {{"allowed_pairs", "-", "-", "shapes of the robot that touch each other whatever else forbids it", Scope::base}};

// ---- variable: of every object ----
inline constexpr Property<Wrenchd> applied_force      {{"applied_force", "N, N m", "world, at the object's origin", "push on a body that stays until it is changed: force, moment"}};
inline constexpr Property<Wrenchd> interaction_force  {{"interaction_force", "N, N m", "world, at the object's origin", "contacts with other moving bodies: force, moment"}};
inline constexpr Property<Wrenchd> external_force     {{"external_force", "N, N m", "world, at the object's origin", "sum of pushes, air and contacts: force, moment"}};
inline constexpr Property<Sym6d>  external_damping   {{"external_damping", "N m s, N s, N s/m", "world, at the object's origin", "how fast external_force falls with the object's velocity"}};

// ---- variable: one for the whole entity ----
inline constexpr Property<double> dynamic           {{"dynamic", "1", "-", "1: forces move the entity, 0: it pushes and is never pushed", Scope::base}};
inline constexpr Property<double> stance_foot        {{"stance_foot", "1", "-", "0: first sole of the model stands, 1: second", Scope::base}};
inline constexpr Property<Vec3d>  separation         {{"separation", "m", "world", "way in this step besides that of its motion: out of bodies that are not pushed either, or back to where it meets something", Scope::base}};
inline constexpr Property<Wrenchd> absorbed_impulse   {{"absorbed_impulse", "N s, N m s", "world, at the world's origin", "what contacts gave to a body that cannot be pushed", Scope::base}};

// clang-format on

/// Every property of this page, constant ones first.
[[nodiscard]] std::span<const CatalogEntry> contact_list();

}  // namespace murosimf::properties
