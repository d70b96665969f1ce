// include/murosimf/world.h: entities by name.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/api/scene_inside.h"
#include "murosimf/api/told.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/model_constants.h"
#include "murosimf/world.h"
#include "murosimf/world/column_view.h"

namespace murosimf {

namespace api {

struct ViewInside {
  ColumnView view;
};

namespace {

/// Access to an object. Throws UnknownName.
ObjectAccess object_of(Entity& entity, std::string_view name) {
  if (const auto found = entity.model().find_object(name)) return {entity, *found};
  throw_unknown(fmt::format("object of '{}'", entity.name()), name, entity.model().object_names());
}

Pose pose_of(ObjectAccess object) {
  return told([&] {
    return Pose{vector_of(object.get(properties::position)), rotation_of(object.get(properties::orientation))};
  });
}

Velocity velocity_of(ObjectAccess object) {
  return told([&] {
    return Velocity{vector_of(object.get(properties::linear_velocity)),
                    vector_of(object.get(properties::angular_velocity))};
  });
}

/// Small errors of rounding are removed; others are mistakes of the caller.
Quaterniond unit_quaternion(const Rotation& rotation, const std::string& entity) {
  const double norm =
      std::sqrt(rotation.w * rotation.w + rotation.x * rotation.x + rotation.y * rotation.y + rotation.z * rotation.z);
  constexpr double rounding = 1e-6;
  if (!(std::abs(norm - 1) < rounding)) {
    throw InputError(fmt::format("orientation of '{}' is no unit quaternion, but {:g} long", entity, norm));
  }
  return normalized(Quaterniond{rotation.w, rotation.x, rotation.y, rotation.z});
}

}  // namespace
}  // namespace api

inline namespace v0 {

using api::told;

const std::string& EntityHandle::name() const { return scene_->entity(number_).name(); }

std::vector<std::string> EntityHandle::objects() const {
  std::vector<std::string> names;
  for (const Object& object : scene_->entity(number_).model().objects()) names.push_back(object.name);
  return names;
}

bool EntityHandle::present() const { return scene_->entity(number_).present(); }

std::string EntityHandle::frozen() const { return scene_->entity(number_).frozen_reason().value_or(""); }

Pose EntityHandle::pose() const {
  scene_->begin();
  return api::pose_of(scene_->entity(number_).base());
}

Pose EntityHandle::pose(std::string_view object) const {
  scene_->begin();
  return api::pose_of(api::object_of(scene_->entity(number_), object));
}

Velocity EntityHandle::velocity() const {
  scene_->begin();
  return api::velocity_of(scene_->entity(number_).base());
}

Velocity EntityHandle::velocity(std::string_view object) const {
  scene_->begin();
  return api::velocity_of(api::object_of(scene_->entity(number_), object));
}

void EntityHandle::set_pose(const Pose& pose) {
  api::check_finite(pose.position, fmt::format("position of '{}'", name()));
  const Quaterniond orientation = api::unit_quaternion(pose.orientation, name());
  scene_->begin();
  ObjectAccess base = scene_->entity(number_).base();
  told([&] {
    base.set(properties::orientation, to_matrix(orientation));
    base.set(properties::position, api::vec(pose.position));
  });
}

void EntityHandle::set_velocity(const Velocity& velocity) {
  api::check_finite(velocity.linear, fmt::format("velocity of '{}'", name()));
  api::check_finite(velocity.angular, fmt::format("angular velocity of '{}'", name()));
  scene_->begin();
  ObjectAccess base = scene_->entity(number_).base();
  told([&] {
    base.set(properties::angular_velocity, api::vec(velocity.angular));
    base.set(properties::linear_velocity, api::vec(velocity.linear));
  });
}

/// Through the command of the run, so that recordings have it.
void EntityHandle::place(const Vector3& position, double heading) {
  scene_->begin();
  told([&] {
    scene_->scene.change(
        {fmt::format("{}.place=[{}, {}, {}, {}]", name(), position.x, position.y, position.z, heading)});
  });
}

void EntityHandle::push(std::string_view object, const Vector3& force, double duration, const Vector3& moment) {
  scene_->begin();
  scene_->push(number_, object, force, duration, moment);
}

const std::string& EntityHandle::contact_law() const { return scene_->entity(number_).contact; }

void EntityHandle::set_contact_law(const std::string& law) {
  scene_->begin();
  told([&] { scene_->scene.exchange_contact(name(), law); });
}

std::vector<double> EntityHandle::get(std::string_view object, std::string_view property) const {
  scene_->begin();
  return told([&] { return api::object_of(scene_->entity(number_), object).get(property).numbers; });
}

void EntityHandle::set(std::string_view object, std::string_view property, std::span<const double> values) {
  scene_->begin();
  if (property.starts_with("servo.") || scene::is_constant({.property = std::string(property)})) {
    const std::string dot = object.empty() ? "" : ".";
    return told([&] {
      scene_->scene.change({fmt::format("{}.{}{}{}=[{}]", name(), object, dot, property, fmt::join(values, ", "))});
    });
  }
  told([&] { api::object_of(scene_->entity(number_), object).set(property, values); });
}

std::string EntityHandle::unit(std::string_view object, std::string_view property) const {
  scene_->begin();
  return told([&] { return std::string(api::object_of(scene_->entity(number_), object).get(property).unit); });
}

std::vector<std::string> EntityHandle::properties(std::string_view object) const {
  scene_->begin();
  const auto names = api::object_of(scene_->entity(number_), object).properties();
  return {names.begin(), names.end()};
}

PropertyView EntityHandle::view(std::string_view property) const {
  scene_->begin();
  return told([&] {
    auto inside = std::make_shared<api::ViewInside>(api::ViewInside{scene_->entity(number_).view(property)});
    const ColumnView& view = inside->view;
    const auto& [rows, columns] = view.shape();
    const auto [next_row, next_i, next_j] = view.strides();
    return PropertyView{view.data(),      view.rows(),       {rows, columns},     {next_row, next_i, next_j},
                        view.info().unit, view.info().frame, view.info().meaning, std::move(inside)};
  });
}

}  // namespace v0
}  // namespace murosimf
