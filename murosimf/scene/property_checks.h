/// property_checks.h - whether a property that a user sets can be set there, and acts.
///
/// A property that algorithms write in every step is set in vain, unless they begin the step with what they find: that is
/// their state. Those are listed in property_checks.cpp; what the levels have of their own stands in catalog/algorithm_catalog.cpp.
#pragma once

#include <string>

#include "murosimf/runtime/simulation.h"
#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene {

/// Of one entity, after initialize(). `time` [s]: when it will be set. Throws SetupError if there is no such object or
/// property, if the numbers are too many, too few or impossible, or if an algorithm would overwrite them. Returns what
/// the user should know because it changes nothing, without the entity's name; empty if it acts.
[[nodiscard]] std::string check_setting(Simulation& simulation, const scene_file::SceneSpec& spec,
                                        const scene_file::PropertySetting& setting, const std::string& entity,
                                        double time);

/// What a controller makes of a walking velocity that is more than it can; empty if it follows it.
[[nodiscard]] std::string check_command(const scene_file::RobotSpec& robot, const Model& model, const Vec3d& command);

/// "walker.pelvis.applied_force"; "walker.joint_target" of all joints.
[[nodiscard]] std::string setting_path(const scene_file::PropertySetting& setting, const Entity& entity);

/// "walker.pelvis.applied_force = [0, 20, 0, 0, 0, 0]"
[[nodiscard]] std::string to_text(const scene_file::PropertySetting& setting, const Entity& entity);

}  // namespace murosimf::scene
