/// reader_options.h - how robot files are read.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace murosimf::robot_formats {

struct ReaderOptions {
  bool lenient = false;      ///< what is unknown or not supported becomes a warning, where a robot remains without it
  bool guess = true;         ///< soles, frames and servos that nothing names are guessed (role_inference.h)
  bool face_forward = true;  ///< the base of a robot that faces another way is turned (robot_heading.h)
  std::vector<std::string> part_per_group{};  ///< meshes of OBJ files whose objects or groups are convex parts
  std::map<std::string, std::filesystem::path> packages{};  ///< folders of "package://name/..." in URDF
  std::map<std::string, std::string> xacro{};               ///< arguments of a file with macros, by name
  std::string
      body{};  ///< of several robots in a file (MJCF) the one with this body; "world": what is bolted to the world
  std::vector<std::filesystem::path> search_paths{};  ///< folders in which packages are looked for, too
};

}  // namespace murosimf::robot_formats
