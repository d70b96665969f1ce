// Control tables that were read, once each.
#include <list>
#include <map>
#include <mutex>
#include <system_error>

#include "murosimf/connect/dynamixel/control_table_file.h"
#include "murosimf/files/data_path.h"

namespace murosimf::connect::dynamixel {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view folder = "servos/tables", extension = ".toml";

/// Of a name without a path only what comes with the program, which a file of another kind must not hide.
std::optional<fs::path> file_of(std::string_view name, const fs::path& beside) {
  if (name.ends_with(extension)) return files::look_for_data_file(name, folder, "", beside);
  if (name.empty() || name.find('/') != std::string_view::npos) return std::nullopt;
  return files::look_for_data_file(std::string(folder) + "/" + std::string(name) + std::string(extension), "", "");
}

}  // namespace

const ControlTable* find_servo_table(std::string_view name, const fs::path& beside) {
  struct Known {
    fs::file_time_type changed;
    const ControlTable* table = nullptr;
  };
  static std::mutex mutex;
  static std::list<ControlTable> tables;  // whoever has one keeps it, though its file may change
  static std::map<fs::path, Known> known;
  const std::optional<fs::path> file = file_of(name, beside);
  if (!file) return nullptr;
  std::error_code error;
  const fs::path path = fs::weakly_canonical(*file, error);
  const fs::file_time_type changed = fs::last_write_time(*file, error);
  const std::scoped_lock lock(mutex);
  Known& entry = known[path];
  if (!entry.table || entry.changed != changed) {
    ControlTable table = read_control_table(*file);
    tables.push_back(std::move(table));
    entry = {changed, &tables.back()};
  }
  return entry.table;
}

std::vector<std::string> servo_table_names() { return files::data_file_names(folder, extension); }

}  // namespace murosimf::connect::dynamixel
