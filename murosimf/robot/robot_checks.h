/// robot_checks.h - searches a robot for probable errors of its file: the checks of `murosimf check`.
///
/// Every check has a rule that is stated at its threshold. A finding is a warning, since the robot
/// can be simulated with it, unless stated otherwise.
#pragma once

#include <vector>

#include "murosimf/robot/robot_findings.h"
#include "murosimf/robot/robot_reader.h"

namespace murosimf::robot {

/// The messages of the reader, then those of all checks.
[[nodiscard]] std::vector<Finding> examine(const robot::RobotFile& robot);

/// Moving bodies with little or too much mass, and inertias that do not fit their shapes.
[[nodiscard]] std::vector<Finding> examine_masses(const robot_formats::RobotDescription& description);
/// Joints without a servo, and ranges, torques and rates that look like placeholders.
[[nodiscard]] std::vector<Finding> examine_joints(const robot_formats::RobotDescription& description,
                                                  const Model& model);
/// Left and right parts, by their names, of different mass, center of mass or range.
[[nodiscard]] std::vector<Finding> examine_symmetry(const robot_formats::RobotDescription& description);
/// Shapes of bodies that are not neighbors and overlap in the pose of the file, and meshes with very many triangles.
[[nodiscard]] std::vector<Finding> examine_shapes(const robot_formats::RobotDescription& description);
/// Sensors that a simulation of the robot alone, with steps of 1 ms, refuses: errors.
[[nodiscard]] std::vector<Finding> examine_sensors(const robot::RobotFile& robot);
/// Soles, and legs that can be walked with.
[[nodiscard]] std::vector<Finding> examine_legs(const robot_formats::RobotDescription& description, const Model& model);
/// Joints of which the walk engine, at its fastest forward walk, needs higher rates than their servos have without load; with the share of the time.
[[nodiscard]] std::vector<Finding> examine_gait(const robot_formats::RobotDescription& description, const Model& model);

}  // namespace murosimf::robot
