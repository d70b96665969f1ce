#include "murosimf/scene/start_posture.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::scene {

const Keyframe* find_keyframe(const Model& model, std::string_view name) {
  if (name.empty()) return nullptr;
  const Keyframes* keys = model.find(properties::keyframes, 0);
  if (!keys) throw SetupError(fmt::format("keyframe '{}': the file of model '{}' has no keys", name, model.name()));
  const auto found = std::ranges::find(*keys, name, &Keyframe::name);
  if (found != keys->end()) return &*found;
  std::vector<std::string_view> known;
  for (const Keyframe& key : *keys) known.push_back(key.name);
  throw SetupError(unknown_name("keyframe", name, known));
}

double start_position(const Model& model, const Keyframe* keyframe, int joint) {
  if (keyframe) {
    const std::string& name = model.objects()[joint].name;
    const auto found = std::ranges::find(keyframe->positions, name, [](const auto& one) { return one.first; });
    if (found != keyframe->positions.end()) return found->second;
  }
  const double* start = model.find(properties::joint_start, joint);
  return start ? *start : 0;
}

/// Targets as well as positions: servos would leave the posture in the first step.
void take_posture(const Keyframe* keyframe, Entity& robot) {
  if (!robot.find(properties::joint_target)) return;
  auto& targets = robot.column(properties::joint_target).values;
  MUROSIMF_ASSERT(targets.size() == robot.model().objects().size());
  for (const int joint : robot.model().joints()) {
    const bool said = keyframe || robot.model().find(properties::joint_start, joint);
    if (said) targets[joint] = start_position(robot.model(), keyframe, joint);
  }
}

void take_targets(const Keyframe* keyframe, Entity& robot) {
  if (!keyframe) return;
  auto& targets = robot.column(properties::joint_target).values;
  MUROSIMF_ASSERT(targets.size() == robot.model().objects().size());
  for (const auto& [joint, target] : keyframe->targets) targets[robot.model().object_index(joint)] = target;
}

}  // namespace murosimf::scene
