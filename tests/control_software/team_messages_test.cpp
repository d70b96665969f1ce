// Messages between robots of a team, through the whole of a scene: which robots get them, when, how many; the same with any number of threads, from
// saved states and after resets.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdio>

#include "murosimf/control_software/controller_task.h"
#include "murosimf/control_software/message_exchange.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"
#include "tests/fixtures.h"

namespace murosimf::control_software {
namespace {

using namespace std::chrono_literals;

const std::string library = std::string(MUROSIMF_CONTROLLERS) + "/controller_radio.so";

// Libraries of version 1 know the robot up to here.
static_assert(offsetof(murosimf_robot, use_messages) == offsetof(murosimf_robot, say) + sizeof(void*));
static_assert(offsetof(murosimf_robot, say) == 13 * sizeof(void*));

/// three_on_three, all six with the library: positions (-2.4, 0.2), ... of the file.
scene::SceneOptions six(const std::vector<std::string>& more, int threads = 1) {
  std::vector<std::string> overrides{"start.jitter_position=0", "red.*.level=kinematic_walking"};
  for (const std::string robot : {"blue1", "blue2", "blue3", "red1", "red2", "red3"}) {
    overrides.push_back(robot + ".controller=library");
    overrides.push_back(robot + ".library=" + library);
  }
  overrides.insert(overrides.end(), more.begin(), more.end());
  return {.threads = threads, .overrides = std::move(overrides), .cameras = false};
}

const SoftwareReport& software(const scene::Scene& scene, const std::string& robot) {
  return *software_report(scene.simulation().world().entity(robot));
}

/// "sender sent now bytes" [ms].
struct Heard {
  std::string sender;
  long long sent = 0, now = 0;
  std::size_t bytes = 0;
  friend bool operator==(const Heard&, const Heard&) = default;
};

std::vector<Heard> heard(const scene::Scene& scene, const std::string& robot) {
  std::vector<Heard> all;
  for (const auto& message : software(scene, robot).said) {
    char sender[20];
    Heard one;
    EXPECT_EQ(std::sscanf(message.text.c_str(), "%19s %lld %lld %zu", sender, &one.sent, &one.now, &one.bytes), 4);
    one.sender = sender;
    all.push_back(one);
  }
  return all;
}

const std::vector<std::string> only_blue1_sends{"*.options.every=0", "blue1.options.every=5", "*.options.says=true"};

TEST(TeamMessages, ReachTheTeamAndNobodyElse) {
  scene::Scene scene("three_on_three", six(only_blue1_sends));
  scene.simulation().run(500ms);  // 25 steps: blue1 sends at 0, 100, ... 400 ms
  const std::vector<Heard> expected{{"blue1", 0, 20, 8},
                                    {"blue1", 100, 120, 8},
                                    {"blue1", 200, 220, 8},
                                    {"blue1", 300, 320, 8},
                                    {"blue1", 400, 420, 8}};
  EXPECT_EQ(heard(scene, "blue2"), expected);
  EXPECT_EQ(heard(scene, "blue3"), expected);
  for (const std::string robot : {"blue1", "red1", "red2", "red3"}) EXPECT_TRUE(heard(scene, robot).empty()) << robot;
  EXPECT_EQ(software(scene, "blue1").messages->sent, 5U);
  EXPECT_EQ(software(scene, "blue1").messages->lost, 0U);
  EXPECT_EQ(software(scene, "blue2").messages->arrived, 5U);
  const std::string text = to_text(scene::make_report(scene, 1s, {}));
  EXPECT_TRUE(fixtures::says(text, {"messages of", "blue1               5        0        0        0        0"}));
}

TEST(TeamMessages, TakeTheirTime) {
  auto more = only_blue1_sends;
  more.insert(more.end(), {"communication.delay=0.05", "communication.bandwidth=1000", "blue1.options.bytes=100"});
  scene::Scene scene("three_on_three", six(more));
  scene.simulation().run(500ms);
  // 100 ms for 100 bytes and 50 ms on the way: read in the first step after 150 ms, at 160 ms; the next ones 100 ms later each
  EXPECT_EQ(heard(scene, "blue2"),
            (std::vector<Heard>{
                {"blue1", 0, 160, 100}, {"blue1", 100, 260, 100}, {"blue1", 200, 360, 100}, {"blue1", 300, 460, 100}}));
}

TEST(TeamMessages, AreSentInTurnsOnTheChannelOfATeam) {
  scene::Scene scene("three_on_three", six({"*.options.every=50", "*.options.says=true", "*.options.bytes=100",
                                            "communication.bandwidth=1000", "communication.loss=0"}));
  scene.simulation().run(500ms);
  // blue1's until 100 ms, blue2's until 200 ms, blue3's until 300 ms; the channel of the other team is another one
  EXPECT_EQ(heard(scene, "blue3"), (std::vector<Heard>{{"blue1", 0, 100, 100}, {"blue2", 0, 200, 100}}));
  EXPECT_EQ(heard(scene, "blue1"), (std::vector<Heard>{{"blue2", 0, 200, 100}, {"blue3", 0, 300, 100}}));
  EXPECT_EQ(heard(scene, "red3"), (std::vector<Heard>{{"red1", 0, 100, 100}, {"red2", 0, 200, 100}}));
}

TEST(TeamMessages, DoNotGoFartherThanTheRange) {
  auto more = only_blue1_sends;
  more.insert(more.end(), {"communication.range=1.0", "blue1.position=[0, 0]", "blue2.position=[0.9, 0]",
                           "blue3.position=[0, 1.2]", "ball.position=[2, 2]"});
  scene::Scene scene("three_on_three", six(more));
  scene.simulation().run(500ms);
  EXPECT_EQ(heard(scene, "blue2").size(), 5U);
  EXPECT_EQ(heard(scene, "blue3").size(), 0U);
  EXPECT_EQ(software(scene, "blue1").messages->lost, 5U);
}

TEST(TeamMessages, GetLost) {
  scene::Scene scene("three_on_three", six({"communication.loss=0.3", "communication.messages_per_second=50"}));
  scene.simulation().run(10s);
  std::uint64_t sent = 0, lost = 0, arrived = 0;
  for (const std::string robot : {"blue1", "blue2", "blue3", "red1", "red2", "red3"}) {
    const MessageCounts counts = *software(scene, robot).messages;
    sent += counts.sent;
    lost += counts.lost;
    arrived += counts.arrived;
    EXPECT_EQ(counts.not_read, 0U);
  }
  EXPECT_EQ(sent, 3000U);
  EXPECT_NEAR(static_cast<double>(lost), 0.3 * 6000, 4 * std::sqrt(6000 * 0.3 * 0.7));
  EXPECT_EQ(lost + arrived + 12, 6000U);  // those of the last step are still on their way: they may get lost yet
}

TEST(TeamMessages, AreRefusedIfTooLongOrTooMany) {
  scene::Scene longer("three_on_three", six({"blue1.options.bytes=1401"}));
  longer.simulation().run(1s);
  EXPECT_EQ(software(longer, "blue1").messages->sent, 0U);
  EXPECT_EQ(software(longer, "blue1").messages->refused, 50U);
  EXPECT_EQ(software(longer, "blue1").first_refused_message, "at 0.000 s: a message has 1401 bytes; 1400 are allowed");
  scene::Scene more("three_on_three", six({"communication.messages_per_second=7"}));
  more.simulation().run(3s);
  EXPECT_EQ(software(more, "blue1").messages->sent, 21U);  // seven in each second
  EXPECT_EQ(software(more, "blue1").messages->refused, 129U);
  EXPECT_EQ(software(more, "blue1").first_refused_message, "at 0.140 s: more than 7 messages in a second");
  const std::string text = to_text(scene::make_report(more, 1s, {}));
  EXPECT_TRUE(
      fixtures::says(text, {"warning: blue1: 129 messages of its control software were refused, the first at"}));
}

TEST(TeamMessages, DoNotReachWhoIsNotThere) {
  auto more = only_blue1_sends;
  more.insert(more.end(), {"blue2.present=false", "communication.delay=0.03"});
  scene::SceneOptions options = six(more);
  options.events = {"0.25:blue2.present=true", "0.31:blue3.present=false"};
  scene::Scene scene("three_on_three", options);
  scene.simulation().run(500ms);
  EXPECT_EQ(heard(scene, "blue2").size(), 2U);  // those of 300 and 400 ms
  EXPECT_EQ(heard(scene, "blue3").size(), 3U);  // that of 300 ms arrives when it is gone
}

const std::vector<std::string> unsteady{"communication.loss=0.2", "communication.jitter=0.05",
                                        "communication.bandwidth=20000", "communication.messages_per_second=50"};

TEST(TeamMessages, AreTheSameWithAnyNumberOfThreads) {
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2, 3}) {
    scene::Scene scene("three_on_three", six(unsteady, threads));
    scene.simulation().run(1s);
    hashes.push_back(scene.simulation().state_hash());
  }
  EXPECT_EQ(hashes[1], hashes[0]);
  EXPECT_EQ(hashes[2], hashes[0]);
  auto calm = unsteady;
  calm[0] = "communication.loss=0.21";
  scene::Scene other("three_on_three", six(calm));
  other.simulation().run(1s);
  EXPECT_NE(other.simulation().state_hash(), hashes[0]);
}

