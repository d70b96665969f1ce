/// robot_options.h - options of the algorithms that a robot of a scene file names: [robots.options] of its controller,
/// [robots.level_options] and [robots.contact_options].
///
/// For .cpp files only: it includes toml++.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene_file {

/// Options of one of a robot's algorithms.
struct RobotOptions {
  std::string_view key;   ///< "options"
  std::string_view kind;  ///< of the algorithm: "controller"
  std::string RobotSpec::*owner;
  OptionValues RobotSpec::*values;
  /// Allowed entries of its table: for a level or a law also those of others, since a scene runs at several (unused_settings.h).
  std::vector<OptionInfo> (*of)(std::string_view owner);
};

[[nodiscard]] std::span<const RobotOptions> robot_options();
/// Whether a key of a robot has such a table.
[[nodiscard]] bool is_options_key(std::string_view key);

/// Reads the table into the robot. Throws SetupError with file:line:column: a key that no such algorithm has, with the nearest; a
/// value of another type or out of range.
void read_options(const RobotOptions& options, const toml::table& node, RobotSpec& robot);

/// Reads those of [defaults] that the robot's algorithm has; the others are for other robots. Throws SetupError for values.
void read_default_options(const RobotOptions& options, const toml::table& node, RobotSpec& robot);

/// Throws SetupError for a key of [defaults] that no robot's algorithm has.
void check_default_options(const RobotOptions& options, const toml::table& node, const std::vector<RobotSpec>& robots);

/// Options of an algorithm that exists once in a scene; `owner` is for messages. Throws SetupError as read_options does.
[[nodiscard]] OptionValues read_own_options(const toml::table& node, const std::string& owner,
                                            const std::vector<OptionInfo>& options);

/// Options of a class that says itself which it takes: numbers, booleans, texts and vectors.
[[nodiscard]] OptionValues read_any_options(const toml::table& node);

}  // namespace murosimf::scene_file
