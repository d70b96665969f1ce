// Tables of joint angles: what is read, and one clear line, with its place, for every error.
#include "murosimf/control_software/trajectory_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "murosimf/model/error.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::control_software {
namespace {

namespace fs = std::filesystem;

const double degree = pi / 180;

/// A hinge with a range, one without, and a slider.
Model two_hinges_and_a_slider() {
  return Model("arm", Chain{}
                          .base("base")
                          .with(properties::mass, 1.0)
                          .with(properties::inertia, {1, 1, 1, 0, 0, 0})
                          .revolute("shoulder", {0, 0, 1})
                          .with(properties::joint_range, {-1.0, 1.5, 0})
                          .revolute("elbow", {0, 1, 0})
                          .prismatic("hand", {1, 0, 0}));
}

class TrajectoryFile : public testing::Test {
 protected:
  void TearDown() override { fs::remove(file_); }
  JointTrajectory read(const std::string& text, const LogColumns& log = {.entity = "me"}) {
    std::ofstream(file_, std::ios::binary) << text;
    return read_trajectory(file_, model_, log);
  }
  std::string refusal(const std::string& text, const LogColumns& log = {.entity = "me"}) {
    return fixtures::error_of([&] { (void)read(text, log); });
  }
  void expect(const std::string& text, const std::string& after_file) {
    const std::string message = refusal(text);
    EXPECT_TRUE(message.starts_with(file_.string() + after_file)) << text << " said: " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
  Model model_ = two_hinges_and_a_slider();
  fs::path file_ = fixtures::temp_folder() / ("trajectory_file_test." + std::to_string(::getpid()) + ".csv");
};

TEST_F(TrajectoryFile, TakesUnitsAsTheHeaderSaysThem) {
  const JointTrajectory got =
      read("t [ms], elbow [deg],\"shoulder [rad]\",hand [mm]\r\n0, 90,0.5,250\r\n20,-45,,-1\r\n");
  ASSERT_EQ(got.joints.size(), 3U);
  EXPECT_EQ(got.joints[0].object, model_.object_index("elbow"));
  EXPECT_EQ(got.joints[0].times, (std::vector<double>{0, 0.02}));
  EXPECT_EQ(got.joints[0].values, (std::vector<double>{90 * degree, -45 * degree}));
  EXPECT_EQ(got.joints[1].object, model_.object_index("shoulder"));
  EXPECT_EQ(got.joints[1].times, std::vector<double>{0});  // an empty cell is no value
  EXPECT_EQ(got.joints[1].values, std::vector<double>{0.5});
  EXPECT_EQ(got.joints[2].values, (std::vector<double>{0.25, -0.001}));
  EXPECT_EQ(got.first, 0);
  EXPECT_EQ(got.last, 0.02);
}

TEST_F(TrajectoryFile, KnowsTheRateOfItsRows) {
  EXPECT_DOUBLE_EQ(*read("t [s],elbow [rad]\n0,1\n0.0083,1\n0.0167,1\n0.025,1\n").spacing, 0.025 / 3);
  EXPECT_FALSE(read("t [s],elbow [rad]\n0,1\n0.1,1\n0.3,1\n").spacing);
  EXPECT_FALSE(read("t [s],elbow [rad]\n0,1\n").spacing);
}

TEST_F(TrajectoryFile, TakesItsOwnColumnsOfALog) {
  const std::string log =
      "time [s],me.elbow.joint_target [rad],you.elbow.joint_target [rad],me.elbow.joint_position "
      "[rad],me.imu.gyroscope.x "
      "[rad/s]\n0,1,2,3,4\n";
  EXPECT_EQ(read(log).joints.size(), 1U);
  EXPECT_EQ(read(log).joints[0].values[0], 1);
  EXPECT_EQ(read(log, {.entity = "you"}).joints[0].values[0], 2);
  EXPECT_EQ(read(log, {.property = "joint_position", .entity = "me"}).joints[0].values[0], 3);
  // one robot alone need not be named
  EXPECT_EQ(read("time [s],you.elbow.joint_target [rad]\n0,2\n").joints[0].values[0], 2);
  EXPECT_NE(refusal("time [s],you.elbow.joint_target [rad]\n0,2\n", {.entity = "me", .no_other = true})
                .find(":1:1: this log has no column me.JOINT.joint_target"),
            std::string::npos);
  EXPECT_NE(refusal(log, {.entity = "nobody"}).find(":1:1: this log is of me, you; say whose"), std::string::npos);
  EXPECT_NE(refusal(log, {.property = "joint_torque", .entity = "me"}).find("no column me.JOINT.joint_torque"),
            std::string::npos);
}

TEST_F(TrajectoryFile, SaysWhereAMistakeIs) {
  const std::string head = "t [s],elbow [rad],shoulder [deg]\n";
  expect("", ":1:1: the file is empty");
  expect("0,1,2\n", ":1:1: a number where the first line should have a name");
  expect("t,elbow [rad]\n", ":1:1: 't' has no unit; write 't [s]' or '[ms]'");
  expect("t [s],elbow\n", ":1:7: 'elbow' has no unit; write 'elbow [rad]' or '[deg]'");
  expect("t [s],hand [deg]\n", ":1:7: 'hand' is in deg; known units: m, cm, mm");
  expect("t [s],elbw [rad]\n", ":1:7: model 'arm': unknown joint 'elbw'; did you mean 'elbow'?");
  expect("t [s],base [rad]\n", ":1:7: model 'arm': unknown joint 'base'");
  expect("t [s],elbow [rad],elbow [deg]\n", ":1:19: 'elbow' comes twice");
  expect("t [s]\n", ":1:1: there must be a column of time and at least one joint");
  expect("t [s],me.elbw.joint_target [rad]\n", ":1:7: model 'arm': unknown joint 'elbw'");
  expect(head, ":1:1: there are no numbers for 'elbow'");
  expect(head + "0,1,2\n0.1,1\n", ":3:1: 2 cells, where the first line has 3");
  expect(head + "0,1,2\n0.1,1,two\n", ":3:7: 'two' is no number");
  expect(head + "0,nan,2\n", ":2:3: 'elbow' must be a finite number");
  expect(head + "inf,1,2\n", ":2:1: the time must be a finite number");
  expect(head + "0,1,2\n\n0,1,2\n", ":4:1: the time 0 s does not come after 0 s");
  expect("t [s],shoulder [rad]\n0,1.5\n1,90\n",
         ":3:3: 'shoulder' at 90 rad is more than a turn beyond its range; are these degrees?");
  expect("t [s],elbow [rad]\n0,-6\n1,-7\n", ":3:3: 'elbow' at -7 rad is more than a turn beyond its range");
}

TEST_F(TrajectoryFile, IsRefusedIfItIsNotThere) {
  EXPECT_TRUE(fixtures::error_of([&] { (void)read_trajectory("/no/such.csv", model_); }).starts_with("/no/such.csv: "));
}

}  // namespace
}  // namespace murosimf::control_software
