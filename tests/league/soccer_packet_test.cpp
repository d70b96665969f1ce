// Packets of the Humanoid Soccer League's GameController against bytes that Python's struct has put together
// (tests/data/league/write_game_logs.py), and the status packet against its offsets.
#include "murosimf/league/soccer_packet.h"

#include <gtest/gtest.h>

#include <cstring>

#include "murosimf/league/game_log.h"
#include "murosimf/league/game_packet.h"
#include "tests/fixtures.h"

namespace murosimf::league {
namespace {

/// Of versions 18, 19 and 20.
std::string packet(int version) {
  static GameLog log = GameLog::read(std::string(MUROSIMF_SOURCE_DIR) + "/tests/data/league/soccer.gamelog");
  return log.channel("game").at(static_cast<std::size_t>(version - first_soccer_version)).bytes;
}

std::string with(int version, std::size_t offset, int byte) {
  std::string bytes = packet(version);
  bytes[offset] = static_cast<char>(byte);
  return bytes;
}

/// The number that version 20 has for penalty 1, 2, ... 11 of the version.
int in_version_20(int version, int penalty) {
  constexpr std::array known{0, 1, 2, 4, 5, 6, 7, 8, 9, 10, 12, 13};
  return version == 20 ? penalty : known.at(static_cast<std::size_t>(penalty));
}

TEST(SoccerPacket, HasTheSizeOfItsVersion) {
  EXPECT_EQ(packet(18).size(), 118u);
  EXPECT_EQ(packet(19).size(), 198u);
  EXPECT_EQ(packet(20).size(), 158u);
  for (const int version : {18, 19, 20}) EXPECT_EQ(packet(version).size(), soccer_bytes(version));
}

TEST(SoccerPacket, HasEveryFieldInItsPlace) {
  for (const int version : {18, 19, 20}) {
    SCOPED_TRACE(version);
    const GameState game = read_game_packet(packet(version));
    EXPECT_EQ(game.protocol, version);
    EXPECT_EQ(game.state, 2);
    EXPECT_FALSE(game.first_half);
    EXPECT_TRUE(game.stopped);
    EXPECT_EQ(game.phase, 2);
    EXPECT_EQ(game.secondary_state, 7);  // corner kick
    EXPECT_EQ(game.secondary_team, 200);
    EXPECT_EQ(game.secondary_phase, 0);
    EXPECT_EQ(game.kick_off_team, 200);
    EXPECT_EQ(game.seconds_left, -0x123);
    EXPECT_EQ(game.secondary_seconds_left, 0x456);
    EXPECT_EQ(game.teams[0].number, 9);
    EXPECT_EQ(game.teams[0].score, 3);
    EXPECT_EQ(game.teams[0].message_budget, 0x0A0B);
    EXPECT_EQ(game.teams[1].number, 200);
    EXPECT_EQ(game.teams[1].score, 17);
    EXPECT_EQ(game.teams[1].message_budget, 0x0C0D);
    for (int i = 0; i < static_cast<int>(most_players); ++i) {
      const PlayerState& player = game.teams[0].players[static_cast<std::size_t>(i)];
      EXPECT_EQ(player.penalty, in_version_20(version, 1 + i % 11));
      EXPECT_EQ(player.seconds_left, 20 + i);
      EXPECT_EQ(player.warnings, version == 19 ? 40 + i : 0);
      EXPECT_EQ(player.yellow_cards, version == 18 ? 0 : 60 + i);
      EXPECT_EQ(player.red_cards, player.penalty == static_cast<int>(SoccerPenalty::sent_off) ? 1 : 0);
      EXPECT_EQ(player.goalkeeper, i == 1);
    }
  }
}

TEST(SoccerPacket, HasSetPlaysAsSecondaryStates) {
  constexpr std::array wanted{2, 4, 5, 6, 9, 8, 7};  // none: the phase, which is overtime
  for (int play = 0; play < static_cast<int>(wanted.size()); ++play) {
    EXPECT_EQ(read_game_packet(with(20, 11, play)).secondary_state, wanted.at(static_cast<std::size_t>(play)));
  }
  EXPECT_EQ(read_game_packet(with(20, 13, 255)).kick_off_team, no_team);
}

TEST(SoccerPacket, RefusesWhatIsNone) {
  const auto refusal = [](const std::string& bytes) {
    return fixtures::error_of([&] { (void)read_game_packet(bytes); });
  };
  EXPECT_EQ(refusal(packet(19) + "x"), "a packet of 199 bytes; those of version 19 have 198");
  EXPECT_EQ(refusal(with(20, 4, 19)), "a packet of 158 bytes; those of version 19 have 198");
  EXPECT_EQ(refusal(with(20, 10, 5)), "state 5; the last one is 4");
  EXPECT_EQ(refusal(with(20, 9, 4)), "phase of the game 4; the last one is 3");
  EXPECT_EQ(refusal(with(20, 11, 7)), "set play 7; the last one is 6");
  EXPECT_EQ(refusal(with(20, 28, 14)), "penalty 14; the last one is 13");
  EXPECT_EQ(refusal(with(18, 28, 12)), "penalty 12; the last one is 11");
}

TEST(SoccerPacket, StatusHasItsFieldsInTheirPlaces) {
  const std::string bytes = to_bytes(RobotStatus{.team = 7,
                                                 .player = 20,
                                                 .fallen = true,
                                                 .x = 1.5,
                                                 .y = -0.25,
                                                 .heading = 0.5,
                                                 .ball_age = 2,
                                                 .ball_x = 3,
                                                 .ball_y = -4});
  ASSERT_EQ(bytes.size(), status_bytes);
  EXPECT_EQ(bytes.substr(0, 8), std::string("RGrt\x04\x14\x07\x01", 8));
  constexpr std::array<float, 6> wanted{1500, -250, 0.5F, 2, 3000, -4000};
  std::array<float, 6> found{};
  std::memcpy(found.data(), bytes.data() + 8, sizeof found);  // this machine is little-endian, too
  EXPECT_EQ(found, wanted);
}

}  // namespace
}  // namespace murosimf::league
