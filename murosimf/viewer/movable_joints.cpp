#include "murosimf/viewer/movable_joints.h"

#include <numbers>
#include <utility>

#include "murosimf/model/properties.h"

namespace murosimf::viewer {
namespace {

/// [rad] of joints without a range.
constexpr double without_range = std::numbers::pi;

}  // namespace

std::vector<MovableJoint> movable_joints(const SceneOutline& outline, const ShownPoses& poses, int entity) {
  std::vector<MovableJoint> all;
  const PoseFrame* const frame = poses.frame();
  const auto number = static_cast<std::size_t>(entity);
  if (entity < 0 || !frame || number + 1 >= frame->first.size()) return all;
  const Model& model = *outline.of(entity).model;
  for (const int object : model.joints()) {
    const auto row = static_cast<std::size_t>(object);
    const Vec3d* range = model.find(properties::joint_range, object);
    MovableJoint joint{.path = {entity, object},
                       .name = model.objects()[row].name,
                       .lowest = range ? range->x : -without_range,
                       .highest = range ? range->y : without_range};
    joint.position = frame->joint_position[frame->first[number] + row];
    all.push_back(std::move(joint));
  }
  return all;
}

}  // namespace murosimf::viewer
