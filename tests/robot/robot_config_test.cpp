/// robot_config_test - servos, surfaces and soles from TOML; errors have file, line and column.
#include "murosimf/robot/robot_config.h"

#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/component_files/servo_table.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/model/error.h"
#include "murosimf/robot/robot_reader.h"
#include "tests/temp_folder.h"

namespace murosimf::robot {
namespace {

std::filesystem::path write(const std::string& text) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto file = fixtures::temp_folder() / (std::string("table_") + test->name() + ".toml");
  std::ofstream(file) << text;
  return file;
}

RobotConfig read(const std::string& text) { return read_robot_config(write(text)); }

/// The error of `text` after the file name.
std::string complaint(const std::string& text) {
  const auto file = write(text);
  try {
    (void)read_robot_config(file);
  } catch (const SetupError& error) {
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with(file.string())) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
    return message.substr(file.string().size());
  }
  return "no SetupError";
}

std::string servo(const std::string& joints = "joints = ['a', 'b']", const std::string& torque = "6") {
  return "[servos.x]\nstall_torque = " + torque +
         "\nno_load_speed = 5\nposition_gain = 4\nrotor_inertia = 0.1\ncoulomb_friction = 0.2\n" + joints + "\n";
}

TEST(RobotConfig, ReadsWhatIsThere) {
  const RobotConfig table =
      read("[soles]\nleft = 'l'\nright = 'r'\n[surfaces]\ndefault = 'plastic'\nfoot = 'rubber'\n" + servo());
  ASSERT_EQ(table.soles.size(), 2u);
  EXPECT_EQ(table.soles[0].name, "l");
  EXPECT_EQ(table.soles[1].name, "r");
  EXPECT_EQ(table.surface("foot"), "rubber");
  EXPECT_EQ(table.surface("head"), "plastic");
  ASSERT_EQ(table.servos.size(), 2u);
  const Servo& b = table.servos.at("b").servo;
  EXPECT_EQ(b.type, "x");
  EXPECT_EQ(b.stall_torque, 6);
  EXPECT_EQ(b.no_load_speed, 5);
  EXPECT_EQ(b.position_gain, 4);
  EXPECT_EQ(b.rotor_inertia, 0.1);
  EXPECT_EQ(b.friction.coulomb, 0.2);
  EXPECT_EQ(b.law, "dc_motor");
  EXPECT_EQ(b.duty_limit, 1);
  EXPECT_EQ(b.torque_limit, 0);
}

/// The servo of joint 'a' in a section [servos.x] with `lines` from line 2 on.
std::string section(const std::string& lines) { return "[servos.x]\n" + lines + "\njoints = ['a']\n"; }
Servo servo_of(const std::string& lines) { return read(section(lines)).servos.at("a").servo; }

TEST(RobotConfig, ReadsWhatAServoMayHaveToo) {
  const Servo a = read(servo("joints = ['a']\nlaw = 'dc_motor'\nvoltage = 12\nduty_limit = 0.9\ntorque_limit = 3\n"
                             "viscous_friction = 0.3\ncommand_delay = 0.01"))
                      .servos.at("a")
                      .servo;
  EXPECT_EQ(a.voltage, 12);
  EXPECT_EQ(a.duty_limit, 0.9);
  EXPECT_EQ(a.torque_limit, 3);
  EXPECT_EQ(a.friction.viscous, 0.3);
  EXPECT_EQ(a.command_delay, 0.01);
}

TEST(RobotConfig, ReadsFirmwareBacklashAndHeatOfAServo) {
  const Servo a = servo_of(
      "type = 'mx64'\nbacklash = 0.01\nencoder_step = 0.0015\ndead_band = 0.002\ncommand_period = 0.008\n"
      "heat_capacity = 40\nthermal_resistance = 8\nambient_temperature = -5\nderating_temperature = 60\n"
      "temperature_limit = 80");
  EXPECT_EQ(a.backlash, 0.01);
  EXPECT_EQ(a.encoder_step, 0.0015);
  EXPECT_EQ(a.dead_band, 0.002);
  EXPECT_EQ(a.command_period, 0.008);
  EXPECT_EQ(a.heat.heat_capacity, 40);
  EXPECT_EQ(a.heat.thermal_resistance, 8);
  EXPECT_EQ(a.heat.ambient_temperature, -5);
  EXPECT_EQ(a.heat.derating_temperature, 60);
  EXPECT_EQ(a.heat.temperature_limit, 80);
}

