// Messages of Booster robots against bytes that Python's struct makes of the vendor's member lists, and damaged ones.
#include "murosimf/dds/booster/messages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "murosimf/dds/booster/rpc.h"
#include "murosimf/dds/booster/visual_kick.h"

namespace murosimf::dds::booster {
namespace {

Bytes from_hex(const std::string& hex) {
  Bytes bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  return bytes;
}

// pack("<iI", 1, 2), then for each motor B, padding to 4, 6f
const Bytes two_motors = from_hex(
    "000100000100000002000000"
    "070000000000c03f000000c00000803e0000c8420000404000"
    "00803f"
    "08000000000000bf00000000000080c0000000000000003e0000003f");

TEST(BoosterMessages, ReadLowCommands) {
  const std::optional<LowCommand> command = read_low_command(two_motors);
  ASSERT_TRUE(command.has_value());
  EXPECT_EQ(command->kind, LowCommand::serial);
  ASSERT_EQ(command->motors.size(), 2U);
  const MotorCommand &first = command->motors[0], &second = command->motors[1];
  EXPECT_EQ(first.q, 1.5F);
  EXPECT_EQ(first.dq, -2.0F);
  EXPECT_EQ(first.tau, 0.25F);
  EXPECT_EQ(first.kp, 100.0F);
  EXPECT_EQ(first.kd, 3.0F);
  EXPECT_EQ(first.weight, 1.0F);
  EXPECT_EQ(second.tau, -4.0F);
  EXPECT_EQ(second.weight, 0.5F);
}

TEST(BoosterMessages, RefuseCommandsThatAreNone) {
  for (std::size_t size = 0; size < two_motors.size(); ++size)
    EXPECT_FALSE(read_low_command(std::span(two_motors).first(size))) << size;
  Bytes unknown_kind = two_motors, many = two_motors, no_number = two_motors;
  unknown_kind[4] = 9;
  EXPECT_FALSE(read_low_command(unknown_kind));
  many[8] = most_motors + 1;
  EXPECT_FALSE(read_low_command(many));
  const float nan = std::nanf("");
  std::memcpy(&no_number[16], &nan, sizeof nan);
  EXPECT_FALSE(read_low_command(no_number));
}

TEST(BoosterMessages, WriteLowStates) {
  CdrWriter writer;
  const MotorState motor{.q = 0.5F, .dq = -1, .ddq = 2, .tau = -3, .temperature = 40};
  write_low_state(writer, {{0.1F, -0.2F, 0.3F}, {1, 2, 3}, {0, 0, 9.81F}}, {&motor, 1});
  // pack("<9f", ...), then twice: I count, B mode, padding, 4f, B temperature, padding, 3I
  EXPECT_EQ(writer.bytes(),
            from_hex("00010000cdcccc3dcdcc4cbe9a99993e0000803f00000040000040400000000000000000c3f51c41"
                     "01000000000000000000003f000080bf00000040000040c028000000000000000000000000000000"
                     "01000000000000000000003f000080bf00000040000040c028000000000000000000000000000000"));
}

TEST(BoosterMessages, WriteStatesOfTheRobot) {
  const auto written = [](const auto& write) {
    CdrWriter writer;
    write(writer);
    return writer.bytes();
  };
  EXPECT_EQ(written([](CdrWriter& to) {
              write_odometer(to, {1, -2, 0.5});
            }),
            from_hex("000100000000803f000000c00000003f"));
  EXPECT_EQ(written([](CdrWriter& to) { write_fall_down(to, FallDown::fallen, true); }),
            from_hex("000100000200000001"));
  EXPECT_EQ(written([](CdrWriter& to) {
              write_robot_states(to, {-1, 3});
            }),
            from_hex("00010000ffffffff0300000000000000"));
  EXPECT_EQ(written([](CdrWriter& to) { write_battery(to, {.charge = 100}); }),
            from_hex("0001000000000000000000000000c84200000000"));
}

TEST(BoosterMessages, CarryRequests) {
  const Bytes bytes = from_hex("000100000300000061620000030000007b7d0000020000007800");
  const std::optional<RpcMessage> message = read_rpc(bytes);
  ASSERT_TRUE(message.has_value());
  EXPECT_EQ(message->uuid, "ab");
  EXPECT_EQ(message->header, "{}");
  EXPECT_EQ(message->body, "x");
  CdrWriter writer;
  write_rpc(writer, *message);
  EXPECT_EQ(writer.bytes(), bytes);
  for (std::size_t size = 0; size < bytes.size(); ++size) EXPECT_FALSE(read_rpc(std::span(bytes).first(size))) << size;
}

Bytes kick(double x, double direction, bool with_power) {
  CdrWriter to;
  to.number<std::int32_t>(7).number<std::uint32_t>(8).text("base").number(x).number(0.25).number(direction);
  to.number(4.0).number(1.0).number(0.5);  // goal, heading
  if (with_power) to.number(6.0);
  return to.bytes();
}

TEST(BoosterMessages, SayWhereTheBallIs) {
  for (const bool with_power : {false, true}) {
    const std::optional<KickTarget> target = read_kick(kick(1.5, 0.75, with_power));
    ASSERT_TRUE(target.has_value());
    EXPECT_EQ(target->x, 1.5);
    EXPECT_EQ(target->y, 0.25);
    EXPECT_EQ(target->direction, 0.75);
  }
  EXPECT_NEAR(read_kick(kick(1, 2 * std::numbers::pi + 0.5, true))->direction, 0.5, 1e-12);
  const Bytes bytes = kick(1, 0, false);
  for (std::size_t size = 0; size < bytes.size(); ++size) EXPECT_FALSE(read_kick(std::span(bytes).first(size))) << size;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Bytes& bad : {kick(nan, 0, true), kick(11, 0, true), kick(1, nan, true), kick(1, HUGE_VAL, true)})
    EXPECT_FALSE(read_kick(bad));
}

TEST(BoosterVisualKick, AsksForWhatIsSeen) {
  VisualKick kick;
  const KickTarget near{.x = 0.3, .y = 0.1, .direction = 0.5}, far{.x = 2, .y = 0, .direction = 0};
  kick.see(near, 10);
  EXPECT_FALSE(kick.request(11)) << "not started";
  EXPECT_TRUE(kick.start(20));
  EXPECT_EQ(kick.request(20)->x, 0.3);
  EXPECT_FALSE(kick.request(21)) << "nothing new";
  kick.see(far, 30);
  EXPECT_FALSE(kick.request(30)) << "too soon";
  EXPECT_EQ(kick.request(20 + VisualKick::request_interval)->x, 2);
  kick.stop();
  kick.see(near, 1000);
  EXPECT_FALSE(kick.request(1000));
  EXPECT_FALSE(kick.start(1001 + VisualKick::longest_age)) << "too old";
  EXPECT_FALSE(VisualKick().start(0)) << "nothing was seen";
}

// Whatever comes is read or refused, and what is read has finite numbers.
TEST(BoosterMessages, SurviveDamage) {
  std::mt19937 random(1);
  for (int round = 0; round < 20000; ++round) {
    Bytes bytes = two_motors;
    for (int i = 0; i < 3; ++i) bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    bytes.resize(random() % (bytes.size() + 1));
    if (const auto command = read_low_command(bytes)) {
      for (const MotorCommand& motor : command->motors) ASSERT_TRUE(std::isfinite(motor.q + motor.kp));
    }
    (void)read_rpc(bytes);
    (void)read_kick(bytes);
  }
}

RpcMessage asked(const std::string& header, const std::string& body = "") { return {"id", header, body}; }

TEST(BoosterRpc, AnswersByNumber) {
  const RpcHandlers handlers{{7, [](const RpcParameters& given) -> RpcAnswer {
                                const auto x = given.find("x"), on = given.find("on");
                                return {Status::success, std::to_string(x.value_or(-1) + on.value_or(0))};
                              }}};
  const auto answer = [&](const std::string& header, const std::string& body = "") {
    return answer_to(asked(header, body), handlers);
  };
  const RpcMessage good = answer(R"({"api_id":7,"call_mode":0,"more":[{}]})", R"({"x":1.5,"on":true,"text":"y"})");
  EXPECT_EQ(good.uuid, "id");
  EXPECT_EQ(good.header, R"({"status":0})");
  EXPECT_EQ(good.body, std::to_string(2.5));
  EXPECT_EQ(answer(R"({"api_id":7})", "").body, std::to_string(-1.0));
  EXPECT_EQ(answer(R"({"api_id":8})").header, R"({"status":501})");
  for (const char* header : {"", "{", "[]", "7", "{\"api_id\":\"7\"}", "{\"api_id\":7.5}", "{}", "\xff\xfe"})
    EXPECT_EQ(answer(header).header, R"({"status":400})") << header;
  for (const std::string& body : {std::string("{"), std::string("[1]"), std::string("\"x\""), std::string(100000, '[')})
    EXPECT_EQ(answer(R"({"api_id":7})", body).header, R"({"status":400})") << body.substr(0, 10);
}

}  // namespace
}  // namespace murosimf::dds::booster
