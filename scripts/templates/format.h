/// new_name_reader.h - a robot from a file of the format `new_name`: a ball, by now.
///
/// One line with two numbers: radius [m] and mass [kg], with # before comments. Here stand the source of the format (its
/// specification), what is read, what is a note and what is an error (description/robot_description.h).
#pragma once

#include "murosimf/description/reader_options.h"
#include "murosimf/description/robot_description.h"

namespace murosimf::formats::new_name {

/// Throws SetupError: file, line, what is wrong, what to do.
[[nodiscard]] description::RobotDescription read(const std::filesystem::path& file,
                                                 const description::ReaderOptions& options = {});

}  // namespace murosimf::formats::new_name
