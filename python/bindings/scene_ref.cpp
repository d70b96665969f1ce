#include "scene_ref.h"

#include <cmath>
#include <string>

#include "python_controller.h"
#include "signals.h"

namespace murosimf::python {
namespace {

/// Steps while `more()`.
template <class More>
void step_while(SceneState& state, const More& more) {
  try {
    const Use use(state);
    const nanobind::gil_scoped_release unlocked;
    Signals signals;
    while (more()) {
      state.scene.step();
      signals.check();
    }
  } catch (const SimulationError&) {
    raise_what_controllers_raised(state);
    throw;
  }
}

}  // namespace

void SceneRef::step(std::int64_t steps) {
  if (steps < 0) throw InputError(std::to_string(steps) + " steps");
  step_while(*state, [&] { return steps-- > 0; });
}

void SceneRef::run(double seconds) {
  constexpr double longest = 3e9;                                               // [s] of Scene::run
  if (!(seconds >= 0 && seconds <= longest)) return state->scene.run(seconds);  // says what is wrong
  const std::int64_t end = state->scene.nanoseconds() + std::llround(seconds * 1e9);
  step_while(*state, [&] { return state->scene.nanoseconds() < end; });
}

}  // namespace murosimf::python
