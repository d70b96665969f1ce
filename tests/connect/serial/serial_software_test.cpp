// A robot at a serial line: what its client moves and reads, clients that go, garbage, slow readers, saved states.
#include "murosimf/connect/serial/serial_software.h"

#include <gtest/gtest.h>

#include <numbers>

#include "murosimf/connect/controller_task.h"
#include "murosimf/model/properties.h"
#include "murosimf/motion/servo_law.h"
#include "murosimf/scene/scene.h"
#include "tests/connect/serial/serial_port.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::connect::serial {
namespace {

using namespace std::chrono_literals;
using dynamixel::append;
using dynamixel::Bytes;
using dynamixel::Instruction;
using dynamixel::Packet;
using dynamixel::Protocol;

constexpr double pulses_per_radian = 4096 / (2 * std::numbers::pi);
constexpr std::uint8_t head = 3;  // id of kid21's third joint

Packet write_packet(std::uint8_t id, std::uint8_t address, const Bytes& data) {
  Packet packet{Protocol::v2, id, static_cast<std::uint8_t>(Instruction::write), {address, 0}};
  append(packet.parameters, data);
  return packet;
}
Bytes long_word(int value) {
  return {static_cast<std::uint8_t>(value & 0xFF), static_cast<std::uint8_t>(value >> 8 & 0xFF), 0, 0};
}
Packet torque_on(std::uint8_t id) { return write_packet(id, 64, {1}); }
Packet goal(std::uint8_t id, int pulses) { return write_packet(id, 116, long_word(pulses)); }
const Packet read_head{Protocol::v2, head, 0x02, {132, 0, 4, 0}};

struct SerialScene {
  explicit SerialScene(std::vector<std::string> overrides = {}) : folder(fixtures::temp_folder() / "ports") {
    overrides.insert(overrides.begin(), "walker.controller=serial");
    scene.emplace("walk", scene::SceneOptions{.overrides = overrides, .terminals = folder.string(), .cameras = false});
    scene->simulation().step();  // from now on there is a link
  }
  void run(Duration duration) { scene->simulation().run(duration); }
  [[nodiscard]] Entity& robot() { return scene->simulation().world().entity("walker"); }
  [[nodiscard]] double head_angle() { return robot().object("j_head").get(properties::joint_position); }
  [[nodiscard]] std::vector<std::string> said() {
    std::vector<std::string> lines;
    for (const auto& message : software_report(robot())->said) lines.push_back(message.text);
    return lines;
  }
  [[nodiscard]] std::filesystem::path port() const { return folder / "walker"; }

