/// rule_names.h - states and penalties of GameControllers in words, for reports.
#pragma once

#include <string>

namespace murosimf::league {

// "state 9" of numbers that have no name.
[[nodiscard]] std::string state_name(int state);
[[nodiscard]] std::string secondary_state_name(int state);
[[nodiscard]] std::string penalty_name(int penalty);

}  // namespace murosimf::league