TEST(RobotConfig, StartsFromAReadyMadeServo) {
  const Servo mx64 = component_files::read_servo("mx64");
  const Servo a = servo_of("type = 'mx64'\ncoulomb_friction = 0.2");
  EXPECT_EQ(a.type, "mx64");
  EXPECT_EQ(a.friction.coulomb, 0.2);
  EXPECT_EQ(a.friction.viscous, mx64.friction.viscous);
  EXPECT_EQ(a.stall_torque, mx64.stall_torque);
  EXPECT_EQ(a.position_gain, mx64.position_gain);
}

TEST(RobotConfig, AnotherVoltageScalesAReadyMadeServo) {
  const Servo mx64 = component_files::read_servo("mx64");
  const Servo a = servo_of("type = 'mx64'\nvoltage = 18\nposition_gain = 7");
  EXPECT_EQ(a.voltage, 18);
  EXPECT_DOUBLE_EQ(a.stall_torque, 1.5 * mx64.stall_torque);
  EXPECT_DOUBLE_EQ(a.no_load_speed, 1.5 * mx64.no_load_speed);
  EXPECT_EQ(a.position_gain, 7);  // said for the new voltage
  EXPECT_EQ(a.friction.coulomb, mx64.friction.coulomb);
  EXPECT_DOUBLE_EQ(servo_of("type = 'mx64'\nvoltage = 6").position_gain, 0.5 * mx64.position_gain);
}

TEST(RobotConfig, ACurrentLimitBecomesATorque) {
  // k_t = voltage / no_load_speed = 12 V / (5 rad/s) = 2.4 N m/A, at any voltage
  const std::string numbers = servo("joints = ['a']\nvoltage = 12\ncurrent_limit = 2");
  EXPECT_DOUBLE_EQ(read(numbers).servos.at("a").servo.torque_limit, 4.8);
  const double torque = servo_of("type = 'mx64'\ncurrent_limit = 2").torque_limit;
  EXPECT_NEAR(torque, 2 * 1.622, 1e-3);
  EXPECT_NEAR(servo_of("type = 'mx64'\nvoltage = 15\ncurrent_limit = 2").torque_limit, torque, 1e-12);
}

TEST(RobotConfig, ReadsAnIdealServo) {
  const Servo a = servo_of("law = 'ideal_pd'\nposition_gain = 30\nrotor_inertia = 0.01\nvelocity_gain = 2");
  EXPECT_EQ(a.law, "ideal_pd");
  EXPECT_EQ(a.position_gain, 30);
  EXPECT_EQ(a.velocity_gain, 2);
  EXPECT_EQ(a.stall_torque, 0);
  EXPECT_EQ(servo_of("law = 'ideal_pd'\nposition_gain = 1\nrotor_inertia = 0\nstall_torque = 5").stall_torque, 5);
  EXPECT_EQ(servo_of("type = 'mx64'\nlaw = 'ideal_pd'\nvelocity_gain = 1").position_gain,
            component_files::read_servo("mx64").position_gain);
}

/// Writes a servo file beside the table of this test and returns its type.
std::string servo_file(const std::string& text) {
  const auto file = fixtures::temp_folder() /
                    (std::string("servo_") + testing::UnitTest::GetInstance()->current_test_info()->name() + ".toml");
  std::ofstream(file) << text;
  return file.stem().string();
}
const std::string own_servo =
    "stall_torque = 6\nno_load_speed = 5\nposition_gain = 4\nrotor_inertia = 0.1\ncoulomb_friction = 0.2\n";

