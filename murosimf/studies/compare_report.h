/// compare_report.h - a comparison of levels: for people as tables, for programs as JSON, for both as plots.
#pragma once

#include <filesystem>
#include <string>

#include "murosimf/studies/compare_verdict.h"

namespace murosimf::studies {

/// A few lines: the verdict, one line for each level besides the reference, what was compared, for which level sensors are right.
[[nodiscard]] std::string summary(const Comparison& comparison, const Recommendation& recommendation);

/// Tables: what happened, what deviates from the reference, what follows.
[[nodiscard]] std::string details(const Comparison& comparison, const Recommendation& recommendation);

/// One JSON object; docs/compare.md has its keys. Numbers that a level does not have are left out.
[[nodiscard]] std::string to_json(const Comparison& comparison, const Recommendation& recommendation,
                                  const Thresholds& thresholds);

/// Writes center_of_mass.png, torso.png, foot_clearance.png (if the robot has soles) and torque.png (if a level knows
/// torques) into `folder`, one curve per level. Throws SetupError.
void write_plots(const Comparison& comparison, const std::filesystem::path& folder);

/// Makes `folder` if it is not there and tries whether plots could be written. Throws SetupError.
void check_plots(const std::filesystem::path& folder);

}  // namespace murosimf::studies
