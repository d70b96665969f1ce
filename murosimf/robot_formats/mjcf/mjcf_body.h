/// mjcf_body.h - reads bodies of an MJCF file: their places, joints, mass, shapes and sites.
#pragma once

#include "murosimf/robot_formats/mjcf/mjcf_context.h"
#include "murosimf/robot_formats/mjcf/mjcf_trees.h"

namespace murosimf::robot_formats::mjcf {

/// Reads the whole robot. The first body of a floating tree is the base, and its place in the file is ignored: the scene places robots.
/// Of bolted trees the world is the base, without mass, with its named sites.
/// Fills bodies, cameras, fixed_base and base_joint of `description`.
void read_bodies(const files::XmlElement& root, const MjcfTrees& trees, const MjcfContext& context,
                 robot_formats::RobotDescription& description);

/// Whether the body has a `freejoint` or a joint of type free.
[[nodiscard]] bool has_free_joint(const files::XmlElement& body, const std::string& outer_class,
                                  const MjcfDefaults& defaults);

}  // namespace murosimf::robot_formats::mjcf