TEST(RobotConfig, FindsServoFilesBesideIt) {
  const std::string type = servo_file(own_servo);
  const Servo a = servo_of("type = '" + type + "'\nno_load_speed = 8");
  EXPECT_EQ(a.type, type);
  EXPECT_EQ(a.stall_torque, 6);
  EXPECT_EQ(a.no_load_speed, 8);
}

TEST(RobotConfig, NamesMistakesInServoFiles) {
  const auto complaint_of = [](const std::string& text, const std::string& more = "") {
    return complaint(section("type = '" + servo_file(text) + "'\n" + more));
  };
  const std::string file = (fixtures::temp_folder() / "servo_NamesMistakesInServoFiles.toml").string();
  EXPECT_EQ(complaint_of("law = 'dc_motor'\nstall_torque = -1\n"),
            ":2:8: " + file + ":2:16: 'stall_torque' must be a finite number, at least 0");
  EXPECT_EQ(complaint_of("stall = 1\n"),
            ":2:8: " + file + ":1:1: unknown key of a servo 'stall'; did you mean 'stall_torque'?");
  EXPECT_EQ(complaint_of(own_servo + "joints = ['a']\n").substr(0, 6), ":2:8: ");
  EXPECT_EQ(complaint_of("stall_torque = 1\nno_load_speed = 2\n"),
            ":2:8: " + file +
                ":1:1: servo 'servo_NamesMistakesInServoFiles' needs position_gain, rotor_inertia, coulomb_friction");
  EXPECT_TRUE(complaint_of(own_servo, "voltage = 12")
                  .starts_with(":3:11: servo type 'servo_NamesMistakesInServoFiles' "
                               "does not say at which voltage its numbers hold"));
}

/// Writes a file into the folder of a test's table.
std::string motion_file(const std::string& name, const std::string& text) {
  std::ofstream(fixtures::temp_folder() / (name + ".toml")) << text;
  return name + ".toml";
}

TEST(RobotConfig, ReadsMotionsByWhatTheyAreFor) {
  const std::string wave =
      motion_file("wave", "columns = ['a']\nstart = [1]\n[[frames]]\nduration = 1\nvalues = [2]\n");
  const auto motions = read("[motions]\nwave = '" + wave + "'\nkick_left = 'kick'\n").motions;
  ASSERT_EQ(motions.size(), 2U);
  EXPECT_EQ(motions.at("wave").motion.start, std::vector<double>{1});
  EXPECT_EQ(motions.at("kick_left").motion.name, "kick") << "one of the program's";
}

TEST(RobotConfig, NamesMistakesInMotions) {
  EXPECT_EQ(complaint("[motions]\nkick = 'kik'\n"), ":2:8: unknown motion 'kik'; did you mean 'kick'?");
  EXPECT_EQ(complaint("[motions]\nkick = 3\n"), ":2:8: 'kick' must be a name in quotes");
  const std::string bad = motion_file("bad_motion", "columns = []\n");
  const std::string file = (fixtures::temp_folder() / bad).string();
  EXPECT_TRUE(
      complaint("[motions]\nkick = '" + bad + "'\n").starts_with(":2:8: " + file + ":1:11: 'columns' must list"));
}

