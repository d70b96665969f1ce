/// referee.h - source of a game's state: a GameController (game_controller.h), or a referee of one's own.
#pragma once

#include <string>
#include <vector>

#include "murosimf/league/game_state.h"
#include "murosimf/world/time.h"

namespace murosimf::league {

class Referee {
 public:
  virtual ~Referee() = default;

  /// At the beginning of the tick at `now`: messages since the last call, in order; usually none.
  [[nodiscard]] virtual std::vector<GameState> take(Duration now) = 0;
  /// Answer of a robot to each of these, if they are of version 12.
  virtual void answer(const Answer&) {}
  /// Status of a robot, once per simulated second, if they are of version 18 to 20.
  virtual void report(const RobotStatus&) {}
  /// Lines about invalid input, since the last call; each once in a run.
  [[nodiscard]] virtual std::vector<std::string> complaints() { return {}; }
};

}  // namespace murosimf::league
