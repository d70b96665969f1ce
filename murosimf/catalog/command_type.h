/// command_type.h - commands that plug-ins add to the program: their options as data, so that no parser stands between.
///
///     murosimf --plugin own_plugin.so weigh kid21 --gravity 1.62
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "murosimf/model/option.h"

namespace murosimf::catalog {

struct CommandType {
  std::string name;     ///< small letters, digits and "-": "count-legs"
  std::string meaning;  ///< one line of --help
  /// Numbers, booleans and texts. On the command line they are `--NAME VALUE`, or `--NAME` for true.
  std::vector<OptionInfo> options;
  std::size_t arguments = 0;  ///< so many of them, the first ones, are values without `--NAME`, and needed; no booleans
  /// Gets what the user has given, checked against these; returns the exit code. May throw SetupError for users' errors.
  std::function<int(const OptionValues& given)> run;
};

}  // namespace murosimf::catalog
