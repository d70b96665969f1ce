/// repair_solids.h - masses of a robot file that could not be simulated, made so that they can.
///
/// Repaired, with a note or warning that says how, are
///   points: they get the inertia of a sphere of water of their mass,
///   inertias with a principal moment that is negative or zero: it is raised to the least that goes with the others,
///   joints that carry no mass: the body behind gets the least mass and inertia,
///   inertia without mass: the least mass,
///   inertia without any moment above zero: a sphere, as for points.
/// Masses and moments of up to 1e-12, with which MJCF files stand for none (mjcf_writer.h), are none.
#pragma once

#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

constexpr double least_mass = 1e-6;     ///< [kg] of what moves; not noticed in any weight
constexpr double least_inertia = 1e-6;  ///< [kg m^2] of a coin of 10 g

/// To be called after the welding: what is fixed to a body counts as part of it.
void repair_solids(robot_formats::RobotDescription& description);

}  // namespace murosimf::robot
