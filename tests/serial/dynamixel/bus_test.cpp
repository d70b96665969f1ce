// Devices on a bus: which of them answer, what is written, what is refused, in both protocols.
#include "murosimf/serial/dynamixel/bus.h"

#include <gtest/gtest.h>

#include <numbers>
#include <tuple>

#include "murosimf/serial/dynamixel/imu_board.h"
#include "murosimf/serial/dynamixel/packet_parser.h"
#include "murosimf/serial/dynamixel/servo_device.h"

namespace murosimf::serial::dynamixel {
namespace {

constexpr Protocol v1 = Protocol::v1, v2 = Protocol::v2;

/// What a client sees of an answer.
struct Seen {
  int id = -1, error = -1;
  Bytes data;
  bool operator==(const Seen&) const = default;
};

Seen seen(const Bytes& bytes) {
  PacketParser parser;
  parser.push(bytes);
  const auto packet = parser.next();
  if (!packet) return {};
  if (packet->protocol == v1) return {packet->id, packet->instruction, packet->parameters};
  return {packet->id, packet->parameters.at(0), {packet->parameters.begin() + 1, packet->parameters.end()}};
}

/// Servos of a model with ids from 1 on.
struct TestBus {
  explicit TestBus(const std::string& model, int servos = 3) : protocol(find_servo_table(model)->protocol) {
    for (int id = 1; id <= servos; ++id) add(model, id);
  }
  void add(const std::string& model, int id, const ServoOptions& options = {}) {
    auto device = std::make_unique<ServoDevice>(*find_servo_table(model), static_cast<std::uint8_t>(id), options);
    servos.push_back(device.get());
    bus.add(std::move(device));
  }
  std::vector<Seen> send(int id, Instruction instruction, const Bytes& parameters = {}) {
    std::vector<Seen> answers;
    const Packet packet{protocol, static_cast<std::uint8_t>(id), static_cast<std::uint8_t>(instruction), parameters};
    for (const BusAnswer& answer : bus.execute(packet)) answers.push_back(seen(answer.bytes));
    return answers;
  }
  Bytes place(std::size_t address) const {
    return protocol == v1 ? Bytes{static_cast<std::uint8_t>(address)}
                          : Bytes{static_cast<std::uint8_t>(address & 0xFF), static_cast<std::uint8_t>(address >> 8)};
  }
  /// The error byte; -1: no answer.
  int write(int id, std::size_t address, const Bytes& data, Instruction instruction = Instruction::write) {
    Bytes parameters = place(address);
    append(parameters, data);
    const std::vector<Seen> answers = send(id, instruction, parameters);
    return answers.empty() ? -1 : answers[0].error;
  }
  Seen read(int id, std::size_t address, std::size_t size) {
    Bytes parameters = place(address);
    append(parameters, place(size));
    const std::vector<Seen> answers = send(id, Instruction::read, parameters);
    return answers.empty() ? Seen{} : answers[0];
  }
  std::int32_t number(int id, std::size_t address, std::size_t size) {
    const Bytes data = read(id, address, size).data;
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < data.size(); ++i) bits |= std::uint32_t{data[i]} << 8 * i;
    return static_cast<std::int32_t>(bits);
  }

  Protocol protocol;
  Bus bus;
  std::vector<ServoDevice*> servos;
};

Bytes long_word(std::int32_t value) {
  Bytes bytes;
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift & 0xFF));
  return bytes;
}
Bytes short_word(int value) { return {static_cast<std::uint8_t>(value & 0xFF), static_cast<std::uint8_t>(value >> 8)}; }

constexpr int broadcast = 0xFE;
constexpr double turn = 2 * std::numbers::pi;

TEST(ControlTable, FieldsStandInOrderAndStartWithinTheirRanges) {
  for (const std::string& name : servo_table_names()) {
    const ControlTable& table = *find_servo_table(name);
    std::size_t end = 0;
    for (const Field& field : table.fields) {
      EXPECT_GE(field.address, end) << table.name;
      EXPECT_TRUE(field.size == 1 || field.size == 2 || field.size == 4) << table.name << field.address;
      if (field.access != Access::read_only) {
        EXPECT_LE(field.lowest, field.initial) << table.name << ' ' << field.address;
        EXPECT_GE(field.highest, field.initial) << table.name << ' ' << field.address;
      }
      end = field.end();
    }
    for (const Item item :
         {Item::model_number, Item::id, Item::goal_position, Item::present_position, Item::shutdown}) {
      EXPECT_TRUE(table.find(item)) << table.name;
    }
  }
}

