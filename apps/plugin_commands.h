/// plugin_commands.h - commands that plug-ins add: `murosimf --plugin FILE COMMAND ...`.
#pragma once

#include <string>
#include <vector>

#include "apps/command_line.h"
#include "murosimf/catalog/command_type.h"
#include "murosimf/model/registry.h"

namespace murosimf::app {

/// Adds them all. Throws SetupError: a name that is none or taken, options that cannot be part of a command line.
void add_plugin_commands(CommandLine& line, const Registry<catalog::CommandType>& commands);

}  // namespace murosimf::app
