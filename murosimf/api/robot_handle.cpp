// include/murosimf/robot.h.
#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "murosimf/api/controller_algorithm.h"
#include "murosimf/api/scene_inside.h"
#include "murosimf/api/told.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/dynamics/odometer.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/locomotion/named_motions.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/robot.h"

namespace murosimf {

namespace api {
namespace {

/// NaN if the level has no such property.
std::span<const double> gathered(const Entity& entity, const JointRows& rows, const Property<double>& property,
                                 std::vector<double>& into) {
  MUROSIMF_ASSERT(into.size() == rows.objects.size());
  const Column<double>* column = entity.find(property);
  for (std::size_t i = 0; i < into.size(); ++i) {
    into[i] =
        column ? column->values[static_cast<std::size_t>(rows.objects[i])] : std::numeric_limits<double>::quiet_NaN();
  }
  return into;
}

void put(Entity& entity, const JointRows& rows, const Property<double>& property, std::span<const double> values) {
  check_row(values, rows.objects.size(), fmt::format("{} of '{}'", property.name, entity.name()));
  if (!entity.find(property)) {
    throw InputError(fmt::format("'{}' has no {} at {}", entity.name(), property.name, entity.level));
  }
  std::vector<double>& column = entity.column(property).values;
  for (std::size_t i = 0; i < values.size(); ++i) column[static_cast<std::size_t>(rows.objects[i])] = values[i];
}

}  // namespace
}  // namespace api

inline namespace v0 {

using api::told;

const std::string& Robot::level() const { return scene_->entity(number_).level; }

void Robot::set_level(const std::string& level) {
  scene_->begin();
  told([&] { scene_->scene.exchange_level(name(), level); });
}

const std::vector<JointInfo>& Robot::joints() const { return scene_->joints(number_).infos; }

std::span<const double> Robot::joint_position() const {
  scene_->begin();
  api::JointRows& rows = scene_->joints(number_);
  return api::gathered(scene_->entity(number_), rows, properties::joint_position, rows.position);
}

std::span<const double> Robot::joint_velocity() const {
  scene_->begin();
  api::JointRows& rows = scene_->joints(number_);
  return api::gathered(scene_->entity(number_), rows, properties::joint_velocity, rows.velocity);
}

std::span<const double> Robot::joint_torque() const {
  scene_->begin();
  api::JointRows& rows = scene_->joints(number_);
  return api::gathered(scene_->entity(number_), rows, properties::joint_torque, rows.torque);
}

std::span<const double> Robot::joint_target() const {
  scene_->begin();
  api::JointRows& rows = scene_->joints(number_);
  return api::gathered(scene_->entity(number_), rows, properties::joint_target, rows.target);
}

void Robot::set_joint_position(std::span<const double> positions) {
  scene_->begin();
  api::put(scene_->entity(number_), scene_->joints(number_), properties::joint_position, positions);
}

void Robot::set_joint_velocity(std::span<const double> velocities) {
  scene_->begin();
  api::put(scene_->entity(number_), scene_->joints(number_), properties::joint_velocity, velocities);
}

void Robot::set_joint_target(std::span<const double> targets) {
  scene_->check_targets_are_free(number_);
  api::put(scene_->entity(number_), scene_->joints(number_), properties::joint_target, targets);
}

/// Checked here: a NaN in a command would only show in the robot's fall.
void Robot::set_command(double forward, double left, double turning) {
  api::check_finite({forward, left, turning}, fmt::format("command of '{}'", name()));
  scene_->begin();
  Entity& entity = scene_->entity(number_);
  if (!entity.find(properties::walk_command)) {
    throw InputError(fmt::format("'{}' has no controller that walks ('walk', 'motions', ...)", name()));
  }
  entity.base().set(properties::walk_command, {forward, left, turning});
}

std::vector<std::string> Robot::motions() const {
  std::vector<std::string> names;
  const auto* motions = scene_->entity(number_).model().find(properties::given_motions, 0);
  for (std::size_t i = 0; motions && i < motions->size(); ++i) names.push_back((*motions)[i].name);
  return names;
}

void Robot::play(const std::string& motion) {
  const std::vector<std::string> known = motions();
  if (std::ranges::find(known, motion) == known.end()) {
    api::throw_unknown(fmt::format("motion of '{}'", name()), motion, {known.begin(), known.end()});
  }
  scene_->begin();
  told([&] { scene_->scene.change({fmt::format("{}.play={}", name(), motion)}); });
}

int Robot::falls() const {
  scene_->begin();
  return dynamics::way_and_falls(scene_->entity(number_)).falls;
}

bool Robot::fallen() const {
  scene_->begin();
  const Column<double>* lying = scene_->entity(number_).find(properties::lying);
  return lying && lying->values[0] == 1;
}

void Robot::set_controller(std::shared_ptr<Controller> controller, double rate) {
  Simulation& simulation = scene_->simulation();
  Entity& entity = scene_->entity(number_);
  const auto old = scene_->controllers.find(number_);
  if (old == scene_->controllers.end() && controller) scene_->check_targets_are_free(number_);
  scene_->begin();
  told([&] {
    api::ControllerTask* task = nullptr;  // attached before the old one is detached: it may be refused
    if (controller) {
      task = &simulation.attach<api::ControllerTask>("controller", entity, rate, *scene_, std::move(controller));
    }
    if (old != scene_->controllers.end()) {
      simulation.detach(*old->second);
      scene_->controllers.erase(old);
    }
    if (task) scene_->controllers[number_] = task;
  });
  scene_->targets_are_free.erase(number_);
}

}  // namespace v0
}  // namespace murosimf
