#include "murosimf/scene_file/setting_targets.h"

#include <fnmatch.h>

#include <algorithm>
#include <set>
#include <string>

#include <fmt/format.h>

#include "murosimf/catalog/property_catalog.h"
#include "murosimf/model/properties.h"

namespace murosimf::scene_file {
namespace {

bool is_pattern(std::string_view name) { return name.find_first_of("*?") != std::string_view::npos; }

std::set<int> objects_like(const Model& model, const std::string& pattern) {
  std::set<int> found;
  for (const std::string_view name : model.object_names()) {
    if (fnmatch(pattern.c_str(), std::string(name).c_str(), 0) == 0) found.insert(model.object_index(name));
  }
  return found;
}

/// A pattern that matches nothing is an error, since it would have no effect.
std::vector<int> matching_objects(const Model& model, std::string_view pattern, bool joints_only) {
  std::set<int> found = objects_like(model, std::string(pattern));
  if (joints_only) std::erase_if(found, [&](int object) { return !model.objects()[object].is_joint(); });
  if (found.empty()) {
    throw SetupError(fmt::format("no {} of model '{}' is called like '{}'", joints_only ? "joint" : "object",
                                 model.name(), pattern));
  }
  return {found.begin(), found.end()};
}

}  // namespace

bool is_of_joints(std::string_view property) {
  const auto of_joints = joint_properties();
  return std::find(of_joints.begin(), of_joints.end(), property) != of_joints.end();
}

std::vector<std::string_view> joint_properties() {
  std::vector<std::string_view> names;
  for (const auto& entry : properties::catalog()) {
    if (entry.info.frame == "joint") names.push_back(entry.info.name);
  }
  return names;
}

/// Without an object, properties of joints are those of all joints, others those of the base.
std::vector<int> objects_meant(const Model& model, std::string_view object, std::string_view property) {
  const bool of_joints = is_of_joints(property);
  if (object.empty() && of_joints) {
    if (model.joints().empty()) throw SetupError(fmt::format("model '{}' has no joints", model.name()));
    return {model.joints().begin(), model.joints().end()};
  }
  if (object.empty()) return {0};
  if (is_pattern(object)) return matching_objects(model, object, of_joints);
  const int index = model.object_index(object);
  if (of_joints && !model.objects()[index].is_joint()) {
    throw SetupError(
        fmt::format("'{}' of model '{}' is no joint, and only joints have '{}'", object, model.name(), property));
  }
  return {index};
}

}  // namespace murosimf::scene_file