/// ROBOTIS e-Manual: model number, address of goal and present position.
TEST(ControlTable, IsThatOfTheModel) {
  const std::vector<std::tuple<std::string, int, int, int>> models{
      {"mx28", 29, 30, 36},           {"mx64", 310, 30, 36},          {"mx106", 320, 30, 36},
      {"mx28_2", 30, 116, 132},       {"mx64_2", 311, 116, 132},      {"mx106_2", 321, 116, 132},
      {"xm430_w350", 1020, 116, 132}, {"xh430_w350", 1000, 116, 132}, {"xm540_w270", 1120, 116, 132},
      {"xl330_m288", 1200, 116, 132}, {"xl330_m077", 1190, 116, 132}, {"xl430_w250", 1060, 116, 132},
      {"xc330_t288", 1220, 116, 132}, {"xc430_w150", 1070, 116, 132}, {"ax12", 12, 30, 36}};
  for (const auto& [name, number, goal, present] : models) {
    TestBus test(name, 1);
    EXPECT_EQ(test.number(1, 0, 2), number) << name;
    EXPECT_EQ(find_servo_table(name)->find(Item::goal_position)->address, goal);
    EXPECT_EQ(find_servo_table(name)->find(Item::present_position)->address, present);
  }
  EXPECT_EQ(find_servo_table("mx29"), nullptr);
}

TEST(Bus, AnswersPings) {
  TestBus old("mx28"), modern("xm430_w350");
  EXPECT_EQ(old.send(2, Instruction::ping), (std::vector<Seen>{{2, 0, {}}}));
  EXPECT_EQ(modern.send(2, Instruction::ping), (std::vector<Seen>{{2, 0, {0xFC, 0x03, 45}}}));
  EXPECT_TRUE(old.send(9, Instruction::ping).empty());
  modern.add("xm430_w350", 0);  // answers come in the order of the ids
  std::vector<int> ids;
  for (const Seen& answer : modern.send(broadcast, Instruction::ping)) ids.push_back(answer.id);
  EXPECT_EQ(ids, (std::vector{0, 1, 2, 3}));
  EXPECT_EQ(old.send(broadcast, Instruction::ping).size(), 3U);
}

TEST(Bus, EachServoKnowsItsProtocolOnly) {
  TestBus test("mx28", 1);
  test.add("xm430_w350", 1);
  EXPECT_EQ(test.send(1, Instruction::ping), (std::vector<Seen>{{1, 0, {}}}));
  test.protocol = v2;
  EXPECT_EQ(test.send(1, Instruction::ping), (std::vector<Seen>{{1, 0, {0xFC, 0x03, 45}}}));
}

TEST(Bus, RefusesAsTheManualSays) {
  TestBus modern("xm430_w350");
  EXPECT_EQ(modern.write(1, 0, {1, 0}), error_v2::access);  // read only
  EXPECT_EQ(modern.write(1, 66, {1}), error_v2::access);    // no such address
  EXPECT_EQ(modern.write(1, 64, {2}), error_v2::data_range);
  EXPECT_EQ(modern.write(1, 116, {0, 1}), error_v2::data_length);          // two bytes of four
  EXPECT_EQ(modern.write(1, 116, long_word(4096)), error_v2::data_limit);  // beyond Max Position Limit
  EXPECT_EQ(modern.write(1, 104, long_word(201)), error_v2::data_limit);   // beyond Velocity Limit
  EXPECT_EQ(modern.write(1, 11, {2}), error_v2::data_range);               // no such mode
  EXPECT_EQ(modern.write(1, 64, {1}), 0);
  EXPECT_EQ(modern.write(1, 7, {5}), error_v2::access);  // EEPROM while the torque is on
  EXPECT_EQ(modern.send(1, static_cast<Instruction>(0x33))[0].error, error_v2::instruction);
  EXPECT_EQ(modern.send(1, Instruction::action)[0].error, error_v2::instruction);
  EXPECT_EQ(modern.send(1, Instruction::read, {0x84})[0].error, error_v2::data_length);
  EXPECT_EQ(modern.read(1, 600, 100).error, error_v2::access);
  EXPECT_EQ(modern.number(1, 116, 4), 2048);  // nothing of it was done

  TestBus old("mx28");
  EXPECT_EQ(old.write(1, 36, {0, 0}), error_v1::range);
  EXPECT_EQ(old.write(1, 24, {2}), error_v1::range);
  EXPECT_EQ(old.write(1, 8, short_word(3000)), 0);  // CCW angle limit
  EXPECT_EQ(old.write(1, 30, short_word(3001)), error_v1::angle_limit);
  EXPECT_EQ(old.write(1, 30, short_word(3000)), 0);
  EXPECT_EQ(old.send(1, Instruction::action)[0].error, error_v1::instruction);
  EXPECT_EQ(old.send(1, Instruction::reboot)[0].error, error_v1::instruction);
  EXPECT_EQ(old.read(1, 70, 100).error, error_v1::range);
  EXPECT_EQ(old.write(1, 47, {1}), 0);  // lock
  EXPECT_EQ(old.write(1, 3, {7}), error_v1::range);
}

