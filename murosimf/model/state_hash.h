/// state_hash.h - one number for the state of an entity, by which runs are compared.
///
/// State are the columns from which the next step goes on (property.h, is_state): what sensors show and what connects
/// algorithms is left out, and what has faded to 0 (PropertyInfo::fades). Columns come in the order of their names, so it
/// does not matter who asked for them first.
#pragma once

#include "murosimf/math/hash.h"

namespace murosimf {

class Entity;

/// The name of the entity, whether it is there and frozen, and all its state; rows of structural objects are worked out before.
void append_state(Hasher& hasher, const Entity& entity);

}  // namespace murosimf
