/// repair_solids.h - repairs masses of a robot file that could not be simulated.
///
/// The following is repaired, with a note or warning that gives the new numbers:
///   points: they get the inertia of a sphere of water of their mass,
///   inertias with a principal moment that is negative or zero: it is raised to the least that is possible with the others,
///   joints that carry no mass: the body behind gets the least mass and inertia,
///   inertia without mass: the least mass,
///   inertia without any moment above zero: a sphere, as for points.
/// Masses and moments of up to 1e-12, which MJCF files have in place of none (mjcf_writer.h), are none.
#pragma once

#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

constexpr double least_mass = 1e-6;     ///< [kg] of a moving body; without effect on any weight
constexpr double least_inertia = 1e-6;  ///< [kg m^2] of a coin of 10 g

/// To be called after welding: parts that are fixed to a body count as parts of it.
void repair_solids(robot_formats::RobotDescription& description);

}  // namespace murosimf::robot
