#include "murosimf/runtime/pose_frame.h"

#include <algorithm>

#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/world/structural_objects.h"
#include "murosimf/world/world.h"

namespace murosimf {
namespace {

/// Appends the column's rows, or as many default values.
template <class T>
void append_rows(const Entity& entity, const Property<T>& property, std::vector<T>& rows) {
  const auto count = static_cast<std::size_t>(entity.model().size());
  if (const Column<T>* column = entity.find(property)) {
    MUROSIMF_ASSERT(column->values.size() == count);
    rows.insert(rows.end(), column->values.begin(), column->values.end());
  } else {
    rows.insert(rows.end(), count, T{});
  }
}

}  // namespace

void take_poses(const World& world, PoseFrame& frame) {
  frame.first.clear();
  frame.position.clear();
  frame.orientation.clear();
  frame.joint_position.clear();
  frame.frozen.clear();
  frame.present.clear();
  for (const auto& entity : world.entities()) {
    const std::size_t first = frame.position.size();
    frame.first.push_back(first);
    frame.frozen.push_back(entity->frozen());
    frame.present.push_back(entity->present());
    append_rows(*entity, properties::position, frame.position);
    append_rows(*entity, properties::orientation, frame.orientation);
    append_rows(*entity, properties::joint_position, frame.joint_position);
    const StructuralRows structural(entity->model(), entity->columns());  // their poses are in no column
    structural.work_out(properties::position, std::span(frame.position).subspan(first));
    structural.work_out(properties::orientation, std::span(frame.orientation).subspan(first));
  }
  frame.first.push_back(frame.position.size());
  MUROSIMF_ASSERT(frame.first.size() == world.entities().size() + 1 && frame.present.size() + 1 == frame.first.size());
  MUROSIMF_ASSERT(frame.orientation.size() == frame.position.size() &&
                  frame.joint_position.size() == frame.position.size());
}

}  // namespace murosimf