TEST(RobotConfig, GivesMotionsToTheModelAsItPlaysThem) {
  const auto kid21 = std::filesystem::path(MUROSIMF_SOURCE_DIR) / "models/kid21.xml";
  const auto copy = fixtures::temp_folder() / "with_motions.xml";
  std::filesystem::copy_file(kid21, copy, std::filesystem::copy_options::overwrite_existing);
  const std::string left = motion_file("of_left", "mirror_of = 'kick'\n");
  motion_file("with_motions", "[motions]\nkick_right = 'kick'\nkick_left = '" + left + "'\n");
  const ModelPtr model = read_robot(copy).model;
  const locomotion::NamedMotions* motions = model->find(properties::given_motions, 0);
  ASSERT_NE(motions, nullptr);
  ASSERT_EQ(motions->size(), 2U);
  EXPECT_EQ((*motions)[0].name, "kick_left") << "in the order of names";
  const auto* kick_left = locomotion::motion_named(*motions, "kick_left");
  const auto* kick_right = locomotion::motion_named(*motions, "kick_right");
  ASSERT_TRUE(kick_left && kick_right);
  EXPECT_EQ(locomotion::motion_named(*motions, "dance"), nullptr);
  EXPECT_EQ(kick_right->columns[2][0].name, "right_foot.x");
  EXPECT_EQ(kick_left->columns[2][0].name, "left_foot.x");
  EXPECT_FALSE(kick_left->other_side) << "nothing is left to be mirrored";
}

TEST(RobotConfig, MayBeEmptyOrMissing) {
  EXPECT_TRUE(read("").soles.empty());
  EXPECT_TRUE(read_table_beside("nowhere/robot.xml").servos.empty());
  EXPECT_THROW((void)read_robot_config("nowhere/robot.toml"), SetupError);
}

TEST(RobotConfig, Kid21NamesAServoForEachJoint) {
  const auto table = read_table_beside(std::filesystem::path(MUROSIMF_SOURCE_DIR) / "models/kid21.xml");
  EXPECT_EQ(table.servos.size(), 21u);
  EXPECT_EQ(table.surface("r_foot"), "rubber");
}

TEST(RobotConfig, NamesUnknownKeys) {
  EXPECT_EQ(complaint("\n[sols]\n"), ":2:2: unknown table 'sols'; did you mean 'soles'?");
  EXPECT_EQ(complaint("[soles]\nlet = 'l'\n"), ":2:1: unknown sole 'let'; did you mean 'left'?");
  EXPECT_EQ(complaint(servo("stall_torqe = 1")),
            ":7:1: unknown key of a servo 'stall_torqe'; did you mean 'stall_torque'?");
}

TEST(RobotConfig, NamesBadValues) {
  EXPECT_EQ(complaint(servo("joints = ['a']", "nan")), ":2:16: 'stall_torque' must be a finite number, at least 0");
  EXPECT_EQ(complaint(servo("joints = ['a']", "-1")), ":2:16: 'stall_torque' must be a finite number, at least 0");
  EXPECT_EQ(complaint(servo("joints = ['a']", "'6'")), ":2:16: 'stall_torque' must be a finite number, at least 0");
  EXPECT_TRUE(complaint(servo("joints = ['a']", "0")).starts_with(":1:9: servo 'x' cannot move"));
  EXPECT_EQ(complaint("soles = 3\n"), ":1:1: 'soles' must be a table, like [soles]");
  EXPECT_EQ(complaint("[surfaces]\nfoot = 3\n"), ":2:8: 'foot' must be a name in quotes");
}

