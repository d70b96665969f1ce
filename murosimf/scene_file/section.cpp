#include "murosimf/scene_file/section.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::scene_file::section_detail {
namespace {

std::string with_unit(double value, std::string_view unit) {
  return fmt::format("{:g}{}{}", value, unit.empty() || unit == "deg" ? "" : " ", unit == "deg" ? "" : unit);
}

/// "must be ..."; empty if the number is within its bounds.
std::string complaint(double value, const Bounds& bounds, std::string_view unit) {
  const bool low = value < bounds.lowest || (bounds.above && value == bounds.lowest);
  if (!low && value <= bounds.highest) return {};
  if (low && bounds.lowest == 0) return bounds.above ? "must be positive" : "must not be negative";
  if (std::isinf(bounds.lowest)) return fmt::format("is more than {}", with_unit(bounds.highest, unit));
  return fmt::format("must be from {:g} to {}", bounds.lowest, with_unit(bounds.highest, unit));
}

void check(const files::TomlTable& table, std::string_view key, const std::string& wrong) {
  if (!wrong.empty()) throw SetupError(fmt::format("{}: '{}' {}", table.where(key), key, wrong));
}

}  // namespace

double read_number(const files::TomlTable& table, std::string_view key, const Bounds& bounds, std::string_view unit) {
  double value = 0;
  table.read(key, value);
  check(table, key, complaint(value, bounds, unit));
  return value;
}

Vec3d read_vector(const files::TomlTable& table, std::string_view key, const Bounds& bounds, std::string_view unit) {
  Vec3d value;
  table.read(key, value);
  check(table, key, complaint(norm(value), bounds, unit));
  return value;
}

std::string read_text(const files::TomlTable& table, std::string_view key) {
  std::string value;
  table.read(key, value);
  check(table, key, value.empty() ? "is empty: leave it out, or name something" : "");
  return value;
}

std::string read_choice(const files::TomlTable& table, std::string_view key, std::string_view kind,
                        const std::vector<std::string_view>& known) {
  std::string name;
  table.read(key, name);
  if (std::ranges::find(known, name) != known.end()) return name;
  throw SetupError(fmt::format("{}: {}", table.where(key), unknown_name(kind, name, known)));
}

std::string text_of(double value) { return fmt::format("{:.4g}", value); }
std::string text_of(bool value) { return value ? "true" : "false"; }
std::string text_of(std::uint64_t value) { return fmt::format("{}", value); }
std::string text_of(const std::string& value) { return value; }
std::string text_of(const Vec3d& value) { return fmt::format("[{:g}, {:g}, {:g}]", value.x, value.y, value.z); }

}  // namespace murosimf::scene_file::section_detail
