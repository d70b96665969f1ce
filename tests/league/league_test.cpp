// A game with a GameController through the whole of a scene: from recorded packets and over the loopback, what robots are told, where those
// with a penalty are, what is answered; the same again, with any number of threads, from saved states and after resets.
#include "murosimf/league/league.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <thread>

#include <fmt/format.h>

#include "murosimf/control_software/controller_task.h"
#include "murosimf/league/humanoid_packet.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene_report.h"
#include "murosimf/scene_file/scene_spec.h"
#include "murosimf/session/live_source.h"
#include "tests/fixtures.h"
#include "tests/league/until.h"
#include "tests/recording/repeatable_run.h"
#include "tests/temp_folder.h"

namespace murosimf::league {
namespace {

namespace fs = std::filesystem;

using namespace std::chrono_literals;
using Texts = std::vector<std::string>;

const std::string listener = std::string(MUROSIMF_CONTROLLERS) + "/controller_referee_listener.so";
const std::string radio = std::string(MUROSIMF_CONTROLLERS) + "/controller_radio.so";
const std::string logs = std::string(MUROSIMF_SOURCE_DIR) + "/tests/data/league/";

/// Of three_on_three with all robots played by the listener, which stand, but for more options.
scene::SceneOptions three_on_three(const Texts& more = {}, int threads = 1) {
  Texts overrides;
  for (const std::string robot : {"blue1", "blue2", "blue3", "red1", "red2", "red3"}) {
    overrides.push_back(robot + ".controller=library");
    overrides.push_back(robot + ".library=" + listener);
  }
  overrides.insert(overrides.end(), more.begin(), more.end());
  return {.threads = threads, .overrides = std::move(overrides), .cameras = false};
}

/// Blue is team 4 and attacks the right goal, red is team 21.
scene_file::SceneSpec spec_of(const scene::SceneOptions& options) {
  scene_file::SceneSpec spec =
      scene_file::read_scene(std::string(MUROSIMF_SOURCE_DIR) + "/scenes/three_on_three.toml", options.overrides);
  spec.teams[0].number = 4;
  spec.teams[1].number = 21;
  return spec;
}

fs::path written(const std::string& name, const std::string& text) {
  const fs::path file = fixtures::temp_folder() / name;
  std::ofstream(file) << text;
  return file;
}

struct Game {
  explicit Game(const scene::SceneOptions& options, const LeagueOptions& league = {.repeat = logs + "game.gamelog"})
      : Game(spec_of(options), options, league) {}
  Game(const scene_file::SceneSpec& spec, const scene::SceneOptions& options, const LeagueOptions& league)
      : scene(spec, options), game(scene, league) {}

  void run(double s) { scene.simulation().run(from_seconds(s)); }
  [[nodiscard]] Vec3d place(const std::string& robot) const {
    return scene.simulation().world().entity(robot).find(properties::position)->values[0];
  }
  [[nodiscard]] Texts said(const std::string& robot) const {
    Texts lines;
    for (const auto& message : control_software::software_report(scene.simulation().world().entity(robot))->said) {
      lines.push_back(fmt::format("{:.2f} {}", seconds(message.time), message.text));
    }
    return lines;
  }
  [[nodiscard]] Texts events() const {
    Texts lines;
    for (const Event& event : scene.simulation().events()) {
      if (event.text.starts_with("game")) lines.push_back(fmt::format("{:.3f} {}", seconds(event.time), event.text));
    }
    return lines;
  }
  [[nodiscard]] Texts warnings() const { return scene::make_report(scene, 1s, {}).warnings; }

