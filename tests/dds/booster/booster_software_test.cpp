// A Booster K1 and a program at the other end of DDS, on 127.0.0.1: modes, low-level commands, the walk, garbage, recordings.
#include "murosimf/dds/booster/booster_software.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <random>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/control_software/controller_task.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "tests/recording/repeatable_run.h"

// Fast DDS 2.9 of Debian deletes an object of a reader with another size than it has made it with (both in libfastrtps, ~RTPSReader). The address
// sanitizer compares no sizes in these tests; it looks for all else.
#ifdef MUROSIMF_ADDRESS_SANITIZER
extern "C" const char* __asan_default_options();  // NOLINT: the sanitizer's name
extern "C" const char* __asan_default_options() { return "new_delete_type_mismatch=0"; }
#endif

namespace murosimf::dds::booster {
namespace {

using namespace std::chrono_literals;

/// Tests run in processes of their own, at the same time.
int own_domain() { return 100 + getpid() % 100; }

constexpr std::size_t joints = 22;
constexpr char answer_mark = 'a', state_mark = 's';

/// What a program with the SDK does, without the SDK.
class Client {
 public:
  Client()
      : participant_(own_domain()),
        commands_(participant_.writer({"rt/joint_ctrl", "booster_interface::msg::dds_::LowCmd_", true})),
        requests_(participant_.writer({"rt/LocoApiTopicReq", "booster_msgs::msg::dds_::RpcReqMsg_", true})),
        balls_(participant_.writer({"rt/kick_ball", "brain::msg::dds_::Kick_", true})) {
    participant_.read({"rt/LocoApiTopicResp", "booster_msgs::msg::dds_::RpcRespMsg_", true}, inbox_, answer_mark);
    participant_.read({"rt/low_state", "booster_interface::msg::dds_::LowState_", false}, inbox_, state_mark);
  }

  /// Its head goes to `q`; joints behind it weigh nothing, and are held.
  void command(std::size_t motors, double q) { write(motors, q, 0, 2); }
  /// One joint goes to `q`.
  void turn(std::size_t motors, std::size_t joint, double q) { write(motors, q, joint, joint + 1); }
  void see_ball(double x, double y, double direction) {
    CdrWriter message;
    message.number<std::int32_t>(0).number<std::uint32_t>(0).text("").number(x).number(y).number(direction);
    for (int i = 0; i < 4; ++i) message.number(0.0);
    balls_.write(message.bytes());
  }
  void garbage(const Bytes& bytes) {
    commands_.write(bytes);
    requests_.write(bytes);
  }
  /// Header and body of the answer; the robot steps meanwhile.
  RpcMessage ask(scene::Scene& scene, int number, const std::string& body = "", int patience = 5000) {
    const std::string id = std::to_string(++asked_);
    CdrWriter message;
    write_rpc(message, {id, fmt::format("{{\"api_id\":{}}}", number), body});
    for (const Arrival& arrival : inbox_.take())
      states_ += arrival.topic == state_mark;  // full of them, it takes no answer
    requests_.write(message.bytes());
    for (int i = 0; i < patience; ++i) {
      scene.simulation().run(2ms);
      std::this_thread::sleep_for(1ms);
      for (const Arrival& arrival : inbox_.take()) {
        if (arrival.topic == state_mark) ++states_;
        if (arrival.topic != answer_mark) continue;
        const auto answer = read_rpc(arrival.message);
        if (answer && answer->uuid == id) return *answer;
      }
    }
    return {};
  }
  [[nodiscard]] int states() const { return states_; }
  /// Until both sides know each other: what is sent before is lost.
  void meet(scene::Scene& scene) {
    for (int i = 0; i < 200; ++i) {
      if (!ask(scene, 2017, "", 50).uuid.empty()) return;
    }
    ADD_FAILURE() << "no answer";
  }

