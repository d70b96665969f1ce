#include "murosimf/league/soccer_packet.h"

#include <array>
#include <bit>
#include <cstdint>

#include <fmt/format.h>

#include "murosimf/league/packet_bytes.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::league {
namespace {

constexpr std::size_t head_bytes = 18, team_head_bytes = 10;
constexpr int no_kick_off = 255, last_phase = 3;
constexpr std::string_view status_magic = "RGrt";
constexpr int status_version = 4;
constexpr double mm = 1000;  // [mm/m]

/// Set plays of these packets (none, direct and indirect free kick, penalty kick, throw-in, goal kick, corner kick) as secondary states.
constexpr std::array set_plays{0, 4, 5, 6, 9, 8, 7};
/// Penalties of versions 18 and 19 by the numbers of version 20: "motion in stop" and "cautioned" are new there.
constexpr std::array<std::uint8_t, 12> old_penalties{0, 1, 2, 4, 5, 6, 7, 8, 9, 10, 12, 13};

std::size_t player_bytes(int version) noexcept { return version == 18 ? 2 : version == 19 ? 4 : 3; }
std::size_t team_bytes(int version) noexcept { return team_head_bytes + most_players * player_bytes(version); }

std::uint8_t penalty_of(int number, int version) {
  if (version == last_soccer_version) {
    return static_cast<std::uint8_t>(checked(number, static_cast<int>(SoccerPenalty::substitute), "penalty"));
  }
  // checked first: the table has one entry for each number
  return old_penalties[static_cast<std::size_t>(checked(number, old_penalties.size() - 1, "penalty"))];
}

/// Versions differ in which bytes a player has.
PlayerState player(const PacketBytes& bytes, int version) {
  PlayerState player{.penalty = penalty_of(bytes.one(0), version), .seconds_left = bytes.one(1)};
  if (version == 19) {
    player.warnings = bytes.one(2);
    player.yellow_cards = bytes.one(3);
  } else if (version == 20) {
    player.yellow_cards = bytes.one(2);
  }
  if (player.penalty == static_cast<int>(SoccerPenalty::sent_off)) player.red_cards = 1;
  return player;
}

TeamState team(const PacketBytes& bytes, int version) {
  TeamState team{.number = bytes.one(0), .score = bytes.one(4), .message_budget = bytes.two(8)};
  for (std::size_t i = 0; i < most_players; ++i) {
    team.players[i] = player(bytes.from(team_head_bytes + i * player_bytes(version)), version);
    team.players[i].goalkeeper = bytes.one(3) == i + 1;
  }
  return team;
}

void append_float(std::string& bytes, double value) {
  static_assert(sizeof(float) == sizeof(std::uint32_t));
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(bits >> shift & 255u));
}

}  // namespace

std::size_t soccer_bytes(int version) noexcept { return head_bytes + 2 * team_bytes(version); }

/// The size is checked first: all offsets below follow from the version.
GameState read_soccer_packet(std::string_view packet) {
  const PacketBytes bytes(packet);
  const int version = bytes.one(4);
  if (packet.size() != soccer_bytes(version)) {
    throw SetupError(fmt::format("a packet of {} bytes; those of version {} have {}", packet.size(), version,
                                 soccer_bytes(version)));
  }
  const int set_play = checked(bytes.one(11), set_plays.size() - 1, "set play");
  GameState game{.protocol = version,
                 .state = checked(bytes.one(10), last_game_state, "state"),
                 .first_half = bytes.one(12) != 0,
                 .stopped = bytes.one(8) != 0,
                 .phase = checked(bytes.one(9), last_phase, "phase of the game"),
                 .kick_off_team = bytes.one(13),
                 .seconds_left = bytes.signed_two(14),
                 .secondary_seconds_left = bytes.signed_two(16)};
  if (game.kick_off_team == no_kick_off) game.kick_off_team = no_team;
  game.secondary_state = set_play == 0 ? game.phase : set_plays[static_cast<std::size_t>(set_play)];
  if (set_play != 0) {
    game.secondary_team = game.kick_off_team;
    game.secondary_phase = game.stopped ? 0 : 2;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    game.teams[i] = team(bytes.from(head_bytes + i * team_bytes(version)), version);
  }
  return game;
}

std::string to_bytes(const RobotStatus& status) {
  std::string bytes(status_magic);
  for (const int byte : {status_version, status.player, status.team, status.fallen ? 1 : 0}) {
    bytes.push_back(static_cast<char>(byte));
  }
  for (const double value :
       {mm * status.x, mm * status.y, status.heading, status.ball_age, mm * status.ball_x, mm * status.ball_y}) {
    append_float(bytes, value);
  }
  MUROSIMF_ASSERT(bytes.size() == 32);
  return bytes;
}

}  // namespace murosimf::league