TEST(Bus, WritesNothingIfAnyOfItIsRefused) {
  TestBus test("xm430_w350");
  Bytes data = long_word(50);  // profile velocity, then a goal out of its limits
  append(data, long_word(5000));
  EXPECT_EQ(test.write(1, 112, data), error_v2::data_limit);
  EXPECT_EQ(test.number(1, 112, 4), 0);
}

TEST(Bus, RegisteredWritesWaitForTheAction) {
  for (const std::string model : {"mx28", "mx28_2"}) {
    TestBus test(model);
    const bool old = test.protocol == v1;
    const std::size_t goal = old ? 30 : 116, size = old ? 2 : 4, registered = old ? 44 : 69;
    const Bytes to = old ? short_word(1000) : long_word(1000);
    EXPECT_EQ(test.write(1, goal, to, Instruction::reg_write), 0);
    EXPECT_EQ(test.write(2, goal, to, Instruction::reg_write), 0);
    EXPECT_EQ(test.number(1, goal, size), 2048);
    EXPECT_EQ(test.number(1, registered, 1), 1);
    EXPECT_TRUE(test.send(broadcast, Instruction::action).empty());
    EXPECT_EQ(test.number(1, goal, size), 1000);
    EXPECT_EQ(test.number(2, goal, size), 1000);
    EXPECT_EQ(test.number(3, goal, size), 2048);
    EXPECT_EQ(test.number(1, registered, 1), 0);
  }
}

TEST(Bus, SyncAndBulkWritesAreNotAnswered) {
  TestBus modern("xm430_w350"), old("mx64");
  Bytes sync{0x74, 0x00, 0x04, 0x00, 1};
  append(sync, long_word(150));
  sync.push_back(3);
  append(sync, long_word(170));
  sync.push_back(2);  // cut off: nothing for it
  EXPECT_TRUE(modern.send(broadcast, Instruction::sync_write, sync).empty());
  EXPECT_EQ(modern.number(1, 116, 4), 150);
  EXPECT_EQ(modern.number(3, 116, 4), 170);
  EXPECT_EQ(modern.number(2, 116, 4), 2048);
  Bytes bulk{1, 116, 0, 4, 0};
  append(bulk, long_word(99));
  append(bulk, Bytes{2, 65, 0, 1, 0, 1});
  EXPECT_TRUE(modern.send(broadcast, Instruction::bulk_write, bulk).empty());
  EXPECT_EQ(modern.number(1, 116, 4), 99);
  EXPECT_EQ(modern.number(2, 65, 1), 1);
  EXPECT_TRUE(old.send(broadcast, Instruction::sync_write, {30, 2, 1, 0x10, 0x01, 2, 0x20, 0x02}).empty());
  EXPECT_EQ(old.number(1, 30, 2), 0x110);
  EXPECT_EQ(old.number(2, 30, 2), 0x220);
}

TEST(Bus, SyncAndBulkReadsAnswerInTheirOrderUntilOneIsMissing) {
  TestBus modern("xm430_w350"), old("mx64");
  const auto ids = [](const std::vector<Seen>& answers) {
    std::vector<int> found;
    for (const Seen& answer : answers) found.push_back(answer.id);
    return found;
  };
  EXPECT_EQ(ids(modern.send(broadcast, Instruction::sync_read, {0x84, 0, 4, 0, 3, 1, 2})), (std::vector{3, 1, 2}));
  EXPECT_EQ(ids(modern.send(broadcast, Instruction::sync_read, {0x84, 0, 4, 0, 3, 9, 2})), (std::vector{3}));
  const auto bulk = modern.send(broadcast, Instruction::bulk_read, {2, 0x90, 0, 2, 0, 1, 0x92, 0, 1, 0});
  EXPECT_EQ(bulk, (std::vector<Seen>{{2, 0, {120, 0}}, {1, 0, {25}}}));
  const auto old_bulk = old.send(broadcast, Instruction::bulk_read, {0, 2, 1, 0x1E, 1, 2, 0x2B, 2, 1, 0});
  EXPECT_EQ(old_bulk, (std::vector<Seen>{{1, 0, {0x00, 0x08}}, {2, 0, {25}}}));  // the second of id 1 is ignored
}

