// A Unitree G1 and a program at the other end of DDS, on 127.0.0.1: which side has the motors, low-level commands, checksums, garbage, recordings.
#include "murosimf/dds/unitree/unitree_software.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <random>
#include <thread>

#include "murosimf/control_software/controller_task.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "tests/recording/repeatable_run.h"

namespace murosimf::dds::unitree {
namespace {

using namespace std::chrono_literals;

/// Tests run in processes of their own, at the same time.
int own_domain() { return 100 + getpid() % 100; }

constexpr std::size_t motors = 29, waist_yaw = 12, elbow = 18;
constexpr char answer_mark = 'a', state_mark = 's', imu_mark = 'i';

/// What a low-level program does.
class Client {
 public:
  Client()
      : participant_(own_domain()),
        commands_(participant_.writer({"rt/lowcmd", "unitree_hg::msg::dds_::LowCmd_", true})),
        requests_(participant_.writer({"rt/api/motion_switcher/request", "unitree_api::msg::dds_::Request_", true})) {
    participant_.read({"rt/api/motion_switcher/response", "unitree_api::msg::dds_::Response_"}, inbox_, answer_mark);
    participant_.read({"rt/lowstate", "unitree_hg::msg::dds_::LowState_"}, inbox_, state_mark);
    participant_.read({"rt/secondary_imu", "unitree_hg::msg::dds_::IMUState_"}, inbox_, imu_mark);
  }

  /// All motors are held at 0 with strong gains, but the elbow at `q`.
  [[nodiscard]] static LowCommand holding(double q) {
    LowCommand command{.mode_machine = 5};
    for (std::size_t i = 0; i < motors; ++i) command.motors[i] = {.mode = 1, .kp = 300, .kd = 10};
    command.motors[elbow] = {.mode = 1, .q = static_cast<float>(q), .kp = 100, .kd = 2};
    command.crc = checksum_of(command);
    return command;
  }
  void write(const LowCommand& command) {
    CdrWriter message;
    write_low_command(message, command);
    commands_.write(message.bytes());
  }
  void garbage(const Bytes& bytes) {
    commands_.write(bytes);
    requests_.write(bytes);
  }
  /// JSON of the answer; the robot steps meanwhile.
  std::string ask(scene::Scene& scene, std::int64_t call, int patience = 5000) {
    CdrWriter message;
    message.number(++asked_).number(call).number<std::int64_t>(0).number<std::int32_t>(0).number<std::uint8_t>(0);
    look();  // full of states, it takes no answer
    requests_.write(message.text("{}").blob("").bytes());
    for (int i = 0; i < patience; ++i) {
      scene.simulation().run(2ms);
      std::this_thread::sleep_for(1ms);
      look();
      if (answered_ == asked_) return answer_;
    }
    return "";
  }
  /// Until both sides know each other: what is sent before is lost.
  void meet(scene::Scene& scene) {
    for (int i = 0; i < 200; ++i) {
      if (!ask(scene, 1001, 50).empty()) return;
    }
    ADD_FAILURE() << "no answer";
  }
  [[nodiscard]] int states() {
    look();
    return states_;
  }
  [[nodiscard]] int imus() {
    look();
    return imus_;
  }

 private:
  void look() {
    for (const Arrival& arrival : inbox_.take()) {
      states_ += arrival.topic == state_mark;
      imus_ += arrival.topic == imu_mark;
      if (arrival.topic != answer_mark) continue;
      CdrReader from(arrival.message);
      answered_ = from.number<std::int64_t>();
      (void)from.number<std::int64_t>(), (void)from.number<std::int32_t>();
      answer_ = from.text();
    }
  }