  scene::Scene scene;
  League game;
};

// What came is in a recording of the run, which needs no other file, and no socket.
TEST(League, IsRepeatedFromARecording) {
  const fs::path scene = written("game.toml", R"(
    [field]
    size = "kid_size_2008"
    [ball]
    [[teams]]
    name = "blue"
    number = 4
    [[teams]]
    name = "red"
    number = 21
    [[robots]]
    name = "blue2"
    model = "kid21"
    team = "blue"
    controller = "walk"
    command = [0.1, 0.0, 0.1]
    [[robots]]
    name = "red1"
    model = "kid21"
    team = "red"
    position = [1.5, 0.0]
    level = "simplified_dynamics")");
  fixtures::RepeatableRun run{.scene = scene.string(),
                              .time = 7s,
                              .how = {.cameras = false, .outside = {.notes = std::make_shared<ExternalInputLog>()}}};
  run.options.state_period = 2s;
  std::optional<League> game;
  run.when_built = [&](scene::Scene& scene) {
    game.emplace(scene, LeagueOptions{.repeat = logs + "game.gamelog", .outside = scene.parts().outside});
  };
  run.play = [&](scene::Scene& scene, recording::Recorder&) {
    scene.simulation().run(7s);
    EXPECT_LT(scene.simulation().world().entity("blue2").find(properties::position)->values[0].y, -2)
        << "it has a penalty, and stands at the side line";
    game.reset();
  };
  fixtures::expect_repeatable(fixtures::record("game.mcap", run));
}

TEST(League, TellsRobotsWhatTheRefereeSays) {
  Game game(three_on_three());
  game.run(12);
  EXPECT_EQ(game.said("blue2"), (Texts{"0.20 state 0 penalty 0 kick_off 1 half 1 number 2 team 4 0:0",
                                       "1.20 state 1 penalty 0 kick_off 1 half 1 number 2 team 4 0:0",
                                       "2.20 state 2 penalty 0 kick_off 1 half 1 number 2 team 4 0:0",
                                       "3.20 state 3 penalty 0 kick_off 1 half 1 number 2 team 4 0:0",
                                       "5.20 state 3 penalty 34 kick_off 1 half 1 number 2 team 4 0:0",
                                       "8.20 state 3 penalty 34 kick_off 1 half 1 number 2 team 4 0:1",
                                       "10.20 state 3 penalty 0 kick_off 1 half 1 number 2 team 4 0:1"}));
  EXPECT_EQ(game.said("red3").back(), "8.20 state 3 penalty 0 kick_off 0 half 1 number 3 team 21 1:0");
  EXPECT_EQ(game.game.game()->words(), 24U);
  EXPECT_EQ(game.events(),
            (Texts{"0.201 game: the referee is there", "0.201 game: initial", "1.201 game: ready", "2.201 game: set",
                   "3.201 game: playing", "5.201 game: blue2: penalty, pickup/incapable", "8.201 game: blue 0, red 1",
                   "10.201 game: blue2: the penalty has ended"}));
  EXPECT_EQ(game.warnings(), Texts{});
}

TEST(League, PlacesWhoHasAPenaltyAtTheSideLine) {
  Game game(three_on_three({"ball.position=[0, 1, 0]"}));
  game.run(5.1);
  const Vec3d before = game.place("blue2");
  game.run(0.2);
  // blue attacks to the right; the ball is at positive y, so the line at negative y is the farther one
  EXPECT_LT(norm(game.place("blue2") - Vec3d{-1.2, -2.35, before.z}), 0.01);
  EXPECT_GT(norm(game.place("blue2") - before), 0.5);
  game.run(6.5);
  EXPECT_LT(norm(game.place("blue2") - Vec3d{-1.2, -2.35, before.z}), 0.05);
  Game free(three_on_three({"league.place_penalized=false"}));
  free.run(6);
  EXPECT_LT(norm(free.place("blue2") - before), 0.05);
}

TEST(League, PutsBackWhoWalksOffAndLetsItGoInTheEnd) {
  Game game(three_on_three({"blue2.options.speed=0.25"}));
  game.run(5.3);
  const double line = game.place("blue2").y;
  double farthest = 0;
  for (int i = 0; i < 46; ++i) {
    game.run(0.1);
    farthest = std::max(farthest, std::abs(game.place("blue2").y - line));
  }
  EXPECT_GT(farthest, 0.45);
  EXPECT_LT(farthest, 0.5 + 0.25 * 0.6 + 0.05);  // looked at every half second
  const double at_the_end = game.place("blue2").y;
  game.run(4);  // from 9.9 s: free from 10.2 s
  EXPECT_GT(std::abs(game.place("blue2").y - line), std::max(farthest, std::abs(at_the_end - line)) + 0.1);
}

std::uint64_t hash_after(double s, int threads) {
  Game game(three_on_three({"*.options.speed=0.1"}, threads));
  game.run(s);
  return game.scene.simulation().state_hash();
}

TEST(League, GivesTheSameStateWithAnyNumberOfThreads) {
  const std::uint64_t one = hash_after(6, 1);
  EXPECT_EQ(hash_after(6, 2), one);
  EXPECT_EQ(hash_after(6, 3), one);
}

TEST(League, BelongsToStateAndStart) {
  const auto options = three_on_three({"*.options.speed=0.1", "red.*.level=full_dynamics"});
  Game game(options);
  for (const auto begin : {5.2, 5.201, 5.4}) {  // before the penalty, when it is decided and not yet done, after it
    game.scene.reset();
    game.run(begin);
    const std::vector<std::byte> state = game.scene.save();
    game.run(7 - begin);
    const std::uint64_t there = game.scene.simulation().state_hash();
    Game other(options);
    other.scene.load(state);
    other.run(7 - begin);
    EXPECT_EQ(other.scene.simulation().state_hash(), there) << begin;
    game.scene.load(state);
    game.run(7 - begin);
    EXPECT_EQ(game.scene.simulation().state_hash(), there) << begin;
    EXPECT_EQ(game.game.game()->words(), 14U);
  }
}

TEST(League, LeavesTheRunAsItIsWhileNobodySpeaks) {
  scene::Scene alone(spec_of(three_on_three()), three_on_three());
  Game silent(three_on_three(), {.game_controller = UdpAddress{}});
  alone.simulation().run(500ms);
  silent.run(0.5);
  EXPECT_EQ(silent.scene.simulation().state_hash(), alone.simulation().state_hash());
  EXPECT_EQ(silent.events(), Texts{});
}

std::vector<std::string> packets() {
  std::vector<std::string> all;
  GameLog log = GameLog::read(logs + "game.gamelog");
  for (const auto& entry : log.channel("game")) all.push_back(entry.bytes);
  return all;
}

/// A GameController on the loopback.
struct Controller {
  explicit Controller(const Game& game)
      : out({.listen = {}, .send_to = UdpAddress{"127.0.0.1", game.game.game_controller_port()}}) {}
  UdpPort out;
};

std::string answer_port_of(const UdpPort& port) { return "league.answer_port=" + std::to_string(port.port()); }

/// Runs until `words` of the referee have been heard; false if that takes too long.
bool run_until(Game& game, std::uint64_t words) {
  for (int i = 0; i < 5000 && game.game.game()->words() < words; ++i) {
    game.run(0.001);
    std::this_thread::sleep_for(1ms);
  }
  return game.game.game()->words() >= words;
}

TEST(League, PlaysOverUdpAndAnswers) {
  UdpPort answers({});
  Game game(three_on_three({answer_port_of(answers), "red2.options.answers=4", "blue3.present=false"}),
            {.game_controller = UdpAddress{}});
  Controller controller(game);
  controller.out.give(packets()[12]);
  ASSERT_TRUE(run_until(game, 1));
  const std::string alive = "\x02";
  EXPECT_EQ(all_of(answers, 5),
            (Texts{"RGrt\x02\x04\x01" + alive, "RGrt\x02\x04\x02" + alive, "RGrt\x02\x15\x01" + alive,
                   "RGrt\x02\x15\x02" + alive, "RGrt\x02\x15\x03" + alive}));
  game.run(0.02);  // red2's software has said something else by now
  controller.out.give(packets()[12]);
  ASSERT_TRUE(run_until(game, 2));
  EXPECT_EQ(all_of(answers, 5)[3], "RGrt\x02\x15\x02\x04");
}

TEST(League, RepeatsARunFromItsRecord) {
  Game game(three_on_three({"*.options.speed=0.1"}), {.game_controller = UdpAddress{}});
  Controller controller(game);
  std::uint64_t words = 0;
  for (const std::size_t number : {0, 3, 5, 7, 11, 12, 17, 21}) {
    controller.out.give(packets()[number]);
    ASSERT_TRUE(run_until(game, ++words));
    game.run(0.0137);
  }
  const fs::path file = written("mine.gamelog", game.game.log().to_text());
  Game again(three_on_three({"*.options.speed=0.1"}), {.repeat = file});
  again.scene.simulation().run(game.scene.simulation().now());
  EXPECT_EQ(again.scene.simulation().state_hash(), game.scene.simulation().state_hash());
  EXPECT_EQ(again.events(), game.events());
  EXPECT_EQ(again.game.log().to_text(), game.game.log().to_text());
}

// The referee, robots and teams are not asked again, and hear nothing of it.
TEST(League, GoingBackInTimeAnswersFromWhatHadCome) {
  UdpPort answers({});
  Game game(three_on_three({answer_port_of(answers)}), {.game_controller = UdpAddress{}});
  Controller controller(game);
  session::LiveSource course(game.scene);
  course.begin();
  const auto go_on_until = [&](Duration time) {
    while (game.scene.simulation().now() < time) course.step();
  };
  const auto hear = [&](std::size_t number) {
    const std::uint64_t before = game.game.game()->words();
    controller.out.give(packets()[number]);
    for (int i = 0; i < 5000 && game.game.game()->words() == before; ++i) {
      course.step();
      std::this_thread::sleep_for(1ms);
    }
    ASSERT_EQ(game.game.game()->words(), before + 1);
  };
  hear(3);
  const Duration first = game.scene.simulation().now() + 300ms;
  go_on_until(first);
  const std::vector<std::byte> then = game.scene.save();
  hear(12);
  const Duration second = game.scene.simulation().now() + 700ms;
  go_on_until(second);
  const std::vector<std::byte> last = game.scene.save();
  const std::uint64_t words = game.game.game()->words();
  (void)all_of(answers, 12);
  for (const Duration time : {first, second, first, second}) {
    course.seek(time, {}, [] { return false; });
    EXPECT_TRUE(game.scene.save() == (time == first ? then : last));
    EXPECT_EQ(game.game.game()->words(), time == first ? words - 1 : words);
  }
  EXPECT_EQ(answers.take({}), Texts{}) << "no request is answered twice";
  EXPECT_EQ(course.diagnostic(), "");
  course.seek(first, {}, [] { return false; });
  EXPECT_TRUE(
      fixtures::says(course.diagnostic(), {"software of ", "and the GameController keep their own state: from "}));
}

TEST(League, TellsOnceWhatItCannotUse) {
  Game game(three_on_three(), {.game_controller = UdpAddress{}});
  Controller controller(game);
  std::string old = packets()[0], strange = packets()[0];
  old[4] = 11;
  strange[24] = 99;  // the number of a team
  for (int i = 0; i < 3; ++i) {
    for (const std::string& bytes : {std::string("hello"), old, packets()[0].substr(0, 100), strange}) {
      controller.out.give(bytes);
    }
    game.run(0.01);
    std::this_thread::sleep_for(20ms);
  }
  controller.out.give(packets()[0]);
  ASSERT_TRUE(run_until(game, 1));
  game.run(0.01);
  const Texts warnings = game.warnings();  // those of one tick in any order
  EXPECT_EQ(
      std::set(warnings.begin(), warnings.end()),
      (std::set<std::string>{
          "GameController: this is no packet of a GameController: it does not begin with RGme; ignored",
          "GameController: version 11 of the GameController's packets; known are 12 of the Humanoid League, 18 to 20 "
          "of the "
          "Humanoid Soccer League; ignored",
          "GameController: a packet of 100 bytes; those of version 12 have 688; ignored",
          "the referee has the teams 99 and 4, the scene has blue (number 4) and red (number 21); what it says is "
          "ignored"}));
  EXPECT_EQ(warnings.size(), 4U);
}

TEST(League, DoesNotFillTheReportWithNoise) {
  Game game(three_on_three(), {.game_controller = UdpAddress{}});
  Controller controller(game);
  const std::string good = packets()[0];
  for (std::size_t length = 24; length < 124; ++length) {
    controller.out.give(good.substr(0, length));
    game.run(0.001);
  }
  controller.out.give(good);
  ASSERT_TRUE(run_until(game, 1));
  game.run(0.01);
  EXPECT_EQ(game.warnings().size(), 10U);
}

TEST(League, TakesTeamsInTheirOrderIfTheyHaveNoNumbers) {
  const scene::SceneOptions options = three_on_three();
  scene_file::SceneSpec spec = spec_of(options);
  spec.teams[0].number = spec.teams[1].number = 0;
  Game game(spec, options, {.repeat = logs + "game.gamelog"});
  game.run(0.3);
  EXPECT_EQ(game.said("blue1"), Texts{"0.20 state 0 penalty 0 kick_off 0 half 1 number 1 team 21 0:0"});
}

/// A referee of one's own.
class OwnReferee final : public Referee {
 public:
  std::vector<GameState> take(Duration now) override {
    if (now != Duration(100ms)) return {};
    GameState game{.state = 3, .kick_off_team = 21};
    game.teams[0].number = 4;
    game.teams[1].number = 21;
    return {game};
  }
  void answer(const Answer& answer) override { answers.push_back(answer); }
  std::vector<Answer> answers;
};

TEST(League, HasRoomForARefereeOfOnesOwn) {
  OwnReferee referee;
  Game game(three_on_three(), {.referee = &referee});
  game.run(0.2);
  EXPECT_EQ(game.said("red1"), Texts{"0.10 state 3 penalty 0 kick_off 1 half 1 number 1 team 21 0:0"});
  EXPECT_EQ(referee.answers.size(), 6U);
}

TEST(League, RefusesScenesThatAreNoGame) {
  const auto refusal = [](const scene_file::SceneSpec& spec, const LeagueOptions& options) {
    return fixtures::error_of([&] {
      scene::Scene scene(spec, {.cameras = false});
      League game(scene, options);
    });
  };
  const scene_file::SceneSpec spec = spec_of({});
  const LeagueOptions game{.game_controller = UdpAddress{}};
  scene_file::SceneSpec no_teams = spec, no_number = spec, same_number = spec;
  no_teams.teams.clear();
  for (scene_file::RobotSpec& robot : no_teams.robots) robot.team.clear();
  no_number.robots[0].name = "keeper";
  same_number.robots[0].name = "azure2";
  EXPECT_EQ(refusal(no_teams, game), "a game has two teams, but the scene has 0");
  EXPECT_EQ(refusal(no_number, game),
            "in a game a robot has a number from 1 to 20 at the end of its name; 'keeper' has none");
  EXPECT_EQ(refusal(same_number, game), "azure2 and blue2 of one team have the same number");
  EXPECT_TRUE(fixtures::says(refusal(spec, {.repeat = "nosuch.gamelog"}), {"nosuch.gamelog"}));
  const TeamLink link{"blue", {}, {"127.0.0.1", 1}};
  EXPECT_EQ(refusal(spec, {.team_links = {link}}),
            "no robot's software sends messages, so there are none of team 'blue' for a socket");
}

TEST(TeamLink, IsTeamAndTwoAddresses) {
  const TeamLink link = TeamLink::parse("blue=10001,10.0.0.7:10002");
  EXPECT_EQ(link.team, "blue");
  EXPECT_EQ(link.listen, (UdpAddress{"127.0.0.1", 10001}));
  EXPECT_EQ(link.send_to, (UdpAddress{"10.0.0.7", 10002}));
  for (const std::string wrong : {"blue", "blue=1", "1,2", ",=1"}) {
    EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { (void)TeamLink::parse(wrong); }), {"write TEAM=LISTEN,SEND"}))
        << wrong;
  }
  EXPECT_EQ(fixtures::error_of([] { (void)TeamLink::parse("blue=7,7"); }), "'blue=7,7' sends messages back to itself");
}

