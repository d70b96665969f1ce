#include "murosimf/files/toml_reader.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/files/input_file.h"
#include "murosimf/files/text_encoding.h"
#include "murosimf/files/toml_bounds.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

/// The number of a node. Whole numbers beyond 2^53 have neighbors that no floating-point number can tell from them.
double number_of(const toml::node& node) {
  MUROSIMF_ASSERT(node.is_number());
  constexpr std::int64_t largest = std::int64_t{1} << 53;
  const auto* whole = node.as_integer();
  if (!whole) return **node.as_floating_point();
  if (**whole > largest || **whole < -largest) {
    fail_at(node.source(), fmt::format("{} has too many digits to be held exactly (2^53 = {} is the largest whole "
                                       "number); write it with a decimal point",
                                       **whole, largest));
  }
  return static_cast<double>(**whole);
}

}  // namespace

toml::table parse_toml_file(const std::filesystem::path& file) {
  const std::string text = read_text_file(file, most_toml_bytes);
  check_toml_bounds(text, file.string());
  try {
    return toml::parse(text, file.string());
  } catch (const toml::parse_error& error) {
    const auto& begin = error.source().begin;
    throw SetupError(
        one_line(fmt::format("{}:{}:{}: {}", file.string(), begin.line, begin.column, error.description())));
  }
}

std::string where(const toml::source_region& source) {
  const std::string path = source.path ? *source.path : std::string("scene");
  if (path.starts_with("--")) return path;  // of an option
  return fmt::format("{}:{}:{}", path, source.begin.line, source.begin.column);
}

void fail_at(const toml::source_region& source, std::string_view message) {
  throw SetupError(fmt::format("{}: {}", where(source), message));
}

TomlTable::TomlTable(const toml::table& table, const std::vector<std::string_view>& known) : table_(table) {
  for (const auto& [key, node] : table) {
    if (std::find(known.begin(), known.end(), key.str()) == known.end()) {
      fail_at(key.source(), unknown_name("key", key.str(), known));
    }
  }
}

void TomlTable::read(std::string_view key, std::string& value) const {
  const toml::node* node = find(key);
  if (!node) return;
  if (!node->is_string()) fail_at(node->source(), fmt::format("'{}' must be a text in quotes", key));
  value = **node->as_string();
}

void TomlTable::read(std::string_view key, double& value) const {
  const toml::node* node = find(key);
  if (!node) return;
  const auto numbers = node->is_array() ? std::nullopt : numbers_of(*node);
  if (!numbers || !std::isfinite(numbers->front()))
    fail_at(node->source(), fmt::format("'{}' must be a finite number", key));
  value = numbers->front();
}

void TomlTable::read(std::string_view key, bool& value) const {
  const toml::node* node = find(key);
  if (!node) return;
  if (!node->is_boolean()) fail_at(node->source(), fmt::format("'{}' must be true or false", key));
  value = **node->as_boolean();
}

void TomlTable::read(std::string_view key, std::uint64_t& value) const {
  const toml::node* node = find(key);
  if (!node) return;
  if (!node->is_integer() || **node->as_integer() < 0)
    fail_at(node->source(), fmt::format("'{}' must be a whole number from 0", key));
  value = static_cast<std::uint64_t>(**node->as_integer());
}

void TomlTable::read(std::string_view key, Vec3d& value) const {
  const toml::node* node = find(key);
  if (!node) return;
  const auto numbers = node->is_array() ? numbers_of(*node) : std::nullopt;
  if (!numbers || numbers->size() < 2 || numbers->size() > 3) {
    fail_at(node->source(), fmt::format("'{}' must be two or three numbers in brackets", key));
  }
  for (const double number : *numbers) {
    if (!std::isfinite(number)) fail_at(node->source(), fmt::format("'{}' must be finite numbers", key));
  }
  value = {(*numbers)[0], (*numbers)[1], numbers->size() == 3 ? (*numbers)[2] : 0};
}

void TomlTable::read(std::string_view key, std::vector<std::pair<std::string, std::string>>& value) const {
  const toml::node* node = find(key);
  if (!node) return;
  const auto refuse = [&](const toml::node& at) {
    fail_at(at.source(), fmt::format("'{}' must be a list of pairs of names: [[\"a\", \"b\"]]", key));
  };
  if (!node->is_array()) refuse(*node);
  value.clear();
  for (const toml::node& element : *node->as_array()) {
    const toml::array* pair = element.as_array();
    if (!pair || pair->size() != 2 || !(*pair)[0].is_string() || !(*pair)[1].is_string()) refuse(element);
    value.emplace_back(**(*pair)[0].as_string(), **(*pair)[1].as_string());
  }
}

const toml::table* TomlTable::table(std::string_view key) const {
  const toml::node* node = find(key);
  if (!node) return nullptr;
  if (!node->is_table()) fail_at(node->source(), fmt::format("'{}' must be a table: [{}]", key, key));
  return node->as_table();
}

std::vector<const toml::table*> TomlTable::tables(std::string_view key) const {
  std::vector<const toml::table*> result;
  const toml::node* node = find(key);
  if (!node) return result;
  if (!node->is_array()) fail_at(node->source(), fmt::format("'{}' must be a list of tables: [[{}]]", key, key));
  for (const toml::node& element : *node->as_array()) {
    if (!element.is_table()) fail_at(element.source(), fmt::format("'{}' must be a list of tables: [[{}]]", key, key));
    result.push_back(element.as_table());
  }
  return result;
}

std::string TomlTable::where(std::string_view key) const {
  const toml::node* node = find(key);
  return node ? files::where(node->source()) : where();
}

std::optional<std::vector<double>> numbers_of(const toml::node& node) {
  std::vector<double> numbers;
  const auto add = [&](const toml::node& element) {
    if (!element.is_number()) return false;
    numbers.push_back(number_of(element));
    return true;
  };
  if (const toml::array* array = node.as_array()) {
    for (const toml::node& element : *array) {
      if (!add(element)) return std::nullopt;
    }
  } else if (!add(node)) {
    return std::nullopt;
  }
  if (numbers.empty()) return std::nullopt;
  return numbers;
}

}  // namespace murosimf::files
