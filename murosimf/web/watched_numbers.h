/// watched_numbers.h - numbers of a running scene by their paths, as logs have them (logging/log_paths.h), looked up once.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/logging/log_paths.h"

namespace murosimf::web {

/// The one number that a path means. Throws SetupError: there is none, or there are several.
[[nodiscard]] logging::LoggedNumber find_number(const World& world, const std::string& path);

/// Its value now; nothing if it is not there at the present level, or its entity has left.
[[nodiscard]] std::optional<double> value_of(const logging::LoggedNumber& number);

/// All by their paths; those that mean nothing any more have no value.
class WatchedNumbers {
 public:
  [[nodiscard]] std::vector<std::pair<std::string, std::optional<double>>> read(const World& world,
                                                                                const std::vector<std::string>& paths);

 private:
  std::vector<std::string> paths_;
  std::vector<std::optional<logging::LoggedNumber>> numbers_;
};

/// All paths of an entity, sensors first. Throws SetupError if there is no such entity.
[[nodiscard]] std::vector<std::string> paths_of(World& world, const std::string& entity);

}  // namespace murosimf::web
