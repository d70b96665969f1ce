#include "scene_ref.h"

#include <chrono>
#include <cmath>
#include <cstdint>
#include <string>
#include <thread>

#include "python_controller.h"
#include "signals.h"

namespace murosimf::python {
namespace {

/// Between two steps of a scene that a page shows: lets the page do what it was asked for, and keeps steps at their pace.
class Watched {
 public:
  Watched(SceneState& state, PageTurn& turn) : state_(state), turn_(turn), begin_(state.scene.time()) {
    if (state.page) state.page->pause();
  }

  void between(Signals& signals) {
    if (!state_.page) return;
    while (clock::now() >= next_ || ahead() > patience) {
      if (ahead() > patience) std::this_thread::sleep_for(patience);
      turn_.breathe();
      next_ = clock::now() + patience;
      signals.check();
    }
  }

 private:
  using clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds patience{10};

  /// Of the wall clock.
  [[nodiscard]] std::chrono::duration<double> ahead() const {
    const std::chrono::duration<double> wall = clock::now() - started_;
    return state_.pace ? std::chrono::duration<double>((state_.scene.time() - begin_) / *state_.pace) - wall
                       : std::chrono::duration<double>(0);
  }

  SceneState& state_;
  PageTurn& turn_;
  const double begin_;  // [s] simulated
  const clock::time_point started_ = clock::now();
  clock::time_point next_ = started_ + patience;
};

/// Steps while `more()`.
template <class More>
void step_while(SceneState& state, const More& more) {
  try {
    Use use(state);
    const nanobind::gil_scoped_release unlocked;
    Signals signals;
    Watched watched(state, use.turn());
    while (more()) {
      state.scene.step();
      for (auto& [sensor, history] : state.histories) history.look();
      signals.check();
      watched.between(signals);
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
  step_while(*state, [&] { return state->scene.nanoseconds() < end && state->scene.ended().empty(); });
}

}  // namespace murosimf::python
