/// scene_state.h - what stands behind the scenes of Python and their handles: the scene, its joints as arrays, and whose turn it is.
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "forks.h"
#include "joint_arrays.h"
#include "murosimf/scene.h"
#include "murosimf/web_page.h"
#include "sensor_history.h"

namespace murosimf::python {

class SceneState {
 public:
  explicit SceneState(Scene opened, bool threads);
  ~SceneState();
  SceneState(const SceneState&) = delete;
  SceneState& operator=(const SceneState&) = delete;

  /// Of a robot, from the first call on kept as they are in the scene.
  [[nodiscard]] JointArrays& joints(const std::string& robot);
  /// Null before that.
  [[nodiscard]] JointArrays* known_joints(const std::string& robot);

  Scene scene;
  /// Something of it runs in other threads, or draws: a forked child cannot use it.
  bool threads = false;
  /// Of sensors whose samples are kept, by robot and name.
  std::map<std::pair<std::string, std::string>, SensorHistory> histories;
  /// Which shows it to browsers, and has it between the calls; null: none. Steps of calls are no faster than `pace` times real time.
  std::unique_ptr<WebPage> page;
  std::optional<double> pace;
  /// Ends what the page does. With the lock of the interpreter.
  void close_page();
  /// What a controller raised in the last step.
  std::optional<nanobind::python_error> raised;

 private:
  friend class Use;
  friend class Look;
  std::map<std::string, JointArrays, std::less<>> joints_;
  std::atomic<bool> in_use_ = false;
  const unsigned born_ = forks();
};

/// The turn of a call with a scene that a page shows; nothing else. With the lock of the interpreter.
class PageTurn {
 public:
  explicit PageTurn(SceneState& state, WebPage::Use use = WebPage::Use::step);
  /// Without the lock of the interpreter.
  void breathe() {
    if (turn_) turn_->breathe();
  }

 private:
  std::optional<WebPage::Turn> turn_;
};

/// Held by a call that reads, steps or changes the scene: no other thread may at the same time. Puts in before, and gathers after, what
/// arrays of joints show. Throws Error in another thread, and in a controller of the scene.
class Use {
 public:
  explicit Use(SceneState& state, WebPage::Use use = WebPage::Use::step);
  ~Use();
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;

  [[nodiscard]] PageTurn& turn() { return *turn_; }

 private:
  SceneState& state_;
  std::optional<PageTurn> turn_;
};

/// Held by a call that only looks at what may be read in a controller, too: time and samples of sensors.
class Look {
 public:
  explicit Look(SceneState& state);
  ~Look();
  Look(const Look&) = delete;
  Look& operator=(const Look&) = delete;

 private:
  SceneState* state_;
  std::optional<PageTurn> turn_;
};

/// While a controller of a scene is called, in its thread.
class InController {
 public:
  explicit InController(const SceneState& state);
  ~InController();
  InController(const InController&) = delete;
  InController& operator=(const InController&) = delete;

 private:
  const SceneState* before_;
};

}  // namespace murosimf::python