  std::filesystem::path folder;
  std::optional<scene::Scene> scene;
};

int number(const std::optional<Packet>& answer) {
  if (!answer || answer->parameters.size() < 5) return -1;
  return answer->parameters[1] | answer->parameters[2] << 8;
}

TEST(SerialSoftware, MovesAJointAndReadsItBack) {
  SerialScene test;
  SerialPort port(test.port());
  port.send(goal(head, 2300));  // without torque nothing moves
  test.run(20ms);
  EXPECT_EQ(test.head_angle(), 0);
  port.send(torque_on(head));
  port.send(goal(head, 2300));
  test.run(200ms);
  EXPECT_NEAR(test.head_angle(), (2300 - 2048) / pulses_per_radian, 1e-6);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(port.answer()->parameters.at(0), 0);
  port.send(read_head);
  test.run(2ms);
  EXPECT_EQ(number(port.answer()), 2300);
}

TEST(SerialSoftware, TorqueIsThatOfTheRobot) {
  SerialScene test({"walker.level=articulated_dynamics"});
  EXPECT_EQ(test.robot().object("j_head").get(properties::torque_enabled), 0);  // as real servos start
  SerialPort port(test.port());
  port.send(torque_on(head));
  test.run(2ms);
  EXPECT_EQ(test.robot().object("j_head").get(properties::torque_enabled), 1);
  EXPECT_EQ(test.robot().object("j_neck").get(properties::torque_enabled), 0);
  SerialScene standing({"walker.level=articulated_dynamics", "walker.options.torque=true"});
  standing.run(1ms);
  EXPECT_EQ(standing.robot().object("j_neck").get(properties::torque_enabled), 1);
}

/// Ids are those of the order of joints.
std::uint8_t id_of(Entity& robot, const std::string& joint) {
  const auto& joints = robot.model().joints();
  return static_cast<std::uint8_t>(1 + (std::ranges::find(joints, robot.model().object_index(joint)) - joints.begin()));
}

TEST(SerialSoftware, StopsWhereTheJointEnds) {
  SerialScene test({"walker.model=quadruped", "walker.level=simplified_dynamics"});
  const std::uint8_t neck = id_of(test.robot(), "j_neck");
  SerialPort port(test.port());
  port.send(torque_on(neck));
  port.send(goal(neck, 4095));
  test.run(900ms);
  EXPECT_NEAR(test.robot().object("j_neck").get(properties::joint_position), 1.2, 1e-9);
  EXPECT_EQ(software_report(test.robot())->refused, 0U);
}

TEST(SerialSoftware, WheelsFollowAGoalVelocity) {
  SerialScene test({"walker.model=car", "walker.level=articulated_dynamics"});
  const Model& car = test.robot().model();
  const auto wheel = std::ranges::find_if(car.joints(), [&](int joint) {
    const Servo* servo = car.find(properties::servo, joint);
    return servo && motion::follows_rate(*servo);
  });
  ASSERT_NE(wheel, car.joints().end());
  const auto id = static_cast<std::uint8_t>(1 + (wheel - car.joints().begin()));
  SerialPort port(test.port());
  port.send(write_packet(id, 11, {1}));
  port.send(torque_on(id));
  port.send(write_packet(id, 104, long_word(100)));
  test.run(5ms);
  const double wanted = test.robot().object(car.objects()[*wheel].name).get(properties::joint_velocity_target);
  EXPECT_NEAR(wanted, 100 * 0.229 * 2 * std::numbers::pi / 60, 1e-9);
}

TEST(SerialSoftware, ShowsTheImu) {
  SerialScene test;
  SerialPort port(test.port());
  test.run(100ms);
  port.send(Packet{Protocol::v2, 200, 0x02, {50, 0, 2, 0}});
  test.run(2ms);
  const auto answer = port.answer();
  ASSERT_TRUE(answer);
  EXPECT_NEAR(answer->parameters[1] | answer->parameters[2] << 8, 981, 60);  // [0.01 m/s^2]
}

TEST(SerialSoftware, ClientsComeAndGo) {
  SerialScene test;
  for (int client = 0; client < 3; ++client) {
    SerialPort port(test.port());
    test.run(2ms);
    port.send(torque_on(head));
    port.send(goal(head, 2100 + client));
    const Bytes half = dynamixel::to_bytes(goal(head, 3000));
    port.send(dynamixel::ByteView(half).first(9));
    port.hang_up();  // killed in the middle of a packet, its answers unread
    test.run(200ms);
    EXPECT_NEAR(test.head_angle(), (52 + client) / pulses_per_radian, 1e-6);
  }
  SerialPort port(test.port());
  test.run(2ms);
  port.send(read_head);
  test.run(2ms);
  EXPECT_EQ(number(port.answer()), 2102);  // the first that it gets: nothing is left of the others
  const std::string place = test.port().string();
  std::vector<std::string> lines;
  for (int i = 0; i < 3; ++i) {
    lines.push_back(place + " was opened");
    lines.push_back(place + " was closed; torque and goals stay as they are");
  }
  lines.push_back(place + " was opened");
  EXPECT_EQ(test.said(), lines);
}

TEST(SerialSoftware, SurvivesGarbage) {
  SerialScene test;
  SerialPort port(test.port());
  fixtures::Dice dice("garbage");
  for (int i = 0; i < 200; ++i) {
    Bytes garbage;
    for (int k = 0; k < 500; ++k) {
      garbage.push_back(static_cast<std::uint8_t>(dice.chance(0.3) ? 0xFF : dice.pick(256)));
    }
    port.send(garbage);
    test.run(1ms);
  }
  for (int i = 0; i < 100; ++i) port.send(Packet{Protocol::v2, 250, 0x01, {}});  // ends whatever has begun
  test.run(5ms);
  (void)port.received();
  port.send(read_head);
  test.run(2ms);
  EXPECT_NE(number(port.answer()), -1);
}

TEST(SerialSoftware, WaitsForNobodyWhoDoesNotRead) {
  SerialScene test;
  SerialPort port(test.port());
  const Duration begin = test.scene->simulation().now();
  Packet sync{Protocol::v2, 0xFE, 0x82, {0, 0, 140, 0}};
  for (std::uint8_t id = 1; id <= 21; ++id) sync.parameters.push_back(id);
  for (int i = 0; i < 100; ++i) {
    port.send(sync);
    test.run(1ms);
  }
  EXPECT_EQ(test.said().back(), "the client of the serial line does not read: bytes are lost");
  EXPECT_EQ(test.said().size(), 2U);
  EXPECT_EQ(test.scene->simulation().now() - begin, 100ms);
}

TEST(SerialSoftware, BytesTakeSimulatedTime) {
  SerialScene test({"walker.options.baud_rate=1e6"});
  SerialPort port(test.port());
  Packet sync{Protocol::v2, 0xFE, 0x82, {132, 0, 4, 0}};  // 35 bytes; 21 answers of 15, each after 500 us: 14 ms
  for (std::uint8_t id = 1; id <= 21; ++id) sync.parameters.push_back(id);
  port.send(sync);
  test.run(14ms);
  const std::size_t by_then = port.received().size();
  EXPECT_LT(by_then, 21U * 15);
  test.run(2ms);
  EXPECT_EQ(by_then + port.received().size(), 21U * 15);
}

TEST(SerialSoftware, LeavesNoFileOpenAndNoLink) {
  const std::size_t before = open_files();
  for (int i = 0; i < 3; ++i) {
    SerialScene test;
    EXPECT_TRUE(std::filesystem::is_symlink(test.port()));
    SerialPort port(test.port());
    test.run(2ms);
  }
  EXPECT_EQ(open_files(), before);
  EXPECT_FALSE(std::filesystem::is_symlink(fixtures::temp_folder() / "ports" / "walker"));
}

TEST(SerialSoftware, ResetsAndStatesAreThoseOfTheServos) {
  SerialScene test;
  SerialPort port(test.port());
  test.run(2ms);
  port.send(torque_on(head));
  port.send(write_packet(head, 112, long_word(50)));  // slowly
  port.send(goal(head, 2500));
  test.run(50ms);
  const std::vector<std::byte> saved = test.scene->save();
  test.run(50ms);
  const std::uint64_t there = test.scene->simulation().state_hash();
  const double angle = test.head_angle();
  EXPECT_GT(angle, 0.01);
  test.run(50ms);
  test.scene->load(saved);
  test.run(50ms);
  EXPECT_EQ(test.scene->simulation().state_hash(), there);
  EXPECT_EQ(test.head_angle(), angle);
  test.scene->simulation().reset();
  test.run(50ms);
  EXPECT_EQ(test.head_angle(), 0);
}

TEST(SerialSoftware, SaysWhatDoesNotFit) {
  const auto refusal = [](const std::vector<std::string>& overrides) {
    return fixtures::error_of([&] { SerialScene test(overrides); });
  };
  EXPECT_TRUE(fixtures::says(refusal({"walker.options.imu_id=5"}), {"the IMU and a servo have the id 5"}));
  EXPECT_TRUE(fixtures::says(refusal({"walker.options.imu=gyro"}), {"unknown signal 'gyro.gyroscope'"}));
  EXPECT_TRUE(fixtures::says(refusal({"walker.options.protocol=3"}), {"protocol"}));
  EXPECT_TRUE(fixtures::says(refusal({"walker.options.bus=nosuch.csv"}), {"nosuch.csv"}));
}

}  // namespace
}  // namespace murosimf::connect::serial
