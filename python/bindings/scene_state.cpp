#include "scene_state.h"

#include <atomic>
#include <exception>
#include <string>
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
  if (born_ == forks()) {
    close_page();
  } else {
    (void)page.release();  // its threads are not here
  }
  // threads that are not there cannot be ended: the child leaves that memory alone
  if (threads && born_ != forks()) (void)new Scene(std::move(scene));
}

void SceneState::close_page() {
  if (!page) return;
  const nanobind::gil_scoped_release unlocked;  // a controller may be at work there
  page.reset();
}

JointArrays* SceneState::known_joints(const std::string& robot) {
  const auto found = joints_.find(robot);
  return found != joints_.end() ? &found->second : nullptr;
}

JointArrays& SceneState::joints(const std::string& robot) {
  if (JointArrays* known = known_joints(robot)) return *known;
  return joints_.try_emplace(robot, scene.robot(robot)).first->second;
}

PageTurn::PageTurn(SceneState& state, WebPage::Use use) {
  if (!state.page) return;
  const nanobind::gil_scoped_release unlocked;  // likewise
  turn_.emplace(*state.page, use);
}

Use::Use(SceneState& state, WebPage::Use use) : state_(state) {
  if (controlled == &state) {
    throw Error(
        "a controller of this scene is being called: it reads its robot's joints and sensors; all else waits for the "
        "end of the step");
  }
  if (state.threads) check_not_forked(state.born_, "this scene");
  if (state.in_use_.exchange(true, std::memory_order_acquire)) throw_in_use();
  try {
    turn_.emplace(state, use);
    for (auto& [name, joints] : state.joints_) joints.put();
  } catch (...) {
    state.in_use_.store(false, std::memory_order_release);
    throw;
  }
}

Use::~Use() {
  for (auto& [name, joints] : state_.joints_) joints.gather();
  turn_.reset();
  state_.in_use_.store(false, std::memory_order_release);
}

Look::Look(SceneState& state) : state_(controlled == &state ? nullptr : &state) {
  if (!state_) return;
  if (state.in_use_.exchange(true, std::memory_order_acquire)) throw_in_use();
  try {
    turn_.emplace(state);
  } catch (...) {
    state.in_use_.store(false, std::memory_order_release);
    throw;
  }
}

Look::~Look() {
  turn_.reset();
  if (state_) state_->in_use_.store(false, std::memory_order_release);
}

InController::InController(const SceneState& state) : before_(std::exchange(controlled, &state)) {}
InController::~InController() { controlled = before_; }

}  // namespace murosimf::python
