/// body_names.h - what names of bodies say about them.
#pragma once

#include <string>

namespace murosimf::robot {

enum class Side { unknown, left, right };

/// "left_hand", "l_hand", "hand_l", "LHand", "L_HAND"; unknown if it says neither, or both.
[[nodiscard]] Side side_of(const std::string& name);

/// The name of the other side's part of a left one; empty if the name says no side, or says right.
[[nodiscard]] std::string right_name(const std::string& name);

/// hand, gripper, wrist or palm.
[[nodiscard]] bool names_hand(const std::string& name);
/// finger, thumb or jaw.
[[nodiscard]] bool names_finger(const std::string& name);

}  // namespace murosimf::robot
