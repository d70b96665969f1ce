/// game_view.h - the game as one robot receives it: the referee's last message, relative to the robot's team.
///
/// A referee (league/) writes it; control software reads it by name (game_signals.h).
#pragma once

#include <array>
#include <cstdint>

#include "murosimf/model/property.h"
#include "murosimf/model/value.h"
#include "murosimf/world/time.h"

namespace murosimf::control_software {

/// Numbers of states and penalties: docs/game.md.
struct GameView {
  std::int64_t time = 0;      ///< [ns] simulated, of the last message
  std::uint64_t samples = 0;  ///< messages so far; 0: none yet
  double state = 0;           ///< 0 initial, 1 ready, 2 set, 3 playing, 4 finished
  double secondary_state = 0;
  double secondary_team = -1;  ///< 1 own, 0 the other, -1 none: which team has the free kick, timeout, ...
  double secondary_phase = 0;
  double half = 1;                                ///< 1 or 2
  double kick_off = -1;                           ///< 1 own, 0 the other, -1 none: dropped ball
  double remaining = 0, secondary_remaining = 0;  ///< [s]
  double stopped = 0;                             ///< 1: all robots must stand still
  double phase = 0;                               ///< 0 normal, 1 penalty shoot-out, 2 overtime, 3 timeout
  double message_budget = -1;                     ///< messages that the own team may still send; -1: unknown
  double version = 0;                             ///< of the referee's packets: 12, 18, 19, 20; 0: none yet
  double penalty = 0;                             ///< of the robot; 0: none
  double penalty_remaining = 0;                   ///< [s]
  double team = 0, number = 0;                    ///< as the referee has them
  std::array<double, 2> score{};                  ///< own, the other team's
  std::array<double, 3> cards{};                  ///< of the robot: warnings, yellow, red
};

void append_hash(Hasher& hasher, const GameView& view);

inline constexpr Property<GameView> game_view{
    {"game_view", "-", "-", "the game as the robot's software is told of it", Scope::base}};
/// Answer of the robot's software to the referee.
inline constexpr Property<double> game_answer{
    {"game_answer", "1", "-",
     "message to the GameController: 0 penalized by hand, 1 not any more, 2 alive, 3 goalkeeper, 4 ready",
     Scope::base}};
inline constexpr double answer_alive = 2, highest_answer = 4;

}  // namespace murosimf::control_software
