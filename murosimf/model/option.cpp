#include "murosimf/model/option.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf {
namespace {

constexpr std::array<std::string_view, 4> type_names{"number", "boolean", "text", "vector"};

struct ToText {
  std::string operator()(double number) const { return fmt::format("{:.6g}", number); }
  std::string operator()(bool truth) const { return truth ? "true" : "false"; }
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(const Vec3d& v) const { return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", v.x, v.y, v.z); }
};

/// What the range is of: a number, or the length of a vector. 0 if the value has no size.
double size_of(const OptionValue& value) {
  if (const double* number = std::get_if<double>(&value)) return *number;
  if (const Vec3d* vector = std::get_if<Vec3d>(&value)) return norm(*vector);
  return 0;
}

}  // namespace

std::string_view type_name(const OptionValue& value) { return type_names[value.index()]; }

std::string value_text(const OptionValue& value) { return std::visit(ToText{}, value); }

std::string range_text(const OptionInfo& option) {
  const bool low = std::isfinite(option.lowest), high = std::isfinite(option.highest);
  if (low && high) return fmt::format("{:g} to {:g}", option.lowest, option.highest);
  if (low) return fmt::format("from {:g}", option.lowest);
  return high ? fmt::format("up to {:g}", option.highest) : std::string();
}

std::vector<std::string_view> option_names(const std::vector<OptionInfo>& options) {
  std::vector<std::string_view> names;
  for (const OptionInfo& option : options) names.push_back(option.name);
  return names;
}

void check_option(const OptionInfo& option, const OptionValue& value) {
  if (value.index() != option.fallback.index()) {
    throw SetupError(
        fmt::format("'{}' is a {}; it must be a {}", option.name, type_name(value), type_name(option.fallback)));
  }
  const bool sized = std::holds_alternative<double>(value) || std::holds_alternative<Vec3d>(value);
  const double size = size_of(value);
  if (!sized || (std::isfinite(size) && size >= option.lowest && size <= option.highest)) return;
  const std::string range = range_text(option), unit = option.unit.empty() ? "" : " " + option.unit;
  throw SetupError(fmt::format("'{}' is {}; it must be {}", option.name, value_text(value),
                               range.empty() ? "finite" : "in the range " + range + unit));
}

void check_options(std::string_view owner, const std::vector<OptionInfo>& options, const OptionValues& values) {
  for (const auto& [name, value] : values) {
    const OptionInfo* option = nullptr;
    for (const OptionInfo& one : options) {
      if (one.name == name) option = &one;
    }
    if (option) {
      check_option(*option, value);
    } else if (options.empty()) {
      throw SetupError(fmt::format("{} has no options, so '{}' cannot be set", owner, name));
    } else {
      throw SetupError(unknown_name(fmt::format("option of {},", owner), name, option_names(options)));
    }
  }
}

}  // namespace murosimf
