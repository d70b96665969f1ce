/// format.h - for plug-ins with a format of robot files: `registries.formats.add({...})`, with a reader that returns a
/// RobotDescription.
#pragma once

#include "murosimf/plugin/interface.h"
#include "murosimf/robot/robot_reader.h"
#include "murosimf/robot_formats/reader_options.h"
#include "murosimf/robot_formats/robot_description.h"
