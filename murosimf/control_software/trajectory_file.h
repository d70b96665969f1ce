/// trajectory_file.h - reads joint angles over time from comma-separated values: tables of teams, and logs of this program.
///
///     time [s], l_knee [deg], r_knee [deg]            joints by their names, with units
///     time [s], walker.l_knee.joint_target [rad]      a column of `murosimf run --log 'walker.joint_target'`
#pragma once

#include <filesystem>

#include "murosimf/control_software/joint_trajectory.h"
#include "murosimf/control_software/trajectory_columns.h"
#include "murosimf/model/model.h"

namespace murosimf::control_software {

/// Angles in rad or deg, sliding joints in m, cm or mm, times in s or ms; cells may be empty. Throws SetupError in one line with
/// file:line:column: no such joint, one that comes twice, no or another unit, a cell that is no finite number, times that do not
/// increase, angles more than a turn beyond the joint's range (without one: beyond zero), nothing to play; several other entities in a log.
[[nodiscard]] JointTrajectory read_trajectory(const std::filesystem::path& file, const Model& model,
                                              const LogColumns& log = {});

}  // namespace murosimf::control_software