TEST(RobotConfig, NamesBadNumbersOfServos) {
  const std::string infinite = "'viscous_friction' must be a finite number, at least 0";
  EXPECT_EQ(complaint(section("type = 'mx64'\nviscous_friction = inf")), ":3:20: " + infinite);
  EXPECT_EQ(complaint(section("type = 'mx64'\nviscous_friction = -0.1")), ":3:20: " + infinite);
  EXPECT_EQ(complaint(section("type = 'mx64'\nviscous_friction = true")), ":3:20: " + infinite);
  EXPECT_EQ(complaint(section("type = 'mx64'\nbacklash = 2")),
            ":3:12: 'backlash' is in radians; more than 0.5 is no play of a gear");
  EXPECT_EQ(complaint(section("type = 'mx64'\nheat_capacity = 40")),
            ":1:9: servo 'x' gets warm: it needs heat_capacity and thermal_resistance, both above 0");
  EXPECT_EQ(complaint(section("type = 'mx64'\nheat_capacity = 40\nthermal_resistance = 8\nderating_temperature = 90\n"
                              "temperature_limit = 80")),
            ":1:9: servo 'x' gets warm: derating_temperature must be above 0 and below temperature_limit");
  EXPECT_EQ(complaint(section("type = 'mx64'\nambient_temperature = 300")),
            ":3:23: 'ambient_temperature' must be a temperature in degrees Celsius, at most 200");
  EXPECT_EQ(complaint(section("type = 'mx64'\ncommand_delay = 1e6")),
            ":3:17: 'command_delay' is in seconds; more than 1 is no delay of a bus");
  const std::string duty = ":3:14: 'duty_limit' must be a number above 0, at most 1";
  for (const char* number : {"0", "1.01", "nan", "'1'"}) {
    EXPECT_EQ(complaint(section(std::string("type = 'mx64'\nduty_limit = ") + number)), duty);
  }
  EXPECT_EQ(complaint(section("type = 'mx64'\nvoltage = 0")), ":3:11: 'voltage' must be a finite number above 0");
  EXPECT_EQ(complaint(section("type = 'mx64'\ncurrent_limit = 0")),
            ":3:17: 'current_limit' must be a finite number above 0");
  EXPECT_EQ(complaint(section("type = 'mx64'\ncurrent_limit = 1\ntorque_limit = 1")),
            ":3:17: 'current_limit' and 'torque_limit' limit the same; keep one");
  const std::string large = " of servo 'x' is not finite; voltage or current is too large";
  EXPECT_EQ(complaint(section("type = 'mx64'\nvoltage = 1e308")), ":1:9: position_gain" + large);
  EXPECT_EQ(complaint(section("type = 'mx64'\ncurrent_limit = 1.7e308")), ":1:9: torque_limit" + large);
}

TEST(RobotConfig, NamesUnknownTypesAndLaws) {
  EXPECT_EQ(complaint(section("type = 'mx65'")), ":2:8: unknown servo type 'mx65'; did you mean 'mx64'?");
  EXPECT_EQ(complaint(section("type = 64")), ":2:8: 'type' must be a name in quotes");
  EXPECT_EQ(complaint(section("law = 'dc_moter'")), ":2:7: unknown servo law 'dc_moter'; did you mean 'dc_motor'?");
  EXPECT_EQ(complaint(section("law = 1")), ":2:7: 'law' must be a name in quotes");
  EXPECT_EQ(complaint(section("type = 'mx64'\nvelocity_gain = 1")),
            ":3:1: 'velocity_gain' means nothing to servo law 'dc_motor'; remove it");
  EXPECT_EQ(complaint(section("law = 'ideal_pd'\nduty_limit = 1")),
            ":3:1: 'duty_limit' means nothing to servo law 'ideal_pd'; remove it");
}

TEST(RobotConfig, NamesWhatAServoLacks) {
  EXPECT_EQ(complaint("[servos.x]\nstall_torque = 1\n"),
            ":1:9: servo 'x' needs no_load_speed, position_gain, rotor_inertia, coulomb_friction");
  EXPECT_EQ(complaint(section("law = 'ideal_pd'\nstall_torque = 1")),
            ":1:9: servo 'x' needs position_gain, rotor_inertia");
  EXPECT_EQ(complaint(servo("current_limit = 1")), ":1:9: servo 'x' needs voltage, because of current_limit");
  EXPECT_EQ(complaint(servo("")), ":1:9: servo 'x' needs joints = [\"...\"]");
  EXPECT_TRUE(complaint(servo("joints = ['a', 'a']")).starts_with(":7:16: joint 'a' has servo 'x' already"));
}

TEST(RobotConfig, NamesBrokenText) { EXPECT_TRUE(complaint("[soles\n").starts_with(":1:7: ")); }