TEST(Bus, StatusReturnLevelKeepsThemSilent) {
  for (const std::string model : {"mx28", "mx28_2"}) {
    TestBus test(model);
    const std::size_t level = test.protocol == v1 ? 16 : 68, led = test.protocol == v1 ? 25 : 65;
    EXPECT_EQ(test.write(1, level, {1}), -1);
    EXPECT_EQ(test.write(1, led, {1}), -1);
    EXPECT_EQ(test.number(1, led, 1), 1);
    EXPECT_EQ(test.write(1, level, {0}), -1);
    EXPECT_EQ(test.read(1, led, 1), Seen{});
    EXPECT_EQ(test.send(1, Instruction::ping).size(), 1U);
    EXPECT_EQ(test.write(1, level, {2}), 0);
  }
}

TEST(Bus, IdsChangeAndHaveASecondOne) {
  TestBus test("xm430_w350");
  EXPECT_EQ(test.write(1, 7, {40}), 0);  // answered from the old id
  EXPECT_TRUE(test.send(1, Instruction::ping).empty());
  EXPECT_EQ(test.send(40, Instruction::ping).size(), 1U);
  EXPECT_EQ(test.write(2, 12, {100}), 0);
  EXPECT_EQ(test.write(3, 12, {100}), 0);
  EXPECT_EQ(test.write(100, 65, {1}), -1);
  EXPECT_EQ(test.number(2, 65, 1), 1);
  EXPECT_EQ(test.number(3, 65, 1), 1);
  EXPECT_EQ(test.number(40, 65, 1), 0);
}

TEST(Bus, RebootForgetsTheRamAndFactoryResetEverything) {
  TestBus test("xm430_w350");
  const auto change = [&] {
    EXPECT_EQ(test.write(2, 24, long_word(33)), 0);  // EEPROM
    EXPECT_EQ(test.write(2, 84, short_word(333)), 0);
    EXPECT_EQ(test.write(2, 64, {1}), 0);
  };
  change();
  const auto wait = [&] {
    for (ServoDevice* servo : test.servos) servo->advance(BusDevice::start_time);
  };
  EXPECT_EQ(test.send(2, Instruction::reboot)[0].error, 0);
  EXPECT_TRUE(test.send(2, Instruction::ping).empty()) << "it starts";
  EXPECT_EQ(test.send(1, Instruction::ping).size(), 1U) << "others do not";
  wait();
  EXPECT_EQ(test.number(2, 24, 4), 33);
  EXPECT_EQ(test.number(2, 84, 2), 800);
  EXPECT_FALSE(test.servos[1]->torque());
  change();
  EXPECT_EQ(test.send(2, Instruction::factory_reset, {0x01})[0].error, 0);
  wait();
  EXPECT_EQ(test.number(2, 24, 4), 10);
  EXPECT_TRUE(test.send(broadcast, Instruction::factory_reset, {0xFF}).empty());  // refused: all would be number 1
  EXPECT_EQ(test.send(3, Instruction::ping).size(), 1U);
  EXPECT_EQ(test.send(3, Instruction::factory_reset, {0x07})[0].error, error_v2::data_range);
  EXPECT_EQ(test.send(3, Instruction::factory_reset, {0xFF})[0].id, 3);
  wait();
  EXPECT_EQ(test.send(1, Instruction::ping).size(), 2U);  // as on a real bus: two have one id now
}

