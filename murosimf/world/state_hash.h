/// state_hash.h - one number for the state of an entity, for comparisons of runs.
///
/// The state consists of the columns that the next step reads (property.h, is_state): output of sensors and connections of
/// algorithms are excluded, as is what has faded to 0 (PropertyInfo::fades). Columns come in the order of their names, so
/// the order of requests has no influence.
#pragma once

#include "murosimf/math/hash.h"

namespace murosimf {

class Entity;

/// Appends the name of the entity, whether it is present and frozen, and all its state; rows of structural objects are computed first.
void append_state(Hasher& hasher, const Entity& entity);

}  // namespace murosimf
