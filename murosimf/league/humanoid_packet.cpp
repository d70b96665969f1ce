#include "murosimf/league/humanoid_packet.h"

#include <fmt/format.h>

#include "murosimf/league/packet_bytes.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::league {
namespace {

constexpr std::string_view answer_magic = "RGrt";
constexpr int answer_version = 2;
constexpr int drop_ball = 255, drop_ball_of_old = 128;  // as team that kicks off
constexpr int last_secondary_state = 9;
constexpr std::size_t first_team = 24, bytes_of_team = 332, first_player = 266, bytes_of_player = 6;

PlayerState player(const PacketBytes& bytes) {
  return {.penalty = bytes.one(0),
          .seconds_left = bytes.one(1),
          .warnings = bytes.one(2),
          .yellow_cards = bytes.one(3),
          .red_cards = bytes.one(4),
          .goalkeeper = bytes.one(5) != 0};
}

TeamState team(const PacketBytes& bytes) {
  TeamState team{.number = bytes.one(0), .score = bytes.one(2)};
  for (std::size_t i = 0; i < humanoid_players; ++i)
    team.players[i] = player(bytes.from(first_player + i * bytes_of_player));
  return team;
}

}  // namespace

GameState read_humanoid_packet(std::string_view packet) {
  if (packet.size() != humanoid_bytes) {
    throw SetupError(fmt::format("a packet of {} bytes; those of version {} have {}", packet.size(), humanoid_version,
                                 humanoid_bytes));
  }
  const PacketBytes bytes(packet);
  GameState game{.protocol = humanoid_version,
                 .state = checked(bytes.one(9), last_game_state, "state"),
                 .first_half = bytes.one(10) != 0,
                 .kick_off_team = bytes.one(11),
                 .secondary_state = checked(bytes.one(12), last_secondary_state, "secondary state"),
                 .secondary_phase = bytes.one(14),
                 .seconds_left = bytes.two(20),
                 .secondary_seconds_left = bytes.two(22)};
  for (std::size_t i = 0; i < 2; ++i) game.teams[i] = team(bytes.from(first_team + i * bytes_of_team));
  if (game.kick_off_team == drop_ball || game.kick_off_team == drop_ball_of_old) game.kick_off_team = no_team;
  if (game.secondary_state > 2) game.secondary_team = bytes.one(13);  // lower ones belong to no team
  if (game.secondary_state < 4) game.phase = game.secondary_state;
  return game;
}

std::string to_bytes(const Answer& answer) {
  std::string bytes(answer_magic);
  for (const int byte : {answer_version, answer.team, answer.player, answer.message}) {
    bytes.push_back(static_cast<char>(byte));
  }
  MUROSIMF_ASSERT(bytes.size() == 8);
  return bytes;
}

}  // namespace murosimf::league
