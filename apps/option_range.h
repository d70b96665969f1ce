/// option_range.h - numbers of options that must be within a range. Unlike CLI::Range, "nan" and numbers with too many
/// digits are not.
#pragma once

#include <charconv>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace murosimf::app {

/// Whole numbers if `low` is one.
template <class Number>
[[nodiscard]] CLI::Validator in_range(Number low, Number high) {
  const auto check = [low, high](const std::string& text) -> std::string {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool good = error == std::errc{} && end == text.data() + text.size() && number >= low && number <= high;
    return good ? std::string{} : fmt::format("Value {} not in range {} to {}", text, low, high);
  };
  return {check, fmt::format("{} in [{} - {}]", CLI::detail::type_name<Number>(), low, high)};
}

}  // namespace murosimf::app
