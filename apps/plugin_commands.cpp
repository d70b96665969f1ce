#include "apps/plugin_commands.h"

#include <algorithm>
#include <deque>
#include <optional>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::app {
namespace {

/// What the user gives of one option; the parser writes it.
struct GivenOption {
  OptionInfo info;
  std::string word;  ///< as it stands on the command line: "--limit"
  std::optional<double> number{};
  std::string text{};
  bool flag = false;

  [[nodiscard]] std::optional<OptionValue> value() const {
    if (flag) return true;
    if (!text.empty()) return text;
    return number ? std::optional<OptionValue>(*number) : std::nullopt;
  }
};

/// The parser keeps references: elements stay where they are.
using GivenOptions = std::deque<GivenOption>;

std::string help_of(const OptionInfo& option) {
  const std::string range = range_text(option), fallback = default_text(option);
  return fmt::format("{}{}{}{}", option.meaning, option.unit.empty() ? "" : fmt::format(" [{}]", option.unit),
                     range.empty() ? "" : fmt::format(", {}", range),
                     fallback.empty() || fallback == "-" ? "" : fmt::format("; default: {}", fallback));
}

Option add_option(const Command& command, GivenOption& given) {
  const std::string help = help_of(given.info);
  if (std::holds_alternative<double>(given.info.fallback)) return command.add(given.word, given.number, help);
  if (std::holds_alternative<std::string>(given.info.fallback)) return command.add(given.word, given.text, help);
  const bool flag = std::holds_alternative<bool>(given.info.fallback);
  if (flag && given.word.starts_with("--")) return command.add(given.word, given.flag, help);
  throw SetupError(
      fmt::format("'{}' cannot be given on a command line: it is a {}", given.word, type_name(given.info)));
}

OptionValues checked_values(const GivenOptions& options) {
  OptionValues values;
  for (const GivenOption& given : options) {
    const std::optional<OptionValue> value = given.value();
    if (!value) continue;
    with_context(given.word, [&] { check_option(given.info, *value); });
    values.emplace(given.info.name, *value);
  }
  return values;
}

void check_name(const std::string& name) {
  const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
  if (std::ranges::all_of(name, fits) && name.front() != '-') return;
  throw SetupError(fmt::format("'{}' is no name of a command: small letters, digits and - only", name));
}

void add_plugin_command(CommandLine& line, const catalog::CommandType& type) {
  check_name(type.name);
  const auto given = std::make_shared<GivenOptions>();
  const Command command =
      line.add(type.name, type.meaning, [&type, given] { return type.run(checked_values(*given)); });
  for (std::size_t i = 0; i < type.options.size(); ++i) {
    const OptionInfo& info = type.options[i];
    const bool argument = i < type.arguments;
    const std::string word = argument ? info.name : "--" + info.name;
    const Option option = add_option(command, given->emplace_back(GivenOption{info, word}));
    if (argument) option.required();
  }
}

}  // namespace

void add_plugin_commands(CommandLine& line, const Registry<catalog::CommandType>& commands) {
  for (const catalog::CommandType& type : commands) {
    with_context(fmt::format("command '{}'", type.name), [&] { add_plugin_command(line, type); });
  }
}

}  // namespace murosimf::app
