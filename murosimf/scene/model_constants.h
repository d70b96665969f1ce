/// model_constants.h - constants of a model that a scene overrides: --set 'blue1.torso.mass=1.2'.
///
///     blue1.torso.mass, .center_of_mass, .inertia               of an object that has a mass
///     blue1.j_l_shin.joint_damping, .joint_range, ...            of a joint; blue1.joint_damping: of all joints
///     blue1.j_l_shin.servo.stall_torque, ...                     of its servo; blue1.servo.voltage: of all servos
#pragma once

#include <string>
#include <vector>

#include "murosimf/model/model.h"
#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene {

/// Whether the setting is of a constant, not of a property that changes while a scene runs.
[[nodiscard]] bool is_constant(const scene_file::PropertySetting& setting);

/// A copy of the model with other constants. Masses are set first; the inertia is scaled with its mass, which `diagnostics` report.
/// Throws SetupError that begins with the setting's place: for objects without that constant, and impossible numbers.
[[nodiscard]] ModelPtr with_constants(const Model& model, const std::vector<scene_file::PropertySetting>& settings,
                                      std::vector<std::string>& diagnostics);

}  // namespace murosimf::scene