scene::SceneOptions talking(const Texts& more) {
  Texts overrides{"blue1.options.every=5", "red1.options.every=5"};
  for (const std::string robot : {"blue1", "blue2", "blue3", "red1", "red2", "red3"}) {
    overrides.insert(overrides.begin(), {robot + ".controller=library", robot + ".library=" + radio});
  }
  for (const std::string robot : {"blue2", "blue3", "red2", "red3"}) overrides.push_back(robot + ".options.every=0");
  overrides.insert(overrides.end(), more.begin(), more.end());
  return {.overrides = overrides, .cameras = false};
}

TEST(TeamForwarder, CarriesMessagesToSocketsAndBack) {
  UdpPort outside({});
  const TeamLink link{"blue", {}, {"127.0.0.1", outside.port()}};
  Game game(talking({"blue.*.options.says=true", "communication.loss=1"}), {.team_links = {link}});
  game.run(0.45);
  EXPECT_EQ(all_of(outside, 5), (Texts{"AAAAAAAA", "FFFFFFFF", "KKKKKKKK", "PPPPPPPP", "UUUUUUUU"}));
  EXPECT_EQ(outside.take({}), Texts{}) << "the other team has no socket";
}

TEST(TeamForwarder, DeliversWhatComesFromOutsideToTheWholeTeam) {
  const fs::path file = written("team.gamelog", "MuRoSimF game log 1\n110000000 team:blue 48656c6c6f\n");
  Game game(talking({"*.options.every=0", "*.options.says=true"}), {.repeat = file});
  game.run(0.2);
  for (const std::string robot : {"blue1", "blue2", "blue3"})
    EXPECT_EQ(game.said(robot), Texts{"0.12  110 120 5"}) << robot;
  for (const std::string robot : {"red1", "red2", "red3"}) EXPECT_EQ(game.said(robot), Texts{}) << robot;
  EXPECT_EQ(game.game.log().to_text(), "MuRoSimF game log 1\n110000000 team:blue 48656c6c6f\n");
}

