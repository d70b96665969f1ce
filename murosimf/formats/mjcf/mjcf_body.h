/// mjcf_body.h - bodies of an MJCF file, as parts of a description: their places, joints, mass, shapes and sites.
#pragma once

#include "murosimf/formats/mjcf/mjcf_context.h"

namespace murosimf::formats::mjcf {

/// The whole robot, from the body with the free joint on. Its place in the file is left out: the scene places robots.
/// Fills bodies, cameras and base_joint of `description`.
void read_bodies(const files::XmlElement& base, const std::string& child_class, const MjcfContext& context,
                 description::RobotDescription& description);

/// Whether it has a `freejoint` or a joint of type free.
[[nodiscard]] bool has_free_joint(const files::XmlElement& body, const std::string& outer_class,
                                  const MjcfDefaults& defaults);

}  // namespace murosimf::formats::mjcf
