// Records of what came from outside: as text and back, what is refused, and what a run gets of them.
#include "murosimf/league/game_log.h"

#include <gtest/gtest.h>

#include "tests/fixtures.h"

namespace murosimf::league {
namespace {

using namespace std::chrono_literals;
using Texts = std::vector<std::string>;

/// Gives what it was told to give, at the next take().
class Given final : public Datagrams {
 public:
  std::vector<std::string> take(Duration) override { return std::exchange(next, {}); }
  void give(std::string_view bytes) override { given.emplace_back(bytes); }
  Texts next, given;
};

std::string refusal(const std::string& text) {
  return fixtures::error_of([&] { (void)GameLog::parse(text, "a.gamelog"); });
}

const std::string first = "MuRoSimF game log 1\n";

TEST(GameLog, ComesBackAsItWas) {
  GameLog log;
  log.channel("game") = {{1ms, std::string("\x00\xff\x0a", 3)}, {5ms, ""}};
  log.channel("team:blue") = {{1ms, "hello"}, {2ms, "you"}};
  const std::string text = log.to_text();
  EXPECT_EQ(text,
            first + "1000000 game 00ff0a\n1000000 team:blue 68656c6c6f\n2000000 team:blue 796f75\n5000000 game \n");
  GameLog again = GameLog::parse(text, "a");
  EXPECT_EQ(again.channel("game"), log.channel("game"));
  EXPECT_EQ(again.channel("team:blue"), log.channel("team:blue"));
  EXPECT_TRUE(again.channel("team:red").empty());
}

TEST(GameLog, RefusesLinesThatAreNone) {
  EXPECT_EQ(refusal(""), "a.gamelog:1: this is no game log: 'MuRoSimF game log 1'");
  EXPECT_EQ(refusal("time\n"), "a.gamelog:1: this is no game log: 'MuRoSimF game log 1'");
  EXPECT_EQ(refusal(first + "1 game 00\n1.5 game 00\n"), "a.gamelog:3: '1.5' is no time in whole nanoseconds");
  EXPECT_EQ(refusal(first + "-1 game 00\n"), "a.gamelog:2: '-1' is no time in whole nanoseconds");
  EXPECT_EQ(refusal(first + "99999999999999999999 game 00\n"),
            "a.gamelog:2: '99999999999999999999' is no time in whole nanoseconds");
  EXPECT_EQ(refusal(first + "\n"), "a.gamelog:2: '' is no time in whole nanoseconds");
  EXPECT_EQ(refusal(first + "1\n"), "a.gamelog:2: a line has a time, its sender and bytes");
  EXPECT_EQ(refusal(first + "1 game 0\n"), "a.gamelog:2: half of a byte");
  EXPECT_EQ(refusal(first + "1 game 0G\n"), "a.gamelog:2: bytes must be hexadecimal digits, 0 to 9 and a to f");
  EXPECT_EQ(refusal(first + "2 game 00\n1 team:a 00\n1 game 00\n"), "a.gamelog:4: this is before the line above");
}

TEST(GameLog, GivesARunWhatCameThen) {
  GameLog log;
  log.channel("game") = {{0ms, "a"}, {10ms, "b"}, {10ms, "c"}, {30ms, "d"}};
  RepeatedDatagrams repeated(log, "game", 10ms);
  for (int i = 0; i < 2; ++i) {  // also a second time, after a reset
    EXPECT_EQ(repeated.take(0ms), Texts{"a"});
    EXPECT_EQ(repeated.take(10ms), (Texts{"b", "c"}));
    EXPECT_EQ(repeated.take(20ms), Texts{});
    EXPECT_EQ(repeated.take(30ms), Texts{"d"});
  }
  EXPECT_EQ(repeated.take(12ms), (Texts{"b", "c"}));  // steps of another run need not be where these were
}

TEST(GameLog, IsWrittenWhileARunGoesBackAndForth) {
  GameLog log;
  Given source;
  RecordedDatagrams recorded(source, log, "game");
  source.next = {"a"};
  EXPECT_EQ(recorded.take(0ms), Texts{"a"});
  source.next = {"b"};
  EXPECT_EQ(recorded.take(10ms), Texts{"b"});
  source.next = {"c"};
  EXPECT_EQ(recorded.take(10ms), Texts{"c"});  // from a state of 10 ms: what had come there has not
  source.next = {"d"};
  EXPECT_EQ(recorded.take(20ms), Texts{"d"});
  EXPECT_EQ(log.channel("game"), (std::vector<GameLog::Entry>{{0ms, "a"}, {10ms, "c"}, {20ms, "d"}}));
  recorded.give("x");
  EXPECT_EQ(source.given, Texts{"x"});
}

}  // namespace
}  // namespace murosimf::league
