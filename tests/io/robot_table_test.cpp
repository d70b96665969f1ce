/// robot_table_test - servos, surfaces and soles from TOML; mistakes are named with file, line and column.
#include "murosimf/io/robot_table.h"

#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"

namespace murosimf::io {
namespace {

std::filesystem::path write(const std::string& text) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto file = std::filesystem::path(testing::TempDir()) / (std::string("table_") + test->name() + ".toml");
  std::ofstream(file) << text;
  return file;
}

RobotTable read(const std::string& text) { return read_robot_table(write(text)); }

/// What follows the file name in the complaint about `text`.
std::string complaint(const std::string& text) {
  const auto file = write(text);
  try {
    (void)read_robot_table(file);
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
         "\nno_load_rate = 5\nposition_gain = 4\nrotor_inertia = 0.1\ncoulomb_friction = 0.2\n" + joints + "\n";
}

TEST(RobotTable, ReadsWhatIsThere) {
  const RobotTable table =
      read("[soles]\nleft = 'l'\nright = 'r'\n[surfaces]\ndefault = 'plastic'\nfoot = 'rubber'\n" + servo());
  EXPECT_TRUE(table.is_sole("l"));
  EXPECT_TRUE(table.is_sole("r"));
  EXPECT_FALSE(table.is_sole("x"));
  EXPECT_EQ(table.surface("foot"), "rubber");
  EXPECT_EQ(table.surface("head"), "plastic");
  ASSERT_EQ(table.servos.size(), 2u);
  const Servo& b = table.servos.at("b").servo;
  EXPECT_EQ(b.type, "x");
  EXPECT_EQ(b.stall_torque, 6);
  EXPECT_EQ(b.no_load_rate, 5);
  EXPECT_EQ(b.position_gain, 4);
  EXPECT_EQ(b.rotor_inertia, 0.1);
  EXPECT_EQ(b.coulomb_friction, 0.2);
}

TEST(RobotTable, MayBeEmptyOrMissing) {
  EXPECT_FALSE(read("").names_soles());
  EXPECT_TRUE(read_table_beside("nowhere/robot.xml").servos.empty());
  EXPECT_THROW((void)read_robot_table("nowhere/robot.toml"), SetupError);
}

TEST(RobotTable, Kid21NamesAServoForEachJoint) {
  const auto table = read_table_beside(std::filesystem::path(MUROSIMF_SOURCE_DIR) / "models/kid21.xml");
  EXPECT_EQ(table.servos.size(), 21u);
  EXPECT_EQ(table.surface("r_foot"), "rubber");
}

TEST(RobotTable, NamesUnknownKeys) {
  EXPECT_EQ(complaint("\n[sols]\n"), ":2:2: unknown table 'sols'; did you mean 'soles'?");
  EXPECT_EQ(complaint("[soles]\nlet = 'l'\n"), ":2:1: unknown sole 'let'; did you mean 'left'?");
  EXPECT_EQ(complaint(servo("stall_torqe = 1")),
            ":7:1: unknown key of a servo 'stall_torqe'; did you mean 'stall_torque'?");
}

TEST(RobotTable, NamesBadValues) {
  EXPECT_EQ(complaint(servo("joints = ['a']", "nan")), ":2:16: 'stall_torque' must be a finite number, at least 0");
  EXPECT_EQ(complaint(servo("joints = ['a']", "-1")), ":2:16: 'stall_torque' must be a finite number, at least 0");
  EXPECT_EQ(complaint(servo("joints = ['a']", "'6'")), ":2:16: 'stall_torque' must be a finite number, at least 0");
  EXPECT_TRUE(complaint(servo("joints = ['a']", "0")).starts_with(":1:9: servo 'x' cannot move"));
  EXPECT_EQ(complaint("soles = 3\n"), ":1:1: 'soles' must be a table, like [soles]");
  EXPECT_EQ(complaint("[surfaces]\nfoot = 3\n"), ":2:8: 'foot' must be a name in quotes");
}

TEST(RobotTable, NamesWhatAServoLacks) {
  EXPECT_EQ(complaint("[servos.x]\nstall_torque = 1\n"), ":1:9: servo 'x' needs coulomb_friction");
  EXPECT_EQ(complaint(servo("")), ":1:9: servo 'x' needs joints = [\"...\"]");
  EXPECT_TRUE(complaint(servo("joints = ['a', 'a']")).starts_with(":7:16: joint 'a' has servo 'x' already"));
}

TEST(RobotTable, NamesBrokenText) { EXPECT_TRUE(complaint("[soles\n").starts_with(":1:7: ")); }

TEST(RobotTable, NamesWhatTheRobotDoesNotHave) {
  const RobotTable table = read(servo("joints = ['knee_lft']"));
  try {
    check_names(table, {"knee_left", "knee_right"}, {}, {});
    FAIL();
  } catch (const SetupError& error) {
    EXPECT_NE(std::string(error.what()).find(":7:11: unknown joint 'knee_lft'; did you mean 'knee_left'?"),
              std::string::npos);
  }
  EXPECT_NO_THROW(check_names(table, {"knee_lft"}, {}, {}));
}

}  // namespace
}  // namespace murosimf::io
