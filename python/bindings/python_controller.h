/// python_controller.h - control software in Python: an object that is called at its rate, in the middle of a step.
#pragma once

#include <nanobind/nanobind.h>

#include <string>

#include "murosimf/control.h"
#include "scene_state.h"

namespace murosimf::python {

/// Calls `start(time)`, if it is not None, and `step(time)`. The arrays of the robot's joints show the cycle meanwhile. The two are borrowed:
/// the package keeps them as long as the scene can be stepped.
class PythonController final : public Controller {
 public:
  PythonController(SceneState& state, std::string robot, nanobind::handle start, nanobind::handle step);

  void start(ControlCycle& cycle) override;
  void step(ControlCycle& cycle) override;

 private:
  void call(nanobind::handle function, ControlCycle& cycle);

  SceneState& state_;
  std::string robot_;
  JointArrays& joints_;
  nanobind::handle start_, step_;
};

/// After SimulationError: raises what a controller raised, as the cause of an error that says whose it was; KeyboardInterrupt as it is.
void raise_what_controllers_raised(SceneState& state);

}  // namespace murosimf::python