TEST(TeamMessages, BelongToStateAndStart) {
  scene::Scene scene("three_on_three", six(unsteady));
  scene.simulation().run(530ms);
  const std::vector<std::byte> state = scene.save();
  scene.simulation().run(400ms);
  const std::uint64_t there = scene.simulation().state_hash();
  scene::Scene other("three_on_three", six(unsteady));
  other.load(state);
  other.simulation().run(400ms);
  EXPECT_EQ(other.simulation().state_hash(), there);
  scene.reset();
  scene.simulation().run(930ms);
  EXPECT_EQ(scene.simulation().state_hash(), there);
  scene.reset(99);
  scene.simulation().run(930ms);
  EXPECT_NE(scene.simulation().state_hash(), there);
}

TEST(TeamMessages, NeedATeam) {
  const std::string message = fixtures::error_of([] {
    scene::Scene("walk", {.overrides = {"walker.controller=library", "walker.library=" + library}, .cameras = false});
  });
  EXPECT_TRUE(fixtures::says(message, {"walker is in no team, so there is no robot to send messages to"}));
}

TEST(TeamMessages, ComeWithARobotThatIsAdded) {
  std::vector<std::string> no_controllers;
  for (const std::string robot : {"blue1", "blue2", "blue3", "red1", "red2", "red3"}) {
    no_controllers.push_back(robot + ".controller=none");
  }
  scene::Scene scene("three_on_three", {.overrides = no_controllers, .cameras = false});
  scene.simulation().run(100ms);
  scene_file::RobotSpec robot = scene.spec().robots[0];
  robot.controller = "library";
  robot.library = library;
  robot.options = {{"says", true}, {"every", 5.0}};
  for (const std::string name : {"blue4", "blue5"}) {
    robot.name = name;
    robot.position = {name == "blue4" ? -1.0 : 1.0, 2.5, 0};
    scene.add(robot);
  }
  scene.simulation().run(300ms);
  EXPECT_EQ(heard(scene, "blue4").size(), 3U);
  EXPECT_EQ(heard(scene, "blue5").size(), 3U);
}

TEST(TeamMessages, LibrariesOfVersion1StillLoad) {
  scene::Scene scene("walk",
                     {.overrides = {"walker.controller=library",
                                    "walker.library=" + std::string(MUROSIMF_CONTROLLERS) + "/controller_version_1.so"},
                      .cameras = false});
  scene.simulation().run(100ms);
  EXPECT_EQ(software(scene, "walker").calls, 10);
  EXPECT_FALSE(software(scene, "walker").messages);
}

TEST(MessageBox, DropsTheOldestIfNobodyReads) {
  MessageBox box;
  for (std::size_t i = 0; i < MessageBox::most_unread + 3; ++i) box.deliver({{}, "a", std::to_string(i)});
  EXPECT_EQ(box.inbox.size(), MessageBox::most_unread);
  EXPECT_EQ(box.inbox.front().bytes, "3");
  EXPECT_EQ(box.counts.not_read, 3U);
}

}  // namespace
}  // namespace murosimf::control_software