/// The game of soccer.gamelog: ready at 0.2 s, set at 0.7, playing at 1.2, stopped at 2.2, playing at 3.2 with a penalty of blue2.
TEST(League, BuiltInControllersStandWhileNobodyMayMove) {
  Game game({.cameras = false}, {.repeat = logs + "soccer.gamelog"});
  const auto number = [&](const std::string& robot, const auto& property) {
    return game.scene.simulation().world().entity(robot).find(property)->values[0];
  };
  const auto expect_halted = [&](double time, double blue2, double others) {
    game.run(time - seconds(game.scene.simulation().now()));
    EXPECT_EQ(number("blue2", properties::halted), blue2) << time;
    for (const char* robot : {"blue1", "blue3", "red1", "red2", "red3"}) {
      EXPECT_EQ(number(robot, properties::halted), others) << robot << " at " << time;
    }
  };
  expect_halted(0.1, 0, 0);  // no referee yet
  expect_halted(0.3, 1, 1);
  expect_halted(1.1, 1, 1);
  EXPECT_EQ(number("red1", properties::gait_amplitude), 0);
  expect_halted(2.0, 0, 0);
  EXPECT_GT(number("red1", properties::gait_amplitude), 0);
  expect_halted(2.4, 1, 1);
  expect_halted(3.4, 1, 0);
  EXPECT_NEAR(std::abs(game.place("blue2").y), 2.35, 0.05) << "pick-up: at the side line";
}

