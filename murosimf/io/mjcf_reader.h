/// mjcf_reader.h - a robot from an MJCF file, the format of MuJoCo, as a Model.
///
/// The robot is the body under worldbody that has a free joint. Read are bodies, joints, inertials, geoms, meshes, sites,
/// actuators, default classes and the compiler's angle settings; how they become objects stands in mjcf_body.h. What
/// means nothing to a robot's model (solver options, textures, the floor) is a note; what is unknown or would change
/// the motion is an error. Servos, surfaces and soles come from a TOML file beside the model (robot_table.h).
/// Source: XML reference of the MuJoCo documentation.
/// Limits: no ball joints, tendons, equality constraints, includes and frames.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "murosimf/model/model.h"

namespace murosimf::io {

struct MjcfOptions {
  bool lenient = false;  ///< what is unknown or not supported becomes a warning, where a robot remains without it
};

struct MjcfResult {
  ModelPtr model;
  std::vector<std::string>
      warnings;                    ///< one line each: file:line: what looks wrong, or is dropped because of `lenient`
  std::vector<std::string> notes;  ///< one line each: file:line: what means nothing here
};

/// Throws SetupError: file, line, what is wrong, what to do.
[[nodiscard]] MjcfResult read_mjcf(const std::filesystem::path& file, const MjcfOptions& options = {});

}  // namespace murosimf::io
