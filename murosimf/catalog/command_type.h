/// command_type.h - commands that plug-ins add to the program: their options as data, independent of the parser.
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
  std::size_t arguments = 0;  ///< number of positional ones: the first, required, no booleans
  /// Receives the user's values, checked against these options; returns the exit code. May throw SetupError for users' errors.
  std::function<int(const OptionValues& given)> run;
};

}  // namespace murosimf::catalog
