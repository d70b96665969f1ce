/// model_joints.h - joints of a robot's model, as a vendor orders them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "murosimf/model/model.h"

namespace murosimf::dds {

/// Of all joints, in the order of Model::joints().
[[nodiscard]] std::vector<std::string> joint_names(const Model& model);

/// Objects of the model that carry the joints at `places` among Model::joints(), in the order of these.
[[nodiscard]] std::vector<int> joint_objects(const Model& model, std::span<const std::size_t> places);

}  // namespace murosimf::dds
