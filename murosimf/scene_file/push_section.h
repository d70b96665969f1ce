/// push_section.h - pushes: forces on bodies for a limited time, by --push and [[pushes]] of a scene file.
///
///     --push 'r1.torso=[60,0,0]@2..2.1'        force in N, world axes, at the body's center of mass, from 2 s to 2.1 s
///     --push 'r1.torso={force=[60,0,0], moment=[0,5,0]}@2..2.1'      or six numbers: force, moment
///
///     [[pushes]]
///     on = "r1.torso"
///     force = [60, 0, 0]
///     from = 2.0
///     to = 2.1
///
/// For .cpp files only: it includes toml++.
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "murosimf/scene_file/assignment.h"
#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene_file {

/// Those of the file, then those of --push. Throws SetupError for impossible forces and times, and for unknown
/// entities.
[[nodiscard]] std::vector<PushSpec> read_pushes(toml::table& scene, const std::vector<std::string>& push_options);

/// PATH.push = [fx, fy, fz, duration] or [fx, fy, fz, mx, my, mz, duration]: a push that begins when the scene changes so. Throws
/// SetupError as read_pushes().
[[nodiscard]] PushSpec read_push_change(toml::table& scene, const Assignment& change);

}  // namespace murosimf::scene_file
