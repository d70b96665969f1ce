#include "murosimf/runtime/pose_frame.h"

#include <algorithm>

#include "murosimf/model/properties.h"
#include "murosimf/model/structural_objects.h"
#include "murosimf/model/world.h"

namespace murosimf {
namespace {

/// The column's rows, or as many of a default.
template <class T>
void append_rows(const Entity& entity, const Property<T>& property, std::vector<T>& rows) {
  const auto count = static_cast<std::size_t>(entity.model().size());
  if (const Column<T>* column = entity.find(property)) {
    rows.insert(rows.end(), column->values.begin(), column->values.end());
  } else {
    rows.insert(rows.end(), count, T{});
  }
}

/// Those of structural objects stand in no column.
template <class T>
void work_out_structural(const Entity& entity, const Property<T>& property, std::span<T> rows) {
  for (int i = 0; i < entity.model().size(); ++i) {
    const auto value = structural_value(entity.model(), entity.columns(), property, i);
    if (value) rows[static_cast<std::size_t>(i)] = *value;
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
    work_out_structural(*entity, properties::position, std::span(frame.position).subspan(first));
    work_out_structural(*entity, properties::orientation, std::span(frame.orientation).subspan(first));
  }
  frame.first.push_back(frame.position.size());
}

}  // namespace murosimf
