/// proto_schema.h - nodes of Webots by their role in a robot's model, and the fields of those that act.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace murosimf::robot_formats::proto {

/// Whether the type only places other nodes: Group, Pose, Transform.
[[nodiscard]] bool is_group(std::string_view type);
/// Whether it is HingeJoint, Hinge2Joint, SliderJoint, BallJoint, or one of those with backlash.
[[nodiscard]] bool is_joint(std::string_view type);
/// Whether it is a part with a mass: Solid, Robot and every device that is one.
[[nodiscard]] bool is_solid(std::string_view type);
/// Whether it has no effect on the model: lights, fog, sounds, ...
[[nodiscard]] bool is_scenery(std::string_view type);
/// Whether it is a node of Webots and not a PROTO.
[[nodiscard]] bool is_base_node(std::string_view type);

/// Fields of a node that acts; null for other types: their fields are not examined.
[[nodiscard]] const std::vector<std::string_view>* fields_of(std::string_view type);

}  // namespace murosimf::robot_formats::proto
