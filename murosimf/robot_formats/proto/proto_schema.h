/// proto_schema.h - nodes of Webots by what they mean to a robot's model, and the fields of those that act.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace murosimf::robot_formats::proto {

/// Places other nodes and is none itself: Group, Pose, Transform.
[[nodiscard]] bool is_group(std::string_view type);
/// HingeJoint, Hinge2Joint, SliderJoint, BallJoint, and those with backlash.
[[nodiscard]] bool is_joint(std::string_view type);
/// A part with a mass: Solid, Robot and every device that is one.
[[nodiscard]] bool is_solid(std::string_view type);
/// Without effect on the model: lights, fog, sounds, ...
[[nodiscard]] bool is_scenery(std::string_view type);
/// A node of Webots and no PROTO.
[[nodiscard]] bool is_base_node(std::string_view type);

/// Fields of a node that acts; null for other types, whose fields are not looked at.
[[nodiscard]] const std::vector<std::string_view>* fields_of(std::string_view type);

}  // namespace murosimf::robot_formats::proto
