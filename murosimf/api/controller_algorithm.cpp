#include "murosimf/api/controller_algorithm.h"

#include <cstddef>
#include <exception>
#include <utility>

#include "murosimf/api/scene_inside.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/world/state_archive.h"

namespace murosimf {
inline namespace v0 {

Controller::~Controller() = default;
void Controller::start(ControlCycle&) {}

}  // namespace v0

namespace api {

ControllerTask::ControllerTask(Setup& setup, SceneInside& scene, std::shared_ptr<Controller> controller)
    : scene_(scene),
      controller_(std::move(controller)),
      joints_(setup.model().joints()),
      q_(setup.read(properties::joint_position)),
      qd_(setup.observe(properties::joint_velocity)),
      targets_(setup.write(properties::joint_target)),
      position_(joints_.size()),
      velocity_(joints_.size()),
      target_(joints_.size()) {
  MUROSIMF_ASSERT(controller_ != nullptr);
}

void ControllerTask::step(const Instant& instant) noexcept {
  if (scene_.failed) return;  // the exception is rethrown at the end of the step
  gather();
  ControlCycle cycle{seconds(instant.now), seconds(instant.period), position_, velocity_, target_};
  try {
    if (!started_) controller_->start(cycle);
    started_ = true;
    controller_->step(cycle);
  } catch (...) {
    scene_.fail(std::current_exception());
    return;
  }
  for (std::size_t i = 0; i < joints_.size(); ++i) targets_[static_cast<std::size_t>(joints_[i])] = target_[i];
}

void ControllerTask::state(StateArchive& archive) { archive(started_); }

void ControllerTask::gather() noexcept {
  MUROSIMF_ASSERT(position_.size() == joints_.size() && target_.size() == joints_.size());
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const auto row = static_cast<std::size_t>(joints_[i]);
    position_[i] = q_[row];
    velocity_[i] = qd_[row];
    target_[i] = targets_[row];
  }
}

}  // namespace api
}  // namespace murosimf
