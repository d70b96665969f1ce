#include "murosimf/recording/recorded_frame.h"

#include <limits>

#include "murosimf/model/properties.h"

namespace murosimf::recording {
namespace {

/// The rows of a property; null if nobody has it.
template <class T>
const T* rows_of(const Entity& entity, const Property<T>& property) {
  const Column<T>* column = entity.find(property);
  return column ? column->values.data() : nullptr;
}

double number_at(const double* rows, int object) {
  return rows ? rows[object] : std::numeric_limits<double>::quiet_NaN();
}

RecordedEntity recorded(const Entity& entity) {
  RecordedEntity result{.entity = &entity, .name = entity.name(), .links = {}, .joints = {}};
  const Model& model = entity.model();
  const auto name_of = [&](int object) { return model.objects()[static_cast<std::size_t>(object)].name; };
  for (const Link& link : model.tree().links) {
    result.links.push_back(
        {.object = link.object, .parent = link.parent, .frame = entity.name() + "/" + name_of(link.object)});
  }
  for (const int joint : model.joints()) {
    result.joints.push_back({.object = joint, .name = entity.name() + "/" + name_of(joint)});
  }
  return result;
}

}  // namespace

std::vector<RecordedEntity> recorded_entities(const World& world) {
  std::vector<RecordedEntity> result;
  for (const auto& entity : world.entities()) {
    if (entity->find(properties::position) && entity->find(properties::orientation))
      result.push_back(recorded(*entity));
  }
  return result;
}

std::vector<RecordedSensor> recorded_sensors(const World& world) {
  std::vector<RecordedSensor> result;
  for (const auto& entity : world.entities()) {
    for (const sensors::Reading* reading : sensors::readings_of(*entity)) {
      result.push_back({.entity = entity->name(), .reading = reading, .samples = 0});
    }
  }
  return result;
}

void take_numbers(const std::vector<RecordedEntity>& entities, RecordedFrame& frame) {
  frame.of_poses = true;
  std::size_t links = 0, joints = 0;
  for (const RecordedEntity& one : entities) links += one.links.size(), joints += one.joints.size();
  frame.poses.reserve(links);
  frame.joints.reserve(joints);
  for (const RecordedEntity& one : entities) {
    const Entity& entity = *one.entity;
    frame.present.push_back(entity.present() ? 1 : 0);
    const Vec3d* r = rows_of(entity, properties::position);
    const Mat3d* R = rows_of(entity, properties::orientation);
    for (const RecordedEntity::Link& link : one.links) frame.poses.push_back({r[link.object], R[link.object]});
    const double* position = rows_of(entity, properties::joint_position);
    const double* velocity = rows_of(entity, properties::joint_velocity);
    const double* torque = rows_of(entity, properties::joint_torque);
    const double* target = rows_of(entity, properties::joint_target);
    for (const RecordedEntity::Joint& joint : one.joints) {
      frame.joints.push_back({.position = number_at(position, joint.object),
                              .velocity = number_at(velocity, joint.object),
                              .torque = number_at(torque, joint.object),
                              .target = number_at(target, joint.object)});
    }
  }
}

}  // namespace murosimf::recording
