/// mjcf_tendon_ties.h - equality/tendon: one tendon that is held where the length of another one says, or at one length.
///
/// L1 - L1_0 = a_0 + a_1 x + ... + a_4 x^4, x = L2 - L2_0, with L_0 the lengths in the pose of the file; without tendon2 x = 0.
/// Source: MuJoCo documentation, XML reference, "equality", "tendon".
#pragma once

#include <map>
#include <set>
#include <string>

#include "murosimf/robot_formats/mjcf/mjcf_tendons.h"

namespace murosimf::robot_formats::mjcf {

/// Names in the file of tendons that active equalities hold.
[[nodiscard]] std::set<std::string> tied_tendons(const files::XmlElement& root);

/// Whether an equality/tendon is not active, or refers to a tendon that does not act.
[[nodiscard]] bool is_idle_tie(const files::XmlElement& element, const std::map<std::string, MjcfTendon>& tendons);

/// Once `description` has its tendons. Throws SetupError for names that are not in the file, and if two hold one tendon.
void read_ties(const files::XmlElement& root, const std::map<std::string, MjcfTendon>& tendons,
               robot_formats::RobotDescription& description);

}  // namespace murosimf::robot_formats::mjcf
