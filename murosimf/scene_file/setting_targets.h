/// setting_targets.h - objects of a model that a setting denotes: "torso", "j_l_*", or none for all joints or the base.
#pragma once

#include <string_view>
#include <vector>

#include "murosimf/model/model.h"

namespace murosimf::scene_file {

/// Whether only joints have the property, by the catalog.
[[nodiscard]] bool is_of_joints(std::string_view property);

/// Names of all of them, for suggestions.
[[nodiscard]] std::vector<std::string_view> joint_properties();

/// Indices, in the order of the model. No `object`: all joints if the property is theirs, else the base. * and ? are wildcards;
/// of joints' properties they match joints only. Throws SetupError: with the nearest name if there is no such object,
/// if it is no joint, and if nothing matches.
[[nodiscard]] std::vector<int> objects_meant(const Model& model, std::string_view object, std::string_view property);

}  // namespace murosimf::scene_file
