/// command.h - for plug-ins with a command of the program: `registries.commands.add({...})`; its options are data, and it finds robots
/// and scenes by their names.
#pragma once

#include "murosimf/files/data_path.h"
#include "murosimf/plugin/interface.h"
#include "murosimf/robot/robot_reader.h"
