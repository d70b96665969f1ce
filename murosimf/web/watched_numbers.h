/// watched_numbers.h - numbers of a running scene by their paths, in the notation of logs (logging/log_paths.h), looked up once.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/logging/log_paths.h"

namespace murosimf::web {

/// The single number that a path denotes. Throws SetupError: there is none, or there are several.
[[nodiscard]] logging::LoggedNumber find_number(const World& world, const std::string& path);

/// Its present value; nothing if it does not exist at the present level, or its entity has left.
[[nodiscard]] std::optional<double> value_of(const logging::LoggedNumber& number);

/// All numbers by their paths; those that no longer exist have no value.
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