TEST(RobotConfig, NamesWhatTheRobotDoesNotHave) {
  const RobotConfig table = read(servo("joints = ['knee_lft']"));
  try {
    check_names(table, {.joints = {"knee_left", "knee_right"}});
    FAIL();
  } catch (const SetupError& error) {
    EXPECT_NE(std::string(error.what()).find(":7:11: unknown joint 'knee_lft'; did you mean 'knee_left'?"),
              std::string::npos);
  }
  EXPECT_NO_THROW(check_names(table, {.joints = {"knee_lft"}}));
}

TEST(RobotConfig, RateLimitsAreThoseOfTheTable) {
  EXPECT_EQ(complaint("\n[rate_limits]\na = -1\n"), ":3:5: the largest rate of 'a' must be a number from 0");
  EXPECT_EQ(complaint("\n[rate_limits]\na = 'x'\n"), ":3:5: the largest rate of 'a' must be a number from 0");
}

TEST(RobotConfig, RestPositionsAreNumbersOfJoints) {
  const RobotConfig table = read("[rest_positions]\na = -1.5\nb = 1\n");
  EXPECT_EQ(table.rest_positions.at("a").number, -1.5);
  EXPECT_EQ(table.rest_positions.at("b").number, 1);
  EXPECT_NO_THROW(check_names(table, {.joints = {"a", "b"}}));
  EXPECT_THROW(check_names(table, {.joints = {"a"}}), SetupError);
  EXPECT_EQ(complaint("\n[rest_positions]\na = 'x'\n"), ":3:5: the rest position of 'a' must be a number");
  EXPECT_EQ(complaint("\n[rest_positions]\na = nan\n"), ":3:5: the rest position of 'a' must be a number");
}

TEST(RobotConfig, RestPositionsAreInTheRangesOfTheirJoints) {
  const auto table = write("");
  const auto file = std::filesystem::path(table).replace_extension(".xml");
  std::ofstream(file)
      << "<mujoco><worldbody><body name='trunk'><freejoint/><geom size='0.1' mass='1'/><body name='arm'><joint "
         "name='a' axis='1 0 0' range='-90 0'/><geom size='0.1' mass='1'/></body></body></worldbody></mujoco>";
  std::ofstream(table) << "[rest_positions]\na = -1.5\n";
  const ModelPtr model = read_robot(file).model;
  EXPECT_EQ(*model->find(properties::rest_position, model->object_index("a")), -1.5);
  std::ofstream(table) << "[rest_positions]\na = 0.5\n";
  try {
    (void)read_robot(file);
    FAIL();
  } catch (const SetupError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find(":2:1: the rest position of 'a', 0.5, is not in its range, -1.57"), std::string::npos)
        << message;
  }
}

TEST(RobotConfig, LinkagesNameTheJointsThatTakeTargets) {
  const RobotConfig table = read("[linkages]\ncommanded = ['pitch', 'roll']\n");
  ASSERT_EQ(table.commanded.size(), 2U);
  EXPECT_EQ(table.commanded[1].name, "roll");
  EXPECT_NO_THROW(check_names(table, {.joints = {"pitch", "roll"}}));
  EXPECT_THROW(check_names(table, {.joints = {"pitch"}}), SetupError);
  EXPECT_EQ(complaint("\n[linkages]\ncommand = ['a']\n"),
            ":3:1: unknown key of [linkages] 'command'; did you mean 'commanded'?");
  EXPECT_EQ(complaint("\n[linkages]\ncommanded = 'a'\n"), ":3:1: commanded must be a list of names, like [\"torso\"]");
}

TEST(RobotConfig, SizesOfSolesAreLengthAndWidth) {
  const std::string bad = "the size of sole 'a' must be [length, width], both more than 0";
  EXPECT_EQ(complaint("\n[sole_sizes]\na = 1\n"), ":3:5: " + bad);
  EXPECT_EQ(complaint("\n[sole_sizes]\na = [0.2, 0]\n"), ":3:5: " + bad);
  EXPECT_EQ(complaint("\n[sole_sizes]\na = [0.2]\n"), ":3:5: " + bad);
}

}  // namespace
}  // namespace murosimf::robot
