/// new_name_reader.h - a robot from a file of the format `new_name`: a ball, by now.
///
/// One line with two numbers: radius [m] and mass [kg], with # before comments. This place is for the source of the format (its
/// specification), what is read, what is a note and what is an error (robot_formats/robot_description.h).
#pragma once

#include "murosimf/robot_formats/reader_options.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::new_name {

/// Throws SetupError: file, line, what is wrong, what to do.
[[nodiscard]] robot_formats::RobotDescription read(const std::filesystem::path& file,
                                                   const robot_formats::ReaderOptions& options = {});

}  // namespace murosimf::robot_formats::new_name