 private:
  /// Motors [first, end) weigh 1, the others 0.
  void write(std::size_t motors, double q, std::size_t first, std::size_t end) {
    CdrWriter message;
    message.number<std::int32_t>(LowCommand::serial).number(static_cast<std::uint32_t>(motors));
    for (std::size_t i = 0; i < motors; ++i) {
      message.number<std::uint8_t>(0);
      for (const float value : {static_cast<float>(q), 0.0F, 0.0F, 100.0F, 2.0F, i >= first && i < end ? 1.0F : 0.0F})
        message.number(value);
    }
    commands_.write(message.bytes());
  }

  Inbox inbox_;
  Participant participant_;
  TopicWriter &commands_, &requests_, &balls_;
  int asked_ = 0, states_ = 0;
};

scene::SceneOptions options(std::vector<std::string> overrides = {}) {
  return {.overrides = std::move(overrides), .dds_domain = own_domain(), .cameras = false};
}

struct BoosterScene : ::testing::Test {
  void SetUp() override {
    try {
      const Participant any(own_domain());
    } catch (const SetupError& error) {
      GTEST_SKIP() << error.what();
    }
  }
};

std::vector<std::string> said(scene::Scene& scene) {
  std::vector<std::string> lines;
  for (const auto& message : control_software::software_report(scene.simulation().world().entity("k1"))->said)
    lines.push_back(message.text);
  return lines;
}

double head(scene::Scene& scene) {
  return scene.simulation().world().entity("k1").object("AAHead_yaw").get(properties::joint_position);
}

void command_for(scene::Scene& scene, Client& client, Duration time, double q) {
  for (Duration t{}; t < time; t += 4ms) {
    client.command(joints, q);
    std::this_thread::sleep_for(1ms);
    scene.simulation().run(4ms);
  }
}

using BoosterSoftware = BoosterScene;

TEST_F(BoosterSoftware, FollowsLowLevelCommandsInCustomModeAlone) {
  Client client;
  scene::Scene scene("booster", options());
  client.meet(scene);
  EXPECT_EQ(client.ask(scene, 2017).body, R"({"mode":1})");
  command_for(scene, client, 200ms, 0.3);
  EXPECT_NEAR(head(scene), 0, 0.01) << "not yet";
  EXPECT_EQ(client.ask(scene, 2000, R"({"mode":3})").header, R"({"status":0})");
  command_for(scene, client, 600ms, 0.3);
  EXPECT_NEAR(head(scene), 0.3, 0.02);
  EXPECT_EQ(client.ask(scene, 2000, R"({"mode":1})").header, R"({"status":0})");
  scene.simulation().run(1s);
  EXPECT_NEAR(head(scene), 0, 0.02) << "the motion engine has it again";
  EXPECT_GT(client.states(), 10);
  EXPECT_EQ(said(scene), std::vector<std::string>{"a program with the robot's SDK has come"});
}

TEST_F(BoosterSoftware, KnowsWhereItsBodyIs) {
  Client client;
  scene::Scene scene("booster", options());
  client.meet(scene);
  const auto frame = [&](int of, int in) {
    const std::string body = fmt::format("{{\"src\":{},\"dst\":{}}}", in, of);
    return nlohmann::json::parse(client.ask(scene, 2011, body).body);
  };
  const auto there = frame(4, 0), back = frame(0, 4);
  EXPECT_EQ(frame(0, 0)["position"]["x"], 0.0);
  EXPECT_EQ(frame(0, 0)["orientation"]["w"], 1.0);
  // oracle: poses of the simulated bodies
  Entity& robot = scene.simulation().world().entity("k1");
  const ObjectAccess trunk = robot.base(), foot = robot.object("Left_Ankle_Roll");
  const Vec3d way = transpose(trunk.get(properties::orientation)) *
                    (foot.get(properties::position) - trunk.get(properties::position));
  constexpr double near = 2e-3;  // between both the robot moves for some cycles
  EXPECT_NEAR(there["position"]["x"], way.x, near);
  EXPECT_NEAR(there["position"]["y"], way.y, near);
  EXPECT_NEAR(there["position"]["z"], way.z, near);
  const auto length = [](const nlohmann::json& pose) {
    const auto& p = pose["position"];
    return std::hypot(double{p["x"]}, double{p["y"]}, double{p["z"]});
  };
  EXPECT_NEAR(length(there), length(back), near);
  EXPECT_EQ(client.ask(scene, 2011, R"({"src":0,"dst":9})").header, R"({"status":400})");
}

TEST_F(BoosterSoftware, KicksTheBallThatItsProgramSees) {
  Client client;
  scene::Scene scene("booster", options({"k1.options.mode=walking"}));
  client.meet(scene);
  const auto request = [&] { return scene.simulation().world().entity("k1").base().get(properties::kick_request); };
  EXPECT_EQ(client.ask(scene, 2038, R"({"start":true,"version":0})").header, R"({"status":0})");
  scene.simulation().run(10ms);
  EXPECT_EQ(request().number, 1) << "ahead";
  EXPECT_EQ(request().ball_x, 0);
  for (int i = 0; i < 300 && request().ball_x == 0; ++i) {
    client.see_ball(0.4, -0.2, 0.7);
    std::this_thread::sleep_for(1ms);
    scene.simulation().run(4ms);
  }
  EXPECT_EQ(request().ball_x, 0.4);
  EXPECT_EQ(request().ball_y, -0.2);
  EXPECT_EQ(request().direction, 0.7);
  EXPECT_EQ(client.ask(scene, 2038, R"({"start":false})").header, R"({"status":0})");
  scene.simulation().run(10ms);
  EXPECT_EQ(request().number, 0);
}

TEST_F(BoosterSoftware, WavesWithTheHandThatIsNamed) {
  Client client;
  scene::Scene scene("booster", options());
  client.meet(scene);
  const auto roll = [&](const char* joint) {
    return scene.simulation().world().entity("k1").object(joint).get(properties::joint_position);
  };
  EXPECT_EQ(client.ask(scene, 2005, R"({"hand_index":1,"hand_action":0})").header, R"({"status":0})");
  scene.simulation().run(1500ms);
  EXPECT_LT(roll("Right_Shoulder_Roll"), 0.4);
  EXPECT_NEAR(roll("Left_Shoulder_Roll"), -1.3, 0.1);
  EXPECT_EQ(client.ask(scene, 2005, R"({"hand_index":1,"hand_action":1})").header, R"({"status":0})");
  scene.simulation().run(3s);
  EXPECT_NEAR(roll("Right_Shoulder_Roll"), 1.3, 0.1);
  EXPECT_EQ(client.ask(scene, 2005, R"({"hand_index":0,"hand_action":0})").header, R"({"status":0})");
  scene.simulation().run(1500ms);
  EXPECT_GT(roll("Left_Shoulder_Roll"), -0.4);
}

// The SDK's order has the waist of a T1 between arms and legs.
TEST_F(BoosterSoftware, KnowsTheT1) {
  Client client;
  scene::Scene scene("booster", options({"k1.model=booster_t1"}));
  client.meet(scene);
  EXPECT_NE(client.ask(scene, 2022).body.find(R"("model":"T1")"), std::string::npos);
  EXPECT_EQ(client.ask(scene, 2000, R"({"mode":3})").header, R"({"status":0})");
  const auto waist = [&] {
    return scene.simulation().world().entity("k1").object("Waist").get(properties::joint_position);
  };
  EXPECT_NEAR(waist(), 0, 0.01);
  for (int i = 0; i < 200; ++i) {
    client.turn(23, 10, 0.2);
    std::this_thread::sleep_for(1ms);
    scene.simulation().run(4ms);
  }
  EXPECT_NEAR(waist(), 0.2, 0.02);
}

TEST_F(BoosterSoftware, GoesOnAfterGarbage) {
  Client client;
  scene::Scene scene("booster", options());
  client.meet(scene);
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    Bytes bytes{0, 1, 0, 0};
    while (bytes.size() < random() % 700) bytes.push_back(static_cast<std::uint8_t>(random()));
    client.garbage(bytes);
  }
  client.command(3, 0.1);
  for (const int number : {2000, 2001, 2004, 2025, 2038, 2043})
    EXPECT_EQ(client.ask(scene, number, R"({"mode":"x","vx":[]})").header, R"({"status":400})") << number;
  EXPECT_EQ(client.ask(scene, 2016).header, R"({"status":501})");
  EXPECT_EQ(client.ask(scene, 2017).body, R"({"mode":1})");
  EXPECT_EQ(said(scene).size(), 3U) << "each is told once";
}

TEST_F(BoosterSoftware, SaysWhenProgramsGo) {
  scene::Scene scene("booster", options());
  std::optional<Client> client(std::in_place);
  client->meet(scene);
  EXPECT_EQ(client->ask(scene, 2000, R"({"mode":2})").header, R"({"status":0})");
  EXPECT_EQ(client->ask(scene, 2001, R"({"vx":0.1,"vy":0,"vyaw":0})").header, R"({"status":0})");
  client.reset();
  for (int i = 0; i < 1000 && said(scene).size() < 2; ++i) {
    std::this_thread::sleep_for(1ms);
    scene.simulation().run(2ms);
  }
  EXPECT_EQ(said(scene).back(), "the last program has gone; commands stay as they are");
  EXPECT_EQ(scene.simulation().world().entity("k1").base().get(properties::walk_command).x, 0.1);
}

TEST_F(BoosterSoftware, IsRepeatedFromARecording) {
  fixtures::RepeatableRun run{.scene = "booster", .how = options()};
  run.how.outside.notes = std::make_shared<ExternalInputLog>();
  run.options.state_period = 100ms;
  run.play = [&](scene::Scene& scene, recording::Recorder&) {
    Client client;
    client.meet(scene);
    EXPECT_EQ(client.ask(scene, 2004, R"({"pitch":0.2,"yaw":0.3})").header, R"({"status":0})");
    scene.simulation().run(300ms);
    EXPECT_NEAR(head(scene), 0.3, 0.03);
    EXPECT_EQ(client.ask(scene, 2000, R"({"mode":3})").header, R"({"status":0})");
    command_for(scene, client, 200ms, 0.2);
    EXPECT_EQ(client.ask(scene, 2000, R"({"mode":2})").header, R"({"status":0})");
    EXPECT_EQ(client.ask(scene, 2031, R"({"x":1,"y":2,"theta":3})").header, R"({"status":0})");
    scene.simulation().run(300ms);
  };
  fixtures::expect_repeatable(fixtures::record("booster.mcap", run));
}

// In lock-step every cycle takes a command, however slowly a program writes them.
TEST_F(BoosterSoftware, WaitsForCommandsInLockStep) {
  Client client;
  scene::Scene scene("booster", options({"k1.options.lock_step=2"}));
  client.meet(scene);
  EXPECT_EQ(client.ask(scene, 2000, R"({"mode":3})").header, R"({"status":0})");
  constexpr int cycles = 30;
  constexpr double step = 0.01;
  std::thread program([&] {
    for (int i = 1; i <= cycles + 5; ++i) {
      std::this_thread::sleep_for(3ms);
      client.command(joints, step * i);
    }
  });
  scene.simulation().run(cycles * 2ms);
  const double target = scene.simulation().world().entity("k1").object("AAHead_yaw").get(properties::joint_target);
  EXPECT_GT(target, step * (cycles - 1.5)) << "one for each cycle, but the first, which began before";
  program.join();
}

TEST(BoosterController, NamesRobotsThatAreNone) {
  try {
    scene::Scene scene("walk", {.overrides = {"walker.controller=booster"}, .cameras = false});
    FAIL() << "kid21 is no Booster";
  } catch (const SetupError& error) {
    EXPECT_TRUE(std::string(error.what()).find("is for a Booster K1 (22 joints) or T1 (23)") != std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace murosimf::dds::booster
