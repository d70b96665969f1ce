/// toml_reader.h - typed reading of a TOML table: every error becomes one line with file:line:column.
///
/// Only for .cpp files: it brings toml++ in.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "murosimf/math/vec3.h"

namespace murosimf::files {

/// Parses a file. Throws SetupError if it is missing or not TOML.
[[nodiscard]] toml::table parse_toml_file(const std::filesystem::path& file);

/// "scenes/a.toml:3:7", or the text of the --set that the node came from.
[[nodiscard]] std::string where(const toml::source_region& source);

/// Throws SetupError: where(source): message.
[[noreturn]] void fail_at(const toml::source_region& source, std::string_view message);

/// One table of a file; its keys must be among `known`.
class TomlTable {
 public:
  /// Throws SetupError at the first key that is not known, with the nearest name.
  TomlTable(const toml::table& table, const std::vector<std::string_view>& known);

  // Each sets `value` if the key is there, and throws SetupError if its type or value is wrong.
  void read(std::string_view key, std::string& value) const;
  void read(std::string_view key, double& value) const;  ///< finite
  void read(std::string_view key, bool& value) const;
  void read(std::string_view key, std::uint64_t& value) const;
  /// Two or three numbers; the third is 0 if missing.
  void read(std::string_view key, Vec3d& value) const;

  /// A list of pairs of texts: [["a", "b"], ["c", "d"]].
  void read(std::string_view key, std::vector<std::pair<std::string, std::string>>& value) const;

  [[nodiscard]] const toml::node* find(std::string_view key) const { return table_.get(key); }
  [[nodiscard]] const toml::table* table(std::string_view key) const;                ///< null if missing
  [[nodiscard]] std::vector<const toml::table*> tables(std::string_view key) const;  ///< of [[key]]
  [[nodiscard]] std::string where() const { return files::where(table_.source()); }
  /// Place of the key, or of the table if the key is missing.
  [[nodiscard]] std::string where(std::string_view key) const;

 private:
  const toml::table& table_;
};

/// All numbers of a number or an array of numbers; nothing if it is anything else.
[[nodiscard]] std::optional<std::vector<double>> numbers_of(const toml::node& node);

}  // namespace murosimf::files
