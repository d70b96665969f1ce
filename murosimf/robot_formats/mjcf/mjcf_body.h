/// mjcf_body.h - bodies of an MJCF file, as parts of a description: their places, joints, mass, shapes and sites.
#pragma once

#include "murosimf/robot_formats/mjcf/mjcf_context.h"
#include "murosimf/robot_formats/mjcf/mjcf_trees.h"

namespace murosimf::robot_formats::mjcf {

/// The whole robot. Of a tree that floats the first body is the base, and its place in the file is left out: the scene places robots.
/// Of bolted trees the world is the base, without mass, with its sites that have a name.
/// Fills bodies, cameras, fixed_base and base_joint of `description`.
void read_bodies(const files::XmlElement& root, const MjcfTrees& trees, const MjcfContext& context,
                 robot_formats::RobotDescription& description);

/// Whether it has a `freejoint` or a joint of type free.
[[nodiscard]] bool has_free_joint(const files::XmlElement& body, const std::string& outer_class,
                                  const MjcfDefaults& defaults);

}  // namespace murosimf::robot_formats::mjcf
