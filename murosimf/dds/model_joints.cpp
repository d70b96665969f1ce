#include "murosimf/dds/model_joints.h"

#include "murosimf/math/assert.h"

namespace murosimf::dds {

std::vector<std::string> joint_names(const Model& model) {
  std::vector<std::string> names;
  for (const int joint : model.joints()) names.push_back(model.objects()[static_cast<std::size_t>(joint)].name);
  return names;
}

std::vector<int> joint_objects(const Model& model, std::span<const std::size_t> places) {
  std::vector<int> objects;
  for (const std::size_t place : places) {
    MUROSIMF_ASSERT(place < model.joints().size());
    objects.push_back(model.joints()[place]);
  }
  return objects;
}

}  // namespace murosimf::dds