  Inbox inbox_;
  Participant participant_;
  TopicWriter &commands_, &requests_;
  std::int64_t asked_ = 0, answered_ = 0;
  std::string answer_;
  int states_ = 0, imus_ = 0;
};

scene::SceneOptions options(std::vector<std::string> overrides = {}) {
  return {.overrides = std::move(overrides), .unitree_domain = own_domain(), .cameras = false};
}

struct UnitreeScene : ::testing::Test {
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
  for (const auto& message : control_software::software_report(scene.simulation().world().entity("g1"))->said)
    lines.push_back(message.text);
  return lines;
}

double joint(scene::Scene& scene, const char* name = "left_elbow_joint") {
  return scene.simulation().world().entity("g1").object(name).get(properties::joint_position);
}

void command_for(scene::Scene& scene, Client& client, Duration time, const LowCommand& command) {
  for (Duration t{}; t < time; t += 4ms) {
    client.write(command);
    std::this_thread::sleep_for(1ms);
    scene.simulation().run(4ms);
  }
}

using UnitreeSoftware = UnitreeScene;

TEST_F(UnitreeSoftware, StandsUntilAProgramTakesItsMotors) {
  Client client;
  scene::Scene scene("unitree", options());
  client.meet(scene);
  EXPECT_EQ(client.ask(scene, 1001), R"({"form":"0","name":"ai"})");
  EXPECT_EQ(client.ask(scene, 1003), "");
  EXPECT_EQ(client.ask(scene, 1001), R"({"form":"0","name":""})");
  const double before = joint(scene);
  scene.simulation().run(400ms);
  EXPECT_NEAR(joint(scene), before, 0.02) << "released motors are held until they are commanded";
  command_for(scene, client, 400ms, Client::holding(0.5));
  EXPECT_NEAR(joint(scene), 0.5, 0.05);
  EXPECT_GT(client.states(), 100);
  EXPECT_GT(client.imus(), 100);
}

TEST_F(UnitreeSoftware, RefusesWhatIsNotWhole) {
  Client client;
  scene::Scene scene("unitree", options());
  client.meet(scene);
  const double before = joint(scene);
  LowCommand wrong = Client::holding(0.5), cranks = wrong, none = wrong;
  ++wrong.crc;
  cranks.mode_pr = 1;
  cranks.crc = checksum_of(cranks);
  command_for(scene, client, 100ms, wrong);
  none.motors[elbow].q = std::numeric_limits<float>::quiet_NaN();
  none.crc = checksum_of(none);
  command_for(scene, client, 100ms, cranks);
  command_for(scene, client, 100ms, none);
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    Bytes bytes{0, 1, 0, 0};
    while (bytes.size() < random() % 1100) bytes.push_back(static_cast<std::uint8_t>(random()));
    client.garbage(bytes);
  }
  EXPECT_EQ(client.ask(scene, 1001), R"({"form":"0","name":"ai"})") << "it stands by itself as before";
  EXPECT_NEAR(joint(scene), before, 0.1);
  const std::vector<std::string> lines = said(scene);
  ASSERT_EQ(lines.size(), 5U) << "each is told once";
  EXPECT_NE(lines[1].find("a low-level command with the CRC 0x"), std::string::npos) << lines[1];
  EXPECT_NE(lines[2].find("mode AB"), std::string::npos) << lines[2];
  EXPECT_NE(lines[3].find("a number that is none"), std::string::npos) << lines[3];
  EXPECT_NE(lines[4].find("a message that is none"), std::string::npos) << lines[4];
}

TEST_F(UnitreeSoftware, GoesOnWhenProgramsGo) {
  scene::Scene scene("unitree", options());
  std::optional<Client> client(std::in_place);
  client->meet(scene);
  command_for(scene, *client, 100ms, Client::holding(0.5));
  client.reset();
  for (int i = 0; i < 1000 && said(scene).size() < 2; ++i) {
    std::this_thread::sleep_for(1ms);
    scene.simulation().run(2ms);
  }
  EXPECT_EQ(said(scene).back(), "the last program has gone; commands stay as they are");
  scene.simulation().run(400ms);
  EXPECT_NEAR(joint(scene), 0.5, 0.05);
}

// A motor that is not enabled makes no torque; one without a position gain follows its torque alone.
TEST_F(UnitreeSoftware, SwitchesMotorsOff) {
  Client client;
  scene::Scene scene("unitree", options({"g1.options.stands=false"}));
  client.meet(scene);
  LowCommand command = Client::holding(0.5);
  command.motors[elbow].mode = 0;
  command.motors[waist_yaw] = {.mode = 1, .q = 2.146e9F, .tau = 3};
  command.crc = checksum_of(command);
  command_for(scene, client, 60ms, command);
  Entity& robot = scene.simulation().world().entity("g1");
  EXPECT_NEAR(robot.object("left_elbow_joint").get(properties::joint_torque), 0, 1e-6);
  EXPECT_NEAR(robot.object("waist_yaw_joint").get(properties::joint_torque), 3, 1e-6);
}

TEST_F(UnitreeSoftware, IsRepeatedFromARecording) {
  fixtures::RepeatableRun run{.scene = "unitree", .how = options()};
  run.how.outside.notes = std::make_shared<ExternalInputLog>();
  run.options.state_period = 100ms;
  run.play = [&](scene::Scene& scene, recording::Recorder&) {
    Client client;
    client.meet(scene);
    EXPECT_EQ(client.ask(scene, 1003), "");
    command_for(scene, client, 300ms, Client::holding(0.5));
    EXPECT_EQ(client.ask(scene, 1002), "");
    command_for(scene, client, 100ms, Client::holding(0.2));
  };
  fixtures::expect_repeatable(fixtures::record("unitree.mcap", run));
}

TEST(UnitreeController, NamesRobotsThatAreNone) {
  try {
    scene::Scene scene("walk", {.overrides = {"walker.controller=unitree"}, .cameras = false});
    FAIL() << "kid21 is no G1";
  } catch (const SetupError& error) {
    EXPECT_TRUE(std::string(error.what()).find("is for a Unitree G1 with 29 joints") != std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace murosimf::dds::unitree
