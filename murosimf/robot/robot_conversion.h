/// robot_conversion.h - a robot file as teams have it becomes an MJCF file in our normal form and a TOML file beside it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/description/reader_options.h"
#include "murosimf/robot/mesh_fit.h"

namespace murosimf::robot {

struct ConversionOptions {
  std::filesystem::path folder{};                ///< where the new file will stand
  std::optional<geometry::PrimitiveKind> fit{};  ///< what meshes that collide become; nothing: they stay
  description::ReaderOptions reader{};
};

struct RobotConversion {
  std::string mjcf;  ///< text of the file (mjcf_writer.h)
  std::string
      toml;  ///< that of the file beside it: the robot's own, or roles_toml (role_inference.h), and sensors that MJCF has no word for
  bool own_table = false;             ///< the robot had a TOML file beside it
  int joints = 0, bodies = 0;         ///< bodies without joints count, too
  double mass = 0;                    ///< [kg]
  std::vector<MeshFit> fits;          ///< one for each convex part of a mesh
  std::vector<std::string> warnings;  ///< of the reader
};

/// Throws SetupError for everything that keeps the file from becoming a model (robot_reader.h).
[[nodiscard]] RobotConversion convert_robot(const std::filesystem::path& file, const ConversionOptions& options = {});

}  // namespace murosimf::robot
