/// state_difference.h - finds the first number that differs in two worlds that should be equal.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "murosimf/world/world.h"

namespace murosimf::recording {

struct StateDifference {
  std::string entity, object, property;  ///< no object: the whole entity
  std::string first, second;             ///< the values, with all digits
  std::size_t others = 0;                ///< further numbers that differ
};

/// The first difference in the order of entities, properties and objects, of everything in the state hash. Nothing: none.
[[nodiscard]] std::optional<StateDifference> state_difference(const World& first, const World& second);

/// "blue1.j_l_knee.joint_position: 0.25 and 0.25000000000000006, and 12 other numbers"
[[nodiscard]] std::string to_text(const StateDifference& difference);

}  // namespace murosimf::recording