TEST(ServoDevice, TellsWhatItFeelsInTheUnitsOfItsModel) {
  TestBus modern("xm430_w350", 1), load("mx28_2", 1), old("mx64", 1);
  const ServoSense sense{turn / 4, -1.0, 2.05, 11.1, 41.6};
  for (TestBus* test : {&modern, &load, &old}) test->servos[0]->sense(sense, 33.0);
  EXPECT_EQ(modern.number(1, 132, 4), 2048 + 1024);
  EXPECT_EQ(modern.number(1, 128, 4), -42);  // 1 rad/s = 9.549 rpm = 41.7 of 0.229 rpm
  EXPECT_EQ(modern.number(1, 126, 2), 428);  // half of 2.3 A in 2.69 mA
  EXPECT_EQ(modern.number(1, 144, 2), 111);
  EXPECT_EQ(modern.number(1, 146, 1), 42);
  EXPECT_EQ(modern.number(1, 120, 2), 33000 - 32768);
  EXPECT_EQ(modern.number(1, 122, 1), 1);
  EXPECT_EQ(load.number(1, 126, 2), 820);  // of 2.5 N m
  EXPECT_EQ(old.number(1, 36, 2), 2048 + 1024);
  EXPECT_EQ(old.number(1, 38, 2), 84 | 0x400);  // 83.8 of 0.114 rpm, clockwise
  EXPECT_EQ(old.number(1, 40, 2), 342);         // of 6 N m, counterclockwise
  EXPECT_EQ(old.number(1, 68, 2), 2048 + 311);  // 1.4 A in 4.5 mA
  EXPECT_EQ(old.number(1, 42, 1), 111);
}

TEST(ServoDevice, MovesOnlyWithTorqueAndStaysWhereItIsSwitchedOn) {
  TestBus test("xm430_w350", 1);
  ServoDevice& servo = *test.servos[0];
  servo.sense({0.5}, 0);
  EXPECT_EQ(test.write(1, 116, long_word(3000)), 0);
  servo.advance(0.01);
  EXPECT_NEAR(servo.target(), 0.5, 1e-9);
  EXPECT_EQ(test.write(1, 64, {1}), 0);
  servo.advance(0.01);
  EXPECT_NEAR(servo.target(), 0.5, 1e-9);
  EXPECT_EQ(test.number(1, 116, 4), 2374);
  EXPECT_EQ(test.write(1, 116, long_word(3000)), 0);
  servo.advance(0.01);
  EXPECT_NEAR(servo.target(), (3000 - 2048) * turn / 4096, 1e-9);
}

TEST(ServoDevice, AGoalSwitchesAnOldServoOn) {
  TestBus test("mx28", 1);
  EXPECT_EQ(test.write(1, 30, short_word(1024)), 0);
  test.servos[0]->advance(0.01);
  EXPECT_EQ(test.number(1, 24, 1), 1);
  EXPECT_NEAR(test.servos[0]->target(), -turn / 4, 1e-9);
}

TEST(ServoDevice, ProfileVelocityLimitsItsWay) {
  for (const std::string model : {"mx28", "xm430_w350"}) {
    TestBus test(model, 1);
    const bool old = test.protocol == v1;
    EXPECT_EQ(test.write(1, old ? 24 : 64, {1}), 0);
    EXPECT_EQ(test.write(1, old ? 32 : 112, old ? short_word(100) : long_word(100)), 0);
    EXPECT_EQ(test.write(1, old ? 30 : 116, old ? short_word(3072) : long_word(3072)), 0);
    for (int i = 0; i < 100; ++i) test.servos[0]->advance(0.001);
    const double rate = 100 * (old ? 0.114 : 0.229) * turn / 60;
    EXPECT_NEAR(test.servos[0]->target(), 0.1 * rate, 1e-9) << model;
    for (int i = 0; i < 3000; ++i) test.servos[0]->advance(0.001);
    EXPECT_NEAR(test.servos[0]->target(), turn / 4, 1e-9) << model;
  }
}

TEST(ServoDevice, TurnsInVelocityModeUntilItsEnd) {
  TestBus test("xm430_w350", 0);
  test.add("xm430_w350", 1, {.lowest = -0.3, .highest = 0.2});
  ServoDevice& servo = *test.servos[0];
  EXPECT_EQ(test.write(1, 11, {1}), 0);
  EXPECT_EQ(test.write(1, 64, {1}), 0);
  EXPECT_EQ(test.write(1, 104, long_word(-50)), 0);
  servo.advance(0.1);
  EXPECT_NEAR(servo.target_velocity(), -50 * 0.229 * turn / 60, 1e-12);
  EXPECT_NEAR(servo.target(), 0.1 * servo.target_velocity(), 1e-9);
  servo.advance(10);
  EXPECT_NEAR(servo.target(), -0.3, 1e-12);

  TestBus old("mx28", 1);  // wheel mode: both angle limits 0
  EXPECT_EQ(old.write(1, 8, short_word(0)), 0);
  EXPECT_EQ(old.write(1, 24, {1}), 0);
  EXPECT_EQ(old.write(1, 32, short_word(0x400 | 100)), 0);
  EXPECT_NEAR(old.servos[0]->target_velocity(), -100 * 0.114 * turn / 60, 1e-12);
}

