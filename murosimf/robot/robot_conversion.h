/// robot_conversion.h - converts a robot file to an MJCF or URDF file in a normal form, and a TOML file beside it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/robot/mesh_fit.h"
#include "murosimf/robot/table_files.h"
#include "murosimf/robot_formats/reader_options.h"

namespace murosimf::robot {

enum class WrittenFormat : std::uint8_t { mjcf, urdf };

struct ConversionOptions {
  std::filesystem::path folder{};                ///< of the new file
  std::optional<geometry::PrimitiveKind> fit{};  ///< replaces colliding meshes; nothing: they remain
  robot_formats::ReaderOptions reader{};
  WrittenFormat format = WrittenFormat::mjcf;
  std::string mesh_folder = "meshes";  ///< of a URDF file, below `folder`: for meshes that are in no file
};

struct RobotConversion {
  std::string text;  ///< of the file (mjcf_writer.h, urdf_writer.h)
  /// Text of the file beside it: the robot's own, or roles_toml (role_inference.h), and sensors that the format does not have.
  std::string toml;
  std::map<std::string, std::string> meshes;  ///< texts of mesh files to write, by name relative to the folder
  bool own_table = false;                     ///< the robot had a TOML file beside it
  std::vector<TableFiles::Beside> files;      ///< that its own table names, to be copied to the same places in `folder`
  int joints = 0, bodies = 0;                 ///< bodies without joints count as well
  double mass = 0;                            ///< [kg]
  std::vector<MeshFit> fits;                  ///< one for each convex part of a mesh
  std::vector<std::string> warnings;          ///< of the reader
  std::vector<std::string> left_out;          ///< file:line: data that neither the format nor the TOML file has
};

/// Throws SetupError for all errors of the file (robot_reader.h).
[[nodiscard]] RobotConversion convert_robot(const std::filesystem::path& file, const ConversionOptions& options = {});

}  // namespace murosimf::robot
