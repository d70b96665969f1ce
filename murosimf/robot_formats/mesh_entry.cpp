#include "murosimf/robot_formats/mesh_entry.h"

#include <algorithm>

#include <fmt/format.h>

namespace murosimf::robot_formats {
namespace {

std::string free_name(const RobotDescription& robot, const std::string& stem) {
  std::string name = stem;
  const auto taken = [&](const MeshDescription& known) { return known.name == name; };
  for (int number = 2; std::ranges::any_of(robot.meshes, taken); ++number) name = fmt::format("{}_{}", stem, number);
  return name;
}

}  // namespace

MeshDescription mesh_entry(RobotDescription& robot, const std::filesystem::path& file, const Vec3d& scale,
                           const std::string& where) {
  const auto same = [&](const MeshDescription& known) { return known.file == file && is_zero(known.scale - scale); };
  // Two shapes of one file at two scales are two meshes: hulls are made at their final size.
  const auto known = std::ranges::find_if(robot.meshes, same);
  if (known != robot.meshes.end()) return *known;
  MeshDescription entry;
  entry.name = free_name(robot, file.stem().string());
  entry.where = where;
  entry.file = file;
  entry.scale = scale;
  robot.meshes.push_back(entry);
  return entry;
}

}  // namespace murosimf::robot_formats
