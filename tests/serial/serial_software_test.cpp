// A robot at a serial line: what its client moves and reads, clients that go, garbage, slow readers, saved states.
#include "murosimf/serial/serial_software.h"

#include <gtest/gtest.h>

#include <fstream>
#include <numbers>

#include <fmt/format.h>

#include "murosimf/control_software/controller_task.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/dynamics/servo/servo_law.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "murosimf/session/live_source.h"
#include "tests/fixtures.h"
#include "tests/recording/repeatable_run.h"
#include "tests/serial/serial_port.h"
#include "tests/temp_folder.h"

namespace murosimf::serial {
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
    for (const auto& message : control_software::software_report(robot())->said) lines.push_back(message.text);
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

/// [m]
double base_height(SerialScene& test) { return test.robot().base().get(properties::position).z; }

TEST(SerialSoftware, WithoutTorqueTheRobotCollapsesAndWithItItStays) {
  SerialScene test({"walker.level=articulated_dynamics", "walker.options.torque=true"});
  SerialPort port(test.port());
  for (const std::uint8_t hip :
       {std::uint8_t{12}, std::uint8_t{18}}) {  // thighs; shins and ankles follow: it bends its knees
    const auto shin = static_cast<std::uint8_t>(hip + 1), ankle = static_cast<std::uint8_t>(hip + 2);
    port.send(write_packet(hip, 112, long_word(10)));
    port.send(write_packet(shin, 112, long_word(20)));
    port.send(write_packet(ankle, 112, long_word(10)));
    port.send(goal(hip, 2048 - 260));
    port.send(goal(shin, 2048 + 520));
    port.send(goal(ankle, 2048 - 260));
  }
  test.run(3s);
  const double standing = base_height(test);
  test.run(1s);
  EXPECT_GT(base_height(test), 0.98 * standing);
  port.send(write_packet(0xFE, 64, {0}));
  test.run(1500ms);
  const double lying = base_height(test);
  EXPECT_LT(lying, 0.6 * standing);
  port.send(write_packet(0xFE, 64, {1}));
  test.run(1s);
  std::vector<double> held;
  for (const int joint : test.robot().model().joints()) {
    held.push_back(test.robot().find(properties::joint_position)->values[joint]);
  }
  test.run(1s);
  std::size_t i = 0;
  for (const int joint : test.robot().model().joints()) {
    EXPECT_NEAR(test.robot().find(properties::joint_position)->values[joint], held[i++], 0.01);
  }
}

TEST(SerialSoftware, GainsLimitsAndLedsAreThoseOfTheRobot) {
  SerialScene test({"walker.level=articulated_dynamics", "walker.options.torque=true"});
  const auto of_head = [&](const Property<double>& property) { return test.robot().object("j_head").get(property); };
  const Servo& servo = *test.robot().model().find(properties::servo, test.robot().model().object_index("j_head"));
  EXPECT_EQ(of_head(properties::servo_position_gain), servo.position_gain);
  EXPECT_EQ(of_head(properties::servo_torque_limit), servo.stall_torque);
  EXPECT_EQ(of_head(properties::servo_led), 0);
  SerialPort port(test.port());
  port.send(write_packet(head, 84, {170, 6}));  // 1706, from 850
  port.send(write_packet(head, 80, {160, 0}));
  port.send(write_packet(head, 100, {177, 0}));  // a fifth of 885
  port.send(write_packet(head, 65, {1}));
  test.run(3ms);
  EXPECT_NEAR(of_head(properties::servo_position_gain), servo.position_gain * 1706 / 850, 1e-9);
  EXPECT_NEAR(of_head(properties::servo_velocity_gain), servo.position_gain * 160 / 16 * 1e-3 / (850 / 128.0), 1e-9);
  EXPECT_NEAR(of_head(properties::servo_torque_limit), 0.2 * servo.stall_torque, 1e-9);
  EXPECT_EQ(of_head(properties::servo_led), 1);
  EXPECT_EQ(test.robot().object("j_neck").get(properties::servo_led), 0);
  EXPECT_EQ(control_software::software_report(test.robot())->refused, 0U);
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
  EXPECT_EQ(control_software::software_report(test.robot())->refused, 0U);
}

TEST(SerialSoftware, WheelsFollowAGoalVelocity) {
  SerialScene test({"walker.model=car", "walker.level=articulated_dynamics"});
  const Model& car = test.robot().model();
  const auto wheel = std::ranges::find_if(car.joints(), [&](int joint) {
    const Servo* servo = car.find(properties::servo, joint);
    return servo && dynamics::follows_rate(*servo);
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

/// Whether a servo answers, asked several times: the kernel may bring bytes after the steps that are to hear them.
bool is_answered(SerialScene& scene, SerialPort& port, std::chrono::milliseconds within) {
  for (int i = 0; i < 5; ++i) {
    port.send(read_head);
    scene.run(within);
    if (number(port.answer()) != -1) return true;
  }
  return false;
}

TEST(SerialSoftware, ServosHearAtTheirRateOnly) {
  SerialScene test;
  SerialPort port(test.port());
  const auto heard = [&](double rate) {
    EXPECT_TRUE(port.set_rate(rate));
    return is_answered(test, port, 3ms);
  };
  EXPECT_TRUE(heard(1e6));
  EXPECT_FALSE(heard(57600));
  EXPECT_FALSE(heard(2e6));
  EXPECT_TRUE(heard(1e6));
  port.send(write_packet(head, 8, {4}));  // 2 Mbit/s
  test.run(3ms);
  EXPECT_TRUE(port.answer());
  EXPECT_FALSE(heard(1e6));
  EXPECT_TRUE(heard(2e6));
  SerialScene slow({"walker.options.baud_rate=57600"});
  SerialPort unset(slow.port());  // a client that chooses none
  EXPECT_TRUE(is_answered(slow, unset, 10ms));
}

TEST(SerialSoftware, PushesWithACurrentWhereServosMakeTorque) {
  for (const bool torque : {false, true}) {
    const std::string level = torque ? "articulated_dynamics" : "simplified_dynamics";
    const std::filesystem::path bus = fixtures::temp_folder() / "current.csv";
    std::ofstream(bus) << "joint,id,servo\nj_head,3,xm430_w350\n";
    SerialScene test({"walker.level=" + level, "walker.options.bus=" + bus.string()});
    SerialPort port(test.port());
    port.send(write_packet(head, 11, {0}));
    port.send(torque_on(head));
    port.send(write_packet(head, 102, {100, 0}));
    test.run(100ms);
    if (torque) {
      EXPECT_GT(test.head_angle(), 0.01);
    } else {
      EXPECT_EQ(test.head_angle(), 0);
    }
  }
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

// What its client has sent is in a recording, and comes again, also from the middle of a packet on a slow bus.
TEST(SerialSoftware, IsRepeatedFromARecording) {
  const std::filesystem::path ports = fixtures::temp_folder() / "ports";
  fixtures::RepeatableRun run{.scene = "walk",
                              .how = {.overrides = {"walker.controller=serial", "walker.level=articulated_dynamics",
                                                    "walker.options={baud_rate=57600, torque=true}"},
                                      .terminals = ports.string(),
                                      .cameras = false,
                                      .outside = {.notes = std::make_shared<ExternalInputLog>()}}};
  run.options.state_period = 20ms;
  run.play = [&](scene::Scene& scene, recording::Recorder&) {
    scene.simulation().step();
    for (const int pulses : {2300, 1800}) {
      SerialPort port(ports / "walker");
      EXPECT_TRUE(port.set_rate(9600));  // at which no device hears
      port.send(goal(head, 3000));
      scene.simulation().run(7ms);
      EXPECT_TRUE(port.set_rate(57600));
      for (int i = 0; i < 3; ++i) {
        port.send(goal(head, pulses + 20 * i));
        port.send(read_head);
        scene.simulation().run(37ms);
      }
      port.send(Bytes{0xFF, 0xFF, 0xFD});  // and no more
      scene.simulation().run(5ms);
    }
    scene.simulation().run(100ms);
    EXPECT_GT(std::abs(scene.simulation().world().entity("walker").object("j_head").get(properties::joint_position)),
              0.05);
  };
  fixtures::expect_repeatable(fixtures::record("serial.mcap", run));
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

// What its client had sent is done again at its instants, with bytes on their way; the client hears nothing of it.
TEST(SerialSoftware, GoingBackInTimeAnswersFromWhatItsClientHadSent) {
  for (const char* baud_rate : {"walker.options.baud_rate=0", "walker.options.baud_rate=57600"}) {
    SerialScene test({baud_rate});
    session::LiveSource course(*test.scene);
    course.begin();
    const auto go_to = [&](Duration time) {
      while (test.scene->simulation().now() < time) course.step();
    };
    const auto seek = [&](Duration time) { course.seek(time, {}, [] { return false; }); };
    go_to(20ms);
    SerialPort port(test.port());
    port.send(torque_on(head));
    port.send(write_packet(head, 112, long_word(50)));
    go_to(220ms);
    port.send(goal(head, 2500));
    port.send(read_head);
    go_to(222ms);  // the answer is on its way, if bytes take time
    const std::vector<std::byte> then = test.scene->save();
    go_to(400ms);
    port.send(goal(head, 1800));
    go_to(700ms);
    const std::vector<std::byte> last = test.scene->save();
    for (int i = 0; i < 5; ++i) (void)port.answer();
    seek(222ms);
    EXPECT_TRUE(test.scene->save() == then) << baud_rate;
    EXPECT_EQ(course.diagnostic(),
              "software of walker keeps its own state: from 0.222 s on this is not the run that was there before");
    seek(700ms);
    EXPECT_TRUE(test.scene->save() == last) << baud_rate;
    seek(222ms);
    go_to(260ms);
    port.send(read_head);
    go_to(300ms);
    EXPECT_TRUE(port.answer().has_value()) << "it goes on live";
  }
}

/// [ms] from a goal to the moment at which the robot has it; -1: not within a second.
int goal_takes(const std::vector<std::string>& link) {
  SerialScene test(link);
  SerialPort port(test.port());
  port.send(torque_on(head));
  test.run(500ms);
  port.send(goal(head, 2300));
  for (int ms = 0; ms < 1000; ++ms) {
    if (test.robot().object("j_head").get(properties::joint_target) > 0.1) return ms;
    test.run(1ms);
  }
  return -1;
}

TEST(SerialSoftware, ALinkDelaysAndLosesCommands) {
  const int at_once = goal_takes({});
  ASSERT_GE(at_once, 0);
  EXPECT_LE(at_once, 2);
  EXPECT_EQ(goal_takes({"walker.link.delay=0.05"}), at_once + 50);
  const int late = goal_takes({"walker.link.delay=0.05", "walker.link.jitter=0.04"});
  EXPECT_GE(late, at_once + 50);
  EXPECT_LT(late, at_once + 90);
  EXPECT_EQ(goal_takes({"walker.link.loss=1"}), -1);
  // a row of commands takes half a millisecond more than there is from one to the next: after half a second 250 ms wait
  const std::size_t numbers = 21U * 6;  // target, torque, three of the servo, LED
  const double bandwidth = 8 * static_cast<double>(numbers) / 1.5e-3;
  const int narrow = goal_takes({fmt::format("walker.link.bandwidth={}", bandwidth), "walker.link.signals=false"});
  EXPECT_NEAR(narrow, 250, 10);
}

TEST(SerialSoftware, ALinkDelaysWhatIsRead) {
  SerialScene test({"walker.link.delay=0.05", "walker.link.commands=false"});
  SerialPort port(test.port());
  port.send(torque_on(head));
  test.run(200ms);
  port.send(goal(head, 2300));
  test.run(200ms);
  const auto read_back = [&] {
    (void)port.answer();
    port.send(read_head);
    test.run(2ms);
    std::optional<Packet> answer;
    while (const auto next = port.answer()) answer = next;
    return number(answer);
  };
  EXPECT_EQ(read_back(), 2300);
  port.send(goal(head, 2048));
  int before = 0;
  while (test.head_angle() > 0.01 && before < 500) test.run(1ms), ++before;
  EXPECT_GT(read_back(), 2060) << "it is there, and was not read yet";
  test.run(200ms);
  EXPECT_EQ(read_back(), 2048);
  const auto& link = control_software::software_report(test.robot())->link;
  ASSERT_TRUE(link);
  EXPECT_EQ(link->signals.longest, 50ms);
  EXPECT_EQ(link->commands.sent, 0U);
}

// Its client is killed in the middle of a packet; the other robot's goes on, and when all is over nothing is left open.
TEST(SerialSoftware, APortThatIsClosedDisturbsNobodyElse) {
  const std::size_t before = open_files();
  {
    const std::filesystem::path folder = fixtures::temp_folder() / "two_ports";
    scene::Scene scene("three_on_three", {.overrides = {"blue1.controller=serial", "blue2.controller=serial"},
                                          .terminals = folder.string(),
                                          .cameras = false});
    scene.simulation().step();
    const std::size_t with_scene = open_files();
    SerialPort first(folder / "blue1"), second(folder / "blue2");
    second.send(torque_on(head));
    scene.simulation().run(20ms);
    (void)second.answer();
    for (int i = 0; i < 40; ++i) {
      if (i < 10) first.send(read_head);
      if (i == 10) {
        const Bytes half = dynamixel::to_bytes(goal(head, 3000));
        first.send(dynamixel::ByteView(half).first(7));
        first.hang_up();
      }
      second.send(goal(head, 2100 + 10 * i));
      scene.simulation().run(10ms);
      int answers = 0;
      while (second.answer()) ++answers;
      EXPECT_GE(answers, 1) << i;
    }
    Entity& other = scene.simulation().world().entity("blue2");
    EXPECT_NEAR(other.object("j_head").get(properties::joint_target), (2490 - 2048) / pulses_per_radian, 1e-6);
    const auto& said = control_software::software_report(scene.simulation().world().entity("blue1"))->said;
    ASSERT_EQ(said.size(), 2U);  // opened, closed
    EXPECT_TRUE(fixtures::says(said[1].text, {"blue1 was closed; torque and goals stay as they are"}));
    second.hang_up();
    scene.simulation().run(2ms);
    EXPECT_EQ(open_files(), with_scene);
  }
  EXPECT_EQ(open_files(), before);
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
}  // namespace murosimf::serial
