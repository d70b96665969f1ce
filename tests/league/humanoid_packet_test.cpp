// Packets of the GameController against bytes that Python's struct has put together (tests/data/league/write_game_logs.py).
#include "murosimf/league/humanoid_packet.h"

#include <gtest/gtest.h>

#include "murosimf/league/game_log.h"
#include "murosimf/league/game_packet.h"
#include "tests/fixtures.h"

namespace murosimf::league {
namespace {

const std::string folder = std::string(MUROSIMF_SOURCE_DIR) + "/tests/data/league/";

std::string packet() { return GameLog::read(folder + "fields.gamelog").channel("game").at(0).bytes; }

std::string with(std::size_t offset, int byte) {
  std::string bytes = packet();
  bytes[offset] = static_cast<char>(byte);
  return bytes;
}

std::string refusal(const std::string& bytes) {
  const std::string message = fixtures::error_of([&] { (void)read_game_packet(bytes); });
  EXPECT_EQ(message.find('\n'), std::string::npos);
  return message;
}

TEST(HumanoidPacket, HasEveryFieldInItsPlace) {
  const GameState game = read_game_packet(packet());
  EXPECT_EQ(game.state, 2);
  EXPECT_FALSE(game.first_half);
  EXPECT_EQ(game.kick_off_team, 200);
  EXPECT_EQ(game.secondary_state, 6);
  EXPECT_EQ(game.secondary_team, 9);
  EXPECT_EQ(game.secondary_phase, 1);
  EXPECT_EQ(game.seconds_left, 0x123);
  EXPECT_EQ(game.secondary_seconds_left, 0x456);
  EXPECT_EQ(game.teams[0].number, 9);
  EXPECT_EQ(game.teams[0].score, 3);
  EXPECT_EQ(game.teams[1].number, 200);
  EXPECT_EQ(game.teams[1].score, 17);
  for (std::size_t i = 0; i < humanoid_players; ++i) {
    const PlayerState& player = game.teams[0].players[i];
    EXPECT_EQ(player.penalty, 30 + i);
    EXPECT_EQ(player.seconds_left, 40 + i);
    EXPECT_EQ(player.warnings, 50 + i);
    EXPECT_EQ(player.yellow_cards, 60 + i);
    EXPECT_EQ(player.red_cards, 70 + i);
    EXPECT_EQ(player.goalkeeper, i % 2 == 1);
    EXPECT_EQ(game.teams[1].players[i].penalty, 40 - i);  // the other way round
  }
}

TEST(HumanoidPacket, KnowsADroppedBallAndNoFreeKick) {
  for (const int no_team_number : {255, 128})
    EXPECT_EQ(read_game_packet(with(11, no_team_number)).kick_off_team, no_team);
  EXPECT_EQ(read_game_packet(with(12, 0)).secondary_team, no_team);
}

TEST(HumanoidPacket, RefusesWhatIsNone) {
  EXPECT_EQ(refusal(""), "this is no packet of a GameController: it does not begin with RGme");
  EXPECT_EQ(refusal("RGmf"), "this is no packet of a GameController: it does not begin with RGme");
  EXPECT_EQ(refusal(packet().substr(0, 23)), "a packet of 23 bytes, too short for any GameController");
  EXPECT_EQ(refusal(packet().substr(0, 687)), "a packet of 687 bytes; those of version 12 have 688");
  EXPECT_EQ(refusal(packet() + "x"), "a packet of 689 bytes; those of version 12 have 688");
  EXPECT_EQ(refusal(with(4, 11)),
            "version 11 of the GameController's packets; known are 12 of the Humanoid League, 18 to 20 of the Humanoid "
            "Soccer League");
  EXPECT_EQ(refusal(with(4, 21)),
            "version 21 of the GameController's packets; known are 12 of the Humanoid League, 18 to 20 of the Humanoid "
            "Soccer League");
  EXPECT_EQ(refusal(with(9, 5)), "state 5; the last one is 4");
  EXPECT_EQ(refusal(with(12, 10)), "secondary state 10; the last one is 9");
}

TEST(HumanoidPacket, Answers) {
  EXPECT_EQ(to_bytes({.team = 200, .player = 3, .message = 4}), std::string("RGrt\x02\xc8\x03\x04", 8));
}

}  // namespace
}  // namespace murosimf::league
