/// robot_options.h - options of the algorithms that a robot of a scene file names: [robots.options] of its controller,
/// [robots.level_options] and [robots.contact_options].
///
/// Only for .cpp files: it brings toml++ in.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene_file {

/// Options of one of the algorithms of a robot.
struct RobotOptions {
  std::string_view key;   ///< "options"
  std::string_view kind;  ///< of the algorithm: "controller"
  std::string RobotSpec::*owner;
  OptionValues RobotSpec::*values;
  /// What may stand in its table: of a level or a law also what others have, since a scene runs at several (unused_settings.h).
  std::vector<OptionInfo> (*of)(std::string_view owner);
};

[[nodiscard]] std::span<const RobotOptions> robot_options();
/// Whether a key of a robot has such a table.
[[nodiscard]] bool is_options_key(std::string_view key);

/// Into the robot. Throws SetupError with file:line:column: a key that no such algorithm has, with the nearest; a
/// value of another type or out of range.
void read_options(const RobotOptions& options, const toml::table& node, RobotSpec& robot);

/// Of [defaults] those that the robot's algorithm has; the others are for other robots. Throws SetupError for values.
void read_default_options(const RobotOptions& options, const toml::table& node, RobotSpec& robot);

/// Throws SetupError for a key of [defaults] that the algorithm of none of the robots has.
void check_default_options(const RobotOptions& options, const toml::table& node, const std::vector<RobotSpec>& robots);

/// Options of something that stands once in a scene; `owner` is for messages. Throws SetupError as read_options does.
[[nodiscard]] OptionValues read_own_options(const toml::table& node, const std::string& owner,
                                            const std::vector<OptionInfo>& options);

}  // namespace murosimf::scene_file