TEST(ServoDevice, HomingOffsetMovesTheZero) {
  TestBus test("xm430_w350", 1);
  ServoDevice& servo = *test.servos[0];
  EXPECT_EQ(test.write(1, 20, long_word(-500)), 0);
  servo.sense({0}, 0);
  EXPECT_EQ(test.number(1, 132, 4), 1548);
  EXPECT_EQ(test.write(1, 64, {1}), 0);
  EXPECT_EQ(test.write(1, 116, long_word(1548 + 1024)), 0);
  servo.advance(0.01);
  EXPECT_NEAR(servo.target(), turn / 4, 1e-9);
}

TEST(ServoDevice, HeatSwitchesItOff) {
  TestBus modern("xm430_w350", 1), old("mx28", 1);
  for (TestBus* test : {&modern, &old}) {
    EXPECT_EQ(test->write(1, test->protocol == v1 ? 24 : 64, {1}), 0);
    test->servos[0]->sense({.temperature = 95}, 0);
    EXPECT_FALSE(test->servos[0]->torque());
  }
  EXPECT_EQ(modern.number(1, 70, 1), 4);
  EXPECT_EQ(modern.write(1, 65, {1}), error_v2::alert);
  EXPECT_EQ(old.write(1, 25, {1}), error_v1::overheating);
  for (TestBus* test : {&modern, &old}) test->servos[0]->sense({}, 0);
  EXPECT_EQ(old.write(1, 24, {1}), 0);  // over when the cause is
  EXPECT_EQ(modern.write(1, 64, {1}), error_v2::alert | error_v2::result_fail);
  EXPECT_EQ(modern.send(1, Instruction::reboot)[0].error, 0);
  modern.servos[0]->advance(BusDevice::start_time);
  EXPECT_EQ(modern.write(1, 64, {1}), 0);
  modern.servos[0]->sense({.voltage = 9}, 0);  // tells, and goes on: not in Shutdown
  EXPECT_TRUE(modern.servos[0]->torque());
  EXPECT_EQ(modern.number(1, 70, 1), 1);
}

TEST(ServoDevice, StateGoesOn) {
  TestBus first("xm430_w350", 1), second("xm430_w350", 1);
  EXPECT_EQ(first.write(1, 64, {1}), 0);
  EXPECT_EQ(first.write(1, 112, long_word(30)), 0);
  EXPECT_EQ(first.write(1, 116, long_word(4000)), 0);
  EXPECT_EQ(first.write(1, 116, long_word(1000), Instruction::reg_write), 0);
  first.servos[0]->advance(0.1);
  std::vector<std::byte> bytes;
  StateArchive save(bytes);
  first.servos[0]->state(save);
  StateArchive load{std::span<const std::byte>(bytes)};
  second.servos[0]->state(load);
  for (TestBus* test : {&first, &second}) {
    test->servos[0]->advance(0.1);
    EXPECT_EQ(test->send(1, Instruction::action)[0].error, 0);
    test->servos[0]->advance(0.05);
  }
  EXPECT_EQ(first.servos[0]->target(), second.servos[0]->target());
  EXPECT_EQ(second.number(1, 116, 4), 1000);
}

TEST(ImuBoard, ShowsItsSampleInBothProtocols) {
  const std::vector<double> rates{0.5, -1.25, 40}, accelerations{0, -9.81, 3};
  for (const Protocol protocol : {v1, v2}) {
    TestBus test("mx28", 0);
    test.protocol = protocol;
    auto board = std::make_unique<ImuBoard>(protocol, 200);
    board->sense({65537, 70.0, rates, accelerations});
    test.bus.add(std::move(board));
    EXPECT_EQ(test.number(200, 0, 2), imu_model_number);
    EXPECT_EQ(test.number(200, 36, 2), 1);
    EXPECT_EQ(test.number(200, 38, 2), 70000 - 65536);
    const Bytes data = test.read(200, 40, 12).data;
    std::vector<int> numbers;
    for (std::size_t i = 0; i < 12; i += 2) numbers.push_back(static_cast<std::int16_t>(word(data, i)));
    EXPECT_EQ(numbers, (std::vector{500, -1250, 32767, 0, -981, 300}));
  }
}

}  // namespace
}  // namespace murosimf::serial::dynamixel
