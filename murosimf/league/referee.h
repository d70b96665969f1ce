/// referee.h - where a game's state comes from: a GameController (game_controller.h), or a referee of one's own.
#pragma once

#include <string>
#include <vector>

#include "murosimf/league/game_state.h"
#include "murosimf/model/time.h"

namespace murosimf::league {

class Referee {
 public:
  virtual ~Referee() = default;

  /// At the beginning of the tick at `now`: what it has said since the one before, in its order; mostly nothing.
  [[nodiscard]] virtual std::vector<GameState> take(Duration now) = 0;
  /// What a robot answers to each of these, if they are of version 12.
  virtual void answer(const Answer&) {}
  /// What a robot tells of itself, once per simulated second, if they are of version 18 to 20.
  virtual void report(const RobotStatus&) {}
  /// Lines about what it got and could not use, since the last call; each once in a run.
  [[nodiscard]] virtual std::vector<std::string> complaints() { return {}; }
};

}  // namespace murosimf::league
