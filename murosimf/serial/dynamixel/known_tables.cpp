// Finds control tables by their names.
#include <list>
#include <map>
#include <mutex>
#include <system_error>

#include "murosimf/files/data_path.h"
#include "murosimf/files/file_access.h"
#include "murosimf/serial/dynamixel/control_table_file.h"

namespace murosimf::serial::dynamixel {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view folder = "servos/tables", extension = ".toml";

/// A name without a path means a supplied table only, which a file of another kind must not hide.
std::optional<fs::path> file_of(std::string_view name, const fs::path& beside) {
  if (name.ends_with(extension)) return files::look_for_data_file(name, folder, "", beside);
  if (name.empty() || name.find('/') != std::string_view::npos) return std::nullopt;
  return files::look_for_data_file(std::string(folder) + "/" + std::string(name) + std::string(extension), "", "");
}

/// Cache of tables. A table stays valid for its users, though its file may change.
class KnownTables {
 public:
  const ControlTable* get(const fs::path& file) {
    std::error_code error;
    const fs::file_time_type changed = fs::last_write_time(file, error);
    Known& entry = known_[fs::weakly_canonical(file, error)];
    if (!entry.table || entry.changed != changed || !look_up_again(file, entry)) {
      tables_.push_back(read_control_table(file));
      entry = {changed, &tables_.back(), base_of(file, tables_.back())};
    }
    return entry.table;
  }

 private:
  struct Known {
    fs::file_time_type changed;
    const ControlTable* table = nullptr;
    const ControlTable* base = nullptr;
  };

  const ControlTable* base_of(const fs::path& file, const ControlTable& table) {
    if (table.base.empty()) return nullptr;
    const auto base = find_base_file(table.base, file.parent_path());
    return base ? get(*base) : nullptr;
  }
  /// Notes all files of a cached table, since a recording contains them. False: the base has changed.
  bool look_up_again(const fs::path& file, const Known& entry) {
    files::note_file_read(file);
    return base_of(file, *entry.table) == entry.base;
  }

  std::list<ControlTable> tables_;  // a list: addresses stay valid
  std::map<fs::path, Known> known_;
};

}  // namespace

/// Each file is read once; buses of several threads may ask at the same time.
const ControlTable* find_servo_table(std::string_view name, const fs::path& beside) {
  static std::mutex mutex;
  static KnownTables tables;
  const std::optional<fs::path> file = file_of(name, beside);
  if (!file) return nullptr;
  const std::scoped_lock lock(mutex);
  return tables.get(*file);
}

std::vector<std::string> servo_table_names() { return files::data_file_names(folder, extension); }

}  // namespace murosimf::serial::dynamixel
