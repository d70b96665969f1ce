#include "murosimf/robot/table_files.h"

#include <algorithm>
#include <array>

#include "murosimf/files/data_path.h"
#include "murosimf/files/file_access.h"
#include "murosimf/robot/robot_config.h"
#include "murosimf/robot/robot_sensors.h"

namespace murosimf::robot {
namespace {

namespace fs = std::filesystem;

fs::path whole(const fs::path& path) { return fs::weakly_canonical(fs::absolute(path)); }

/// Empty if the file is not in the folder.
fs::path place_in(const fs::path& folder, const fs::path& file) {
  const fs::path place = whole(file).lexically_relative(whole(folder));
  return place.empty() || *place.begin() == ".." ? fs::path() : place;
}

/// In one of the folders in which names of tables are searched for.
bool comes_with_the_program(const fs::path& file) {
  constexpr std::array kinds{"lenses", "models", "motions", "parts", "servos"};
  const auto has_it = [&](const fs::path& root) {
    return std::ranges::any_of(kinds, [&](const char* kind) { return !place_in(root / kind, file).empty(); });
  };
  return std::ranges::any_of(files::data_folders(), has_it);
}

}  // namespace

TableFiles table_files(const fs::path& file, const RobotFile& robot, bool lenient) {
  const auto read = std::make_shared<files::FilesRead>();
  const files::FileScope noting({.noted = read});
  const RobotConfig table = read_table_beside(file);
  robot_formats::RobotDescription description = robot.description;  // receives notes, which are known already
  (void)sensors_of(description, table, *robot.model, file.parent_path(), lenient);
  TableFiles all;
  for (const fs::path& one : read->list()) {
    if (comes_with_the_program(one) || whole(one) == whole(fs::path(file).replace_extension(".toml"))) continue;
    const fs::path place = place_in(file.parent_path(), one);
    if (place.empty()) {
      all.elsewhere.push_back(one);
    } else {
      all.beside.push_back({one, place});
    }
  }
  return all;
}

}  // namespace murosimf::robot
