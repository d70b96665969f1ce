/// property_checks.h - whether a property that a user sets can be set there, and has an effect.
///
/// Setting a property that algorithms write in every step has no effect, unless they read it at the beginning of the step: then it is
/// their state. Those are listed in property_checks.cpp; those of single levels in catalog/algorithm_catalog.cpp.
#pragma once

#include <string>

#include "murosimf/runtime/simulation.h"
#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene {

/// For one entity, after initialize(). `time` [s]: when it will be set. Throws SetupError if there is no such object or
/// property, if the numbers are too many, too few or invalid, or if an algorithm would overwrite them. Returns the
/// reason why it has no effect, without the entity's name; empty if it has one.
[[nodiscard]] std::string check_setting(Simulation& simulation, const scene_file::SceneSpec& spec,
                                        const scene_file::PropertySetting& setting, const std::string& entity,
                                        double time);

/// The limit of a controller for a walking velocity beyond its range; empty if it follows the command.
[[nodiscard]] std::string check_command(const scene_file::RobotSpec& robot, const Model& model, const Vec3d& command);

/// "walker.pelvis.applied_force"; "walker.joint_target" for all joints.
[[nodiscard]] std::string setting_path(const scene_file::PropertySetting& setting, const Entity& entity);

/// "walker.pelvis.applied_force = [0, 20, 0, 0, 0, 0]"
[[nodiscard]] std::string to_text(const scene_file::PropertySetting& setting, const Entity& entity);

}  // namespace murosimf::scene