/// One word of version 20 at the start; keeps what robots tell.
struct Listener final : Referee {
  std::vector<GameState> take(Duration now) override {
    time = now;
    GameState playing{.protocol = 20, .state = 3};
    playing.teams[0].number = 21;
    playing.teams[1].number = 4;
    return now == Duration{} ? std::vector{playing} : std::vector<GameState>{};
  }
  void answer(const Answer&) override { ++answers; }
  void report(const RobotStatus& status) override { told.emplace_back(seconds(time), status); }

  Duration time{};
  int answers = 0;
  std::vector<std::pair<double, RobotStatus>> told;
};

TEST(League, RobotsTellOfThemselvesOncePerSecond) {
  Listener referee;
  Game game(three_on_three({"red2.present=false"}), {.referee = &referee});
  game.run(0.001);
  const Vec3d blue1 = game.place("blue1"), red1 = game.place("red1");
  game.run(2.5);
  EXPECT_EQ(referee.answers, 0);
  ASSERT_EQ(referee.told.size(), 15U);
  const auto& [time, blue] = referee.told[0];
  EXPECT_EQ(time, 0);
  EXPECT_EQ(blue.team, 4);
  EXPECT_EQ(blue.player, 1);
  EXPECT_FALSE(blue.fallen);
  EXPECT_NEAR(blue.x, blue1.x, 0.01);
  EXPECT_NEAR(blue.y, blue1.y, 0.01);
  EXPECT_EQ(blue.ball_age, 0);
  const RobotStatus& red = referee.told[3].second;  // attacks the other goal: its field is turned
  EXPECT_EQ(red.team, 21);
  EXPECT_NEAR(red.x, -red1.x, 0.01);
  EXPECT_NEAR(red.y, -red1.y, 0.01);
  EXPECT_EQ(referee.told[5].first, 1);
  EXPECT_EQ(referee.told[14].first, 2);
}

}  // namespace
}  // namespace murosimf::league
