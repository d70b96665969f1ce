#include "murosimf/scene_file/robot_options.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/files/toml_reader.h"
#include "murosimf/model/option.h"

namespace murosimf::scene_file {
namespace {

using Names = std::vector<std::string_view>;

/// Keys created by --set have no place: then the place of the value is used.
[[noreturn]] void refuse(const toml::key& key, const toml::node& value, const std::string& message) {
  files::fail_at(key.source().begin.line > 0 ? key.source() : value.source(), message);
}

[[noreturn]] void refuse_unknown(const toml::key& key, const toml::node& value, const std::string& owner,
                                 const Names& known) {
  if (known.empty()) refuse(key, value, fmt::format("{} has no options, so '{}' is none", owner, key.str()));
  refuse(key, value, unknown_name(fmt::format("option of {},", owner), key.str(), known));
}

/// Reads those of `options` that are in the table.
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

void refuse_others(const toml::table& node, const std::string& owner, const Names& known) {
  for (const auto& [key, value] : node) {
    if (std::ranges::find(known, key.str()) == known.end()) refuse_unknown(key, value, owner, known);
  }
}

/// Its own options first, so that their bounds apply, then those that only others of the registry have.
std::vector<OptionInfo> own_and_others(const auto& registry, std::string_view owner) {
  std::vector<OptionInfo> all = registry.find(owner).options;
  for (const auto& other : registry) {
    for (const OptionInfo& option : other.options) {
      if (!find_option(all, option.name)) all.push_back(option);
    }
  }
  return all;
}

constexpr std::array all_options{
    RobotOptions{"options", "controller", &RobotSpec::controller, &RobotSpec::options,
                 [](std::string_view name) { return catalog::controllers().find(name).options; }},
    RobotOptions{"level_options", "level", &RobotSpec::level, &RobotSpec::level_options,
                 [](std::string_view name) { return own_and_others(catalog::levels(), name); }},
    RobotOptions{"contact_options", "contact law", &RobotSpec::contact, &RobotSpec::contact_options,
                 [](std::string_view name) { return own_and_others(catalog::contacts(), name); }},
};

/// Options of a controller without a list of them: numbers, booleans, texts and vectors.
std::vector<OptionInfo> options_as_given(const toml::table& node) {
  std::vector<OptionInfo> options;
  for (const auto& [key, value] : node) {
    OptionInfo info{.name = std::string(key.str()), .fallback = 0.0};
    if (value.is_boolean()) info.fallback = false;
    if (value.is_string()) info.fallback = std::string();
    if (value.is_array()) info.fallback = Vec3d();
    options.push_back(std::move(info));
  }
  return options;
}

bool takes_any(const RobotOptions& options, const RobotSpec& robot) {
  return options.key == "options" && catalog::controllers().find(robot.controller).any_options;
}

std::vector<OptionInfo> options_of(const RobotOptions& options, const RobotSpec& robot) {
  return options.of(robot.*options.owner);
}

}  // namespace

std::span<const RobotOptions> robot_options() { return all_options; }

bool is_options_key(std::string_view key) {
  return std::ranges::find(all_options, key, &RobotOptions::key) != all_options.end();
}

void read_options(const RobotOptions& options, const toml::table& node, RobotSpec& robot) {
  const std::vector<OptionInfo> known = takes_any(options, robot) ? options_as_given(node) : options_of(options, robot);
  refuse_others(node, fmt::format("{} '{}'", options.kind, robot.*options.owner), option_names(known));
  take(node, known, robot.*options.values);
  // a class that is loaded: whether the file or the command line names it
  if (const toml::node* named = node.get("class"); named && takes_any(options, robot))
    robot.given["options.class"] = {files::where(named->source())};
}

void read_default_options(const RobotOptions& options, const toml::table& node, RobotSpec& robot) {
  take(node, options_of(options, robot), robot.*options.values);
}

/// A default that no robot uses is most likely misspelled.
void check_default_options(const RobotOptions& options, const toml::table& node, const std::vector<RobotSpec>& robots) {
  std::vector<std::string> known;
  for (const RobotSpec& robot : robots) {
    for (const OptionInfo& option : options_of(options, robot)) {
      if (std::ranges::find(known, option.name) == known.end()) known.push_back(option.name);
    }
  }
  refuse_others(node, fmt::format("the {}s of this scene", options.kind), Names(known.begin(), known.end()));
}

OptionValues read_any_options(const toml::table& node) {
  OptionValues values;
  take(node, options_as_given(node), values);
  return values;
}

OptionValues read_own_options(const toml::table& node, const std::string& owner,
                              const std::vector<OptionInfo>& options) {
  OptionValues values;
  refuse_others(node, owner, option_names(options));
  take(node, options, values);
  return values;
}

}  // namespace murosimf::scene_file
