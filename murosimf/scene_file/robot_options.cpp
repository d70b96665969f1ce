#include "murosimf/scene_file/robot_options.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/files/toml_reader.h"
#include "murosimf/model/option.h"

namespace murosimf::scene_file {
namespace {

using Names = std::vector<std::string_view>;

const std::vector<OptionInfo>& options_of(const RobotSpec& robot) {
  return catalog::controllers().find(robot.controller).options;
}

/// Keys that --set has made stand nowhere: then the place of the value.
[[noreturn]] void refuse(const toml::key& key, const toml::node& value, const std::string& message) {
  files::fail_at(key.source().begin.line > 0 ? key.source() : value.source(), message);
}

[[noreturn]] void refuse_unknown(const toml::key& key, const toml::node& value, const std::string& owner,
                                 const Names& known) {
  if (known.empty()) refuse(key, value, fmt::format("{} has no options, so '{}' is none", owner, key.str()));
  refuse(key, value, unknown_name(fmt::format("option of {},", owner), key.str(), known));
}

/// Takes those of `options` that stand in the table.
void take(const toml::table& node, const std::vector<OptionInfo>& options, OptionValues& values) {
  Names keys;
  for (const auto& [key, value] : node) keys.push_back(key.str());
  const files::TomlTable table(node, keys);
  for (const OptionInfo& option : options) {
    if (!table.find(option.name)) continue;
    OptionValue value = option.fallback;
    std::visit([&](auto& typed) { table.read(option.name, typed); }, value);
    with_context(table.where(option.name), [&] { check_option(option, value); });
    values.insert_or_assign(option.name, std::move(value));
  }
}

}  // namespace

void read_options(const toml::table& node, RobotSpec& robot) {
  const Names known = option_names(options_of(robot));
  for (const auto& [key, value] : node) {
    if (std::ranges::find(known, key.str()) != known.end()) continue;
    refuse_unknown(key, value, fmt::format("controller '{}'", robot.controller), known);
  }
  take(node, options_of(robot), robot.options);
}

void read_default_options(const toml::table& node, RobotSpec& robot) { take(node, options_of(robot), robot.options); }

void check_default_options(const toml::table& node, const std::vector<RobotSpec>& robots) {
  Names known;
  for (const RobotSpec& robot : robots) {
    for (const std::string_view name : option_names(options_of(robot))) {
      if (std::ranges::find(known, name) == known.end()) known.push_back(name);
    }
  }
  for (const auto& [key, value] : node) {
    if (std::ranges::find(known, key.str()) != known.end()) continue;
    refuse_unknown(key, value, "the controllers of this scene", known);
  }
}

}  // namespace murosimf::scene_file
