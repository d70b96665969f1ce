/// reader_options.h - options of the readers of robot files.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace murosimf::robot_formats {

struct ReaderOptions {
  bool lenient = false;      ///< unknown or unsupported parts become warnings, where a robot remains without them
  bool guess = true;         ///< soles, frames and servos that the file does not name are guessed (role_inference.h)
  bool face_forward = true;  ///< the base of a robot that faces another direction is turned (robot_heading.h)
  std::vector<std::string> part_per_group{};  ///< meshes of OBJ files with convex parts as objects or groups
  std::map<std::string, std::filesystem::path> packages{};  ///< folders of "package://name/..." in URDF
  std::map<std::string, std::string> xacro{};               ///< arguments of a file with macros, by name
  std::string
      body{};  ///< of several robots in a file (MJCF) the one with this body; "world": the parts bolted to the world
  std::vector<std::filesystem::path> search_paths{};  ///< additional folders of packages
};

}  // namespace murosimf::robot_formats
