/// mjcf_idle.h - parts of an MJCF file that would change the motion and do not act here: one warning each.
///
/// Tendons with joints, sites or geoms outside of the robot and a spring, a damper, friction, a rotor or a limit; equalities of such
/// tendons, or of the robot with other objects. A tendon without such effects only measures a length and is a line in `unused`.
#pragma once

#include "murosimf/robot_formats/mjcf/mjcf_context.h"
#include "murosimf/robot_formats/mjcf/mjcf_tendons.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

/// Whether a `connect` or `weld` of `equality` has no effect here: not active, or with an end that is not part of the
/// robot (a body that floats or that software moves, the world of a robot that floats).
[[nodiscard]] bool is_idle_equality(const files::XmlElement& element, const MjcfNames& names);

/// Reports idle relations. `tendons`: those that act.
void name_idle_relations(const files::XmlElement& root, const MjcfContext& context,
                         const std::map<std::string, MjcfTendon>& tendons,
                         robot_formats::RobotDescription& description);

}  // namespace murosimf::robot_formats::mjcf
