/// game_state.h - a soccer game as its referee sees it, for any referee: state, teams, penalties, score, clock.
///
/// Numbers of states are those of the Humanoid League's GameController, version 12 (humanoid_packet.h); so are penalties from such packets. Of
/// the Humanoid Soccer League's GameController, penalties have the numbers of version 20 (soccer_packet.h). No number is in both.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace murosimf::league {

inline constexpr std::size_t most_players = 20;  ///< of a team, numbered from 1
inline constexpr int no_team = -1;

struct PlayerState {
  std::uint8_t penalty = 0;       ///< 0: none
  std::uint8_t seconds_left = 0;  ///< [s] of the penalty
  std::uint8_t warnings = 0, yellow_cards = 0, red_cards = 0;
  bool goalkeeper = false;
};

struct TeamState {
  int number = 0;
  int score = 0;
  int message_budget = -1;  ///< messages that the team may still send; -1: unknown
  std::array<PlayerState, most_players> players{};
};

struct GameState {
  int protocol = 12;  ///< version of the packet: 12, or 18 to 20
  int state = 0;      ///< 0 initial, 1 ready, 2 set, 3 playing, 4 finished
  bool first_half = true;
  bool stopped = false;         ///< all robots must stand still (version 20; never so in version 12)
  int phase = 0;                ///< 0 normal, 1 penalty shoot-out, 2 overtime, 3 timeout
  int kick_off_team = no_team;  ///< number of the team; none: dropped ball
  /// 0 normal, 1 penalty shoot-out, 2 overtime, 3 timeout, 4 direct and 5 indirect free kick, 6 penalty kick, 7 corner kick, 8 goal
  /// kick, 9 throw-in
  int secondary_state = 0;
  int secondary_team = no_team;
  int secondary_phase = 0;
  int seconds_left = 0, secondary_seconds_left = 0;  ///< [s]
  std::array<TeamState, 2> teams{};
};

/// Answer of a robot to a packet of version 12.
struct Answer {
  int team = 0, player = 0;  ///< numbers
  int message =
      2;  ///< 0 penalized by hand, 1 penalty lifted by hand, 2 alive, 3 goalkeeper, 4 ready after an interruption
};

/// Status that a robot sends to a GameController of version 18 to 20, once per second.
struct RobotStatus {
  int team = 0, player = 0;          ///< numbers
  bool fallen = false;               ///< it cannot play
  double x = 0, y = 0, heading = 0;  ///< [m, m, rad] on the field, with +x in the direction of the robot's attack
  double ball_age = -1;              ///< [s] since the ball was seen; -1: never
  double ball_x = 0, ball_y = 0;     ///< [m] of the ball in the robot's frame: x forward, y left
};

}  // namespace murosimf::league
