#include "murosimf/model/option.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf {
namespace {

constexpr std::array<std::string_view, 4> type_names{"number", "boolean", "text", "vector"};

struct ToText {
  std::string operator()(double number) const { return fmt::format("{:.6g}", number); }
  std::string operator()(bool truth) const { return truth ? "true" : "false"; }
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(const Vec3d& v) const {
    return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", v.x + 0.0, v.y + 0.0, v.z + 0.0);
  }
};

/// The number that the range applies to: a number, or the length of a vector. 0 if the value has no size.
double size_of(const OptionValue& value) {
  if (const double* number = std::get_if<double>(&value)) return *number;
  if (const Vec3d* vector = std::get_if<Vec3d>(&value)) return norm(*vector);
  return 0;
}

/// For values with a size: numbers and vectors.
bool has_good_size(const OptionInfo& option, const OptionValue& value) {
  const double size = size_of(value);
  const double* fallback = std::get_if<double>(&option.fallback);
  // an infinite default means "no limit", so users may write it as well
  const bool may_be_infinite = fallback && std::isinf(*fallback);
  if (std::isnan(size) || (std::isinf(size) && !may_be_infinite)) return false;
  if (size < option.lowest.value || (option.lowest.open && size == option.lowest.value)) return false;
  return size <= option.highest && (!option.whole || size == std::floor(size));
}

/// "a whole number in the range 1 to 5 px"
std::string allowed_text(const OptionInfo& option) {
  const std::string range = range_text(option),
                    unit = option.unit.empty() || option.unit == "1" ? "" : " " + option.unit;
  std::string text = option.whole ? "a whole number" : "";
  if (range.empty()) return option.whole ? text : "finite";
  if (option.whole) text += " ";
  return text + "in the range " + range + unit;
}

}  // namespace

std::string_view type_name(const OptionValue& value) {
  MUROSIMF_ASSERT(value.index() < type_names.size());
  return type_names[value.index()];
}

std::string_view type_name(const OptionInfo& option) { return option.whole ? "integer" : type_name(option.fallback); }

std::string value_text(const OptionValue& value) { return std::visit(ToText{}, value); }

std::string default_text(const OptionInfo& option) {
  const double* number = std::get_if<double>(&option.fallback);
  return number && std::isnan(*number) ? "-" : value_text(option.fallback);
}

std::string range_text(const OptionInfo& option) {
  if (!option.choices.empty()) return fmt::format("{}", fmt::join(option.choices, ", "));
  const double lowest = option.lowest.value;
  const bool low = std::isfinite(lowest), high = std::isfinite(option.highest);
  if (low && option.lowest.open)
    return fmt::format("above {:g}{}", lowest, high ? fmt::format(" to {:g}", option.highest) : "");
  if (low && high) return fmt::format("{:g} to {:g}", lowest, option.highest);
  if (low) return fmt::format("from {:g}", lowest);
  return high ? fmt::format("up to {:g}", option.highest) : std::string();
}

const OptionInfo* find_option(const std::vector<OptionInfo>& options, std::string_view name) {
  const auto found = std::ranges::find(options, name, &OptionInfo::name);
  return found == options.end() ? nullptr : &*found;
}

OptionValues values_among(const std::vector<OptionInfo>& options, const OptionValues& values) {
  OptionValues found;
  for (const auto& [name, value] : values) {
    if (find_option(options, name)) found.emplace(name, value);
  }
  return found;
}

std::vector<std::string_view> option_names(const std::vector<OptionInfo>& options) {
  std::vector<std::string_view> names;
  for (const OptionInfo& option : options) names.push_back(option.name);
  return names;
}

void check_option(const OptionInfo& option, const OptionValue& value) {
  if (value.index() != option.fallback.index()) {
    const bool flag = std::holds_alternative<bool>(option.fallback);
    throw SetupError(fmt::format("'{}' is a {}; it must be {}", option.name, type_name(value),
                                 flag ? "true or false" : fmt::format("a {}", type_name(option.fallback))));
  }
  if (const auto* text = std::get_if<std::string>(&value)) {
    const auto& choices = option.choices;
    if (choices.empty() || std::ranges::find(choices, *text) != choices.end()) return;
    throw SetupError(unknown_name(option.name, *text, {choices.begin(), choices.end()}));
  }
  if (std::holds_alternative<bool>(value) || has_good_size(option, value)) return;
  throw SetupError(fmt::format("'{}' is {}; it must be {}", option.name, value_text(value), allowed_text(option)));
}

void check_options(std::string_view owner, const std::vector<OptionInfo>& options, const OptionValues& values) {
  for (const auto& [name, value] : values) {
    if (const OptionInfo* option = find_option(options, name)) {
      check_option(*option, value);
    } else if (options.empty()) {
      throw SetupError(fmt::format("{} has no options, so '{}' cannot be set", owner, name));
    } else {
      throw SetupError(unknown_name(fmt::format("option of {},", owner), name, option_names(options)));
    }
  }
}

}  // namespace murosimf
