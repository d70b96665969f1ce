#include "python_controller.h"

#include <nanobind/stl/string.h>

#include <cstdio>
#include <exception>
#include <string>
#include <utility>

namespace nb = nanobind;

namespace murosimf::python {

PythonController::PythonController(SceneState& state, std::string robot, nb::handle start, nb::handle step)
    : state_(state), robot_(std::move(robot)), joints_(state.joints(robot_)), start_(start), step_(step) {}

void PythonController::start(ControlCycle& cycle) {
  if (!start_.is_none()) call(start_, cycle);
}

void PythonController::step(ControlCycle& cycle) { call(step_, cycle); }

void PythonController::call(nb::handle function, ControlCycle& cycle) {
  const nb::gil_scoped_acquire locked;
  const InController in_controller(state_);
  joints_.show(cycle);
  try {
    function(cycle.time);
  } catch (nb::python_error& error) {
    char time[32];
    std::snprintf(time, sizeof time, "%.3f s", cycle.time);
    if (!state_.raised) state_.raised.emplace(std::move(error));
    throw SimulationError("the controller of '" + robot_ + "' failed at " + time);
  }
  joints_.take(cycle);
}

void raise_what_controllers_raised(SceneState& state) {
  if (!state.raised) return;
  nb::python_error raised = std::move(*state.raised);
  state.raised.reset();
  if (!raised.matches(PyExc_Exception)) throw nb::python_error(std::move(raised));
  const std::exception_ptr simulation_error = std::current_exception();
  const nb::object type = nb::module_::import_("murosimf.errors").attr("SimulationError");
  const std::string what = nb::cast<std::string>(nb::str(raised.type().attr("__name__"))) + ": " +
                           nb::cast<std::string>(nb::str(raised.value()));
  std::string where = "a controller failed";
  try {
    std::rethrow_exception(simulation_error);
  } catch (const Error& error) {
    where = error.what();
  }
  nb::raise_from(raised, type, "%s: %s", where.c_str(), what.c_str());
}

}  // namespace murosimf::python
