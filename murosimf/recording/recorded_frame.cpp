#include "murosimf/recording/recorded_frame.h"

#include <limits>
#include <utility>

#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::recording {
namespace {

double number_at(const Column<double>* column, int object) {
  MUROSIMF_ASSERT(!column || static_cast<std::size_t>(object) < column->values.size());
  return column ? column->values[static_cast<std::size_t>(object)] : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

/// Columns are found once: frames are taken in each step.
RecordedEntity recorded_entity(const Entity& entity) {
  RecordedEntity result{.entity = &entity, .name = entity.name(), .links = {}, .joints = {}, .columns = {}};
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

bool has_poses(const Entity& entity) {
  return entity.find(properties::position) && entity.find(properties::orientation);
}

/// Everything that has a pose.
std::vector<RecordedEntity> recorded_entities(const World& world) {
  std::vector<RecordedEntity> result;
  for (const auto& entity : world.entities()) {
    if (has_poses(*entity)) result.push_back(recorded_entity(*entity));
  }
  return result;
}

std::vector<RecordedSensor> recorded_sensors(const World& world) {
  std::vector<RecordedSensor> result;
  for (const auto& entity : world.entities()) add_sensors_of(*entity, result);
  return result;
}

void add_sensors_of(const Entity& entity, std::vector<RecordedSensor>& sensors) {
  for (const sensors::Reading* reading : sensors::readings_of(entity)) {
    sensors.push_back({.entity = entity.name(), .reading = reading, .samples = 0});
  }
}

template <class T>
const Column<T>* RecordedColumns::keep(const Entity& entity, const Property<T>& property) {
  kept_.push_back(entity.columns().share(property.name));
  return entity.find(property);
}

void RecordedColumns::follow(const Entity& entity) {
  if (level_ == entity.level) return;
  std::vector<std::shared_ptr<ColumnBase>> before = std::move(kept_);  // kept alive until the new lookup
  kept_.clear();
  position = keep(entity, properties::position);
  orientation = keep(entity, properties::orientation);
  joint_position = keep(entity, properties::joint_position);
  joint_velocity = keep(entity, properties::joint_velocity);
  joint_torque = keep(entity, properties::joint_torque);
  joint_target = keep(entity, properties::joint_target);
  drawings = keep(entity, properties::drawings);
  level_ = entity.level;
}

void RecordedFrame::begin_anew(Duration at) {
  RecordedFrame anew;
  anew.time = at;
  anew.present = std::move(present);
  anew.poses = std::move(poses);
  anew.joints = std::move(joints);
  anew.contacts = std::move(contacts);
  anew.present.clear();
  anew.contacts.clear();  // poses and joints are overwritten
  *this = std::move(anew);
}

void take_numbers(std::vector<RecordedEntity>& entities, RecordedFrame& frame) {
  frame.of_poses = true;
  std::size_t links = 0, joints = 0;
  for (const RecordedEntity& one : entities) {
    links += one.links.size();
    joints += one.joints.size();
  }
  frame.present.reserve(entities.size());
  frame.poses.resize(links);
  frame.joints.resize(joints);
  // Written in place: a temporary is stored in halves and loaded whole, which defeats store forwarding of the processor.
  Transformd* pose = frame.poses.data();
  JointNumbers* numbers = frame.joints.data();
  for (RecordedEntity& one : entities) {
    RecordedColumns& columns = one.columns;
    columns.follow(*one.entity);
    const bool placed = columns.position && columns.orientation;
    frame.present.push_back(placed && one.entity->present() ? 1 : 0);
    for (const RecordedEntity::Link& link : one.links) {
      const auto i = static_cast<std::size_t>(link.object);
      pose->position = placed ? columns.position->values[i] : Vec3d{};
      pose->orientation = placed ? columns.orientation->values[i] : Mat3d{};
      ++pose;
    }
    for (const RecordedEntity::Joint& joint : one.joints) {
      numbers->position = number_at(columns.joint_position, joint.object);
      numbers->velocity = number_at(columns.joint_velocity, joint.object);
      numbers->torque = number_at(columns.joint_torque, joint.object);
      numbers->target = number_at(columns.joint_target, joint.object);
      ++numbers;
    }
  }
}

}  // namespace murosimf::recording
