/// mjcf_spatial_tendons.h - the path of a spatial tendon: `site`, `geom` with `sidesite`, `pulley`.
///
/// A pulley ends a branch and begins one whose length counts with 1/divisor. Only spheres and cylinders are wrapped.
/// Source: MuJoCo documentation, XML reference, "spatial".
#pragma once

#include <vector>

#include "murosimf/robot_formats/mjcf/mjcf_names.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

/// Empty if a site or geom is not part of the robot. Throws SetupError for a site that is not in the file, and where a branch does not go
/// from site to site with at most one geom between two of them.
[[nodiscard]] std::vector<robot_formats::TendonBranchDescription> path_of_tendon(const files::XmlElement& tendon,
                                                                                 const MjcfNames& names);

/// Once the bodies are read: throws SetupError for a geom of the path that does not exist or is neither a sphere nor a cylinder.
void check_path(const files::XmlElement& tendon, const std::vector<robot_formats::TendonBranchDescription>& path,
                const robot_formats::RobotDescription& description);

}  // namespace murosimf::robot_formats::mjcf
