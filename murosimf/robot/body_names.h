/// body_names.h - what the names of bodies reveal about them.
#pragma once

#include <string>

namespace murosimf::robot {

enum class Side { unknown, left, right };

/// "left_hand", "l_hand", "hand_l", "LHand", "L_HAND"; unknown if the name has neither side, or both.
[[nodiscard]] Side side_of(const std::string& name);

/// The name of the right part to a left one; empty if the name has no side, or is a right one.
[[nodiscard]] std::string right_name(const std::string& name);

/// hand, gripper, wrist or palm.
[[nodiscard]] bool names_hand(const std::string& name);
/// finger, thumb or jaw.
[[nodiscard]] bool names_finger(const std::string& name);

}  // namespace murosimf::robot
