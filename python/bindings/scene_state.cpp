#include "scene_state.h"

#include <exception>
#include <utility>

namespace murosimf::python {
namespace {

thread_local const SceneState* controlled = nullptr;  // whose controller this thread calls

[[noreturn]] void throw_in_use() {
  throw Error("this scene is in use in another thread: a scene is for one thread at a time");
}

}  // namespace

SceneState::SceneState(Scene opened, bool has_threads) : scene(std::move(opened)), threads(has_threads) {}

SceneState::~SceneState() {
  // threads that are not there cannot be ended: the child leaves that memory alone
  if (threads && born_ != forks()) (void)new Scene(std::move(scene));
}

JointArrays* SceneState::known_joints(const std::string& robot) {
  const auto found = joints_.find(robot);
  return found != joints_.end() ? &found->second : nullptr;
}

JointArrays& SceneState::joints(const std::string& robot) {
  if (JointArrays* known = known_joints(robot)) return *known;
  return joints_.try_emplace(robot, scene.robot(robot)).first->second;
}

Use::Use(SceneState& state) : state_(state) {
  if (controlled == &state) {
    throw Error(
        "a controller of this scene is being called: it reads its robot's joints and sensors; all else waits for the "
        "end of the step");
  }
  if (state.threads) check_not_forked(state.born_, "this scene");
  if (state.in_use_.exchange(true, std::memory_order_acquire)) throw_in_use();
  try {
    for (auto& [name, joints] : state.joints_) joints.put();
  } catch (...) {
    state.in_use_.store(false, std::memory_order_release);
    throw;
  }
}

Use::~Use() {
  for (auto& [name, joints] : state_.joints_) joints.gather();
  state_.in_use_.store(false, std::memory_order_release);
}

Look::Look(SceneState& state) : state_(controlled == &state ? nullptr : &state) {
  if (state_ && state.in_use_.exchange(true, std::memory_order_acquire)) throw_in_use();
}

Look::~Look() {
  if (state_) state_->in_use_.store(false, std::memory_order_release);
}

InController::InController(const SceneState& state) : before_(std::exchange(controlled, &state)) {}
InController::~InController() { controlled = before_; }

}  // namespace murosimf::python
