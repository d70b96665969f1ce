/// assignment.h - PATH=VALUE, as users write it for --set, --at and events: its meaning in a scene's table.
///
/// For .cpp files only: it includes toml++.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene_file {

/// A path split at its dots, and the text after the equals sign.
struct Assignment {
  std::string where;  ///< for messages
  std::vector<std::string> path;
  std::string value;

  /// The value as TOML, under the key "value"; a bare word is a text. Parsed again for every use, since copies lose their
  /// source.
  [[nodiscard]] toml::table parsed() const;
  /// The parts from `begin` on but the last: names of objects may have dots ("l_foot.offset").
  [[nodiscard]] std::string object(std::size_t begin) const;
};

/// Throws SetupError at `where` if the text is no PATH=VALUE.
[[nodiscard]] Assignment split_assignment(std::string_view text, std::string where);

/// Tables of the robots that the first parts of the path denote, and the number of these parts: ENTITY or TEAM.ROBOT, with
/// * and ?.
[[nodiscard]] std::pair<std::vector<toml::table*>, std::size_t> robots_of(toml::table& scene,
                                                                          const std::vector<std::string>& path);

/// Tables of the bodies with matching names, with * and ?.
[[nodiscard]] std::vector<toml::table*> bodies_called(toml::table& scene, const std::string& pattern);

/// The text under a key; empty if there is none.
[[nodiscard]] std::string text_of(const toml::table& table, std::string_view key);

/// Names of robots and bodies, and "ball" if there is one.
[[nodiscard]] std::vector<std::string> entity_names(const toml::table& scene);

/// Throws SetupError with the nearest name if `key` is not among `known`.
void check_key(const Assignment& assignment, std::string_view key, const std::vector<std::string_view>& known);

/// A force and a moment by name, {force=[...], moment=[...]}, as six numbers: force, moment. Omitted ones are 0.
/// Throws SetupError.
[[nodiscard]] std::vector<double> named_force(const toml::table& table);

/// The assignment as a property of entities: object and property are the parts of the path from `begin` on. Throws
/// SetupError if the value is not numeric.
[[nodiscard]] PropertySetting property_setting(const Assignment& assignment, std::size_t begin,
                                               std::vector<std::string> entities);

}  // namespace murosimf::scene_file
