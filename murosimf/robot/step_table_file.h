/// step_table_file.h - the steady walk of a robot as a file (locomotion/step_table.h), comma-separated:
///
///     joints,bin,signal,constant,forward,sideways,turning
///     rigid,0,forward,0.0123,0.41,0,0
///
/// A line for each kind of joints (rigid, compliant), bin of a step, and signal; the numbers are the factors of 1 and of the walking
/// velocity [m/s, m/s, rad/s]. `murosimf fit-steps` writes it.
#pragma once

#include <filesystem>
#include <string>

#include "murosimf/locomotion/step_table.h"

namespace murosimf::robot {

/// Throws SetupError with file:line:column for a file that is no such table, or lacks one of its lines.
[[nodiscard]] locomotion::StepTablePtr read_step_table(const std::filesystem::path& file);

[[nodiscard]] std::string to_csv(const locomotion::StepTable& table);

}  // namespace murosimf::robot
