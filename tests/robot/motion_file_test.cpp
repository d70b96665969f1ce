// Files of key-frame motions: those that come with the program, and one clear line for every error.
#include "murosimf/robot/motion_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "murosimf/files/data_path.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/locomotion/keyframe_player.h"
#include "murosimf/model/error.h"
#include "murosimf/robot/robot_reader.h"
#include "murosimf/runtime/simulation.h"
#include "murosimf/scene/scene.h"
#include "tests/temp_folder.h"

namespace murosimf::robot {
namespace {

namespace fs = std::filesystem;

fs::path write(const std::string& text) {
  const fs::path file = fixtures::temp_folder() / ("motion_file_test." + std::to_string(::getpid()) + ".toml");
  std::ofstream(file) << text;
  return file;
}

std::string refusal(const std::string& text) {
  const fs::path file = write(text);
  std::string why;
  try {
    static_cast<void>(read_motion(file));
  } catch (const SetupError& error) {
    why = error.what();
  }
  fs::remove(file);
  return why;
}

void expect_refusal(const std::string& text, const std::vector<std::string>& parts) {
  const std::string why = refusal(text);
  EXPECT_EQ(why.find('\n'), std::string::npos);
  for (const std::string& part : parts) EXPECT_NE(why.find(part), std::string::npos) << text << " said: " << why;
}

TEST(MotionFile, ReadsColumnsSignsAndFrames) {
  const fs::path file =
      write("columns = [\"a\", [\"b\", \"-c\"]]\nstart = [1, 2]\n[[frames]]\nduration = 0.5\nvalues = [3, 4.5]\n");
  const locomotion::KeyframeMotion motion = read_motion(file);
  fs::remove(file);
  ASSERT_EQ(motion.columns.size(), 2U);
  EXPECT_EQ(motion.columns[1][1].name, "c");
  EXPECT_EQ(motion.columns[1][0].sign, 1);
  EXPECT_EQ(motion.columns[1][1].sign, -1);
  EXPECT_EQ(motion.start, (std::vector<double>{1, 2}));
  ASSERT_EQ(motion.frames.size(), 1U);
  EXPECT_EQ(motion.frames[0].duration, 0.5);
  EXPECT_EQ(motion.frames[0].values, (std::vector<double>{3, 4.5}));
}

TEST(MotionFile, SaysWhereAMistakeIs) {
  const std::string head = "columns = [\"a\"]\nstart = [0]\n";
  expect_refusal("", {"'columns'"});
  expect_refusal("columns = []\n", {":1:11: 'columns' must list"});
  expect_refusal("columns = [3]\n", {":1:12: a column is the name"});
  expect_refusal("columns = [\"a\", \"-a\"]\n", {":1:17: 'a' is set twice"});
  expect_refusal("columns = [\"a\"]\n", {"'start' must be 1 number in brackets"});
  expect_refusal("columns = [\"a\", \"b\"]\nstart = [0]\n", {":2:9: 'start' must be 2 numbers"});
  expect_refusal("columns = [\"a\"]\nstart = [nan]\n", {":2:9: 'start' must be finite"});
  expect_refusal(head, {"no [[frames]]"});
  expect_refusal(head + "[[frames]]\nvalues = [0]\n", {":3:1: 'duration' must be positive"});
  expect_refusal(head + "[[frames]]\nduration = -1\nvalues = [0]\n", {":4:12: 'duration' must be positive"});
  expect_refusal(head + "[[frames]]\nduration = nan\nvalues = [0]\n", {":4:12: 'duration' must be a finite number"});
  expect_refusal(head + "[[frames]]\nduration = 1\nvalues = [inf]\n", {":5:10: 'values' must be finite"});
  expect_refusal(head + "[[frames]]\nduration = 1\nvalue = [0]\n", {":5:1: unknown key 'value'", "'values'"});
}

/// In an own folder.
fs::path write_beside(const std::string& name, const std::string& text) {
  const fs::path folder = fixtures::temp_folder() / ("mirrors." + std::to_string(::getpid()));
  fs::create_directories(folder);
  std::ofstream(folder / name) << text;
  return folder / name;
}

std::string refusal_of(const fs::path& file) {
  try {
    static_cast<void>(read_motion(file));
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
}

TEST(MotionFile, IsTheMirrorImageOfAnother) {
  const fs::path right =
      write_beside("right.toml", "columns = ['a']\nstart = [1]\n[[frames]]\nduration = 1\nvalues = [2]\n");
  const locomotion::KeyframeMotion motion = read_motion(write_beside("left.toml", "mirror_of = 'right'\n"));
  EXPECT_EQ(motion.name, "left");
  EXPECT_TRUE(motion.other_side);
  EXPECT_EQ(motion.start, read_motion(right).start);
  EXPECT_FALSE(read_motion(right).other_side);
  EXPECT_TRUE(read_motion(write_beside("shipped.toml", "mirror_of = 'kick'\n")).other_side)
      << "of those of the program";
}

TEST(MotionFile, ReadsWhereTheBallLiesAndGoes) {
  const std::string rest = "columns = ['a']\nstart = [1]\n[[frames]]\nduration = 1\nvalues = [2]\n";
  const locomotion::KeyframeMotion motion =
      read_motion(write_beside("kick.toml", "kick = {ball = [0.2, -0.05], direction = 0.1}\n" + rest));
  ASSERT_TRUE(motion.kick);
  EXPECT_EQ(norm(motion.kick->ball - Vec3d{0.2, -0.05, 0}), 0);
  EXPECT_EQ(motion.kick->direction, 0.1);
  EXPECT_FALSE(read_motion(write_beside("none.toml", rest)).kick);
  for (const char* kick : {"{}", "{ball = [0.2]}", "{ball = [0.2, 0]}", "{ball = [0.2, 11]}", "{ball = 'here'}"})
    expect_refusal("kick = " + std::string(kick) + "\n" + rest, {":1:", "'ball' must be where the ball lies"});
  expect_refusal("kick = {ball = [0.2, 0.1], direction = 4}\n" + rest, {":1:", "'direction' must be from -pi to pi"});
  expect_refusal("kick = {ball = [0.2, 0.1], way = 4}\n" + rest, {":1:", "unknown key 'way'"});
}

TEST(MotionFile, SaysWhyItIsNoMirrorImage) {
  write_beside("left.toml", "mirror_of = 'right'\n");
  const auto why = [](const std::string& text) { return refusal_of(write_beside("bad.toml", text)); };
  const auto expect = [&](const std::string& text, const std::string& part) {
    EXPECT_NE(why(text).find(part), std::string::npos) << text << " said: " << why(text);
    EXPECT_EQ(why(text).find('\n'), std::string::npos);
  };
  expect("mirror_of = 'kik'\n", "bad.toml:1:13: unknown motion 'kik'; did you mean 'kick'?");
  expect("mirror_of = 'left'\n", "'left' is a mirror image itself");
  expect("mirror_of = 'bad'\n", "'bad' is a mirror image itself");
  expect("mirror_of = ''\n", "'mirror_of' must name a motion");
  expect("mirror_of = 3\n", ":1:13:");
  expect("mirror_of = 'kick'\nstart = [1]\n", "unknown key 'start'");
}

TEST(MotionFile, UnknownMotionsNameTheNearest) {
  try {
    static_cast<void>(find_motion("kik"));
    FAIL();
  } catch (const SetupError& error) {
    EXPECT_STREQ(error.what(), "unknown motion 'kik'; did you mean 'kick'?");
  }
}

std::string robot(const std::string& keys) { return "[[robots]]\nname = \"r\"\nmodel = \"kid21\"\n" + keys; }

TEST(MotionFile, EveryMotionOfTheProgramFitsItsRobot) {
  const auto names = files::data_file_names("motions", ".toml");
  EXPECT_GE(names.size(), 4U);
  for (const std::string& name : names) {
    const fs::path file = write(robot("controller = \"keyframes\"\nmotion = \"" + name + "\"\n"));
    scene::Scene scene(file);
    scene.simulation().run(from_seconds(0.1));
    EXPECT_FALSE(scene.simulation().world().entity("r").frozen()) << name;
    fs::remove(file);
  }
}

TEST(MotionFile, EveryMotionThatARobotNamesFitsIt) {
  int motions = 0;
  for (const std::string& name : files::data_file_names("models", ".xml")) {
    const ModelPtr model = read_robot(files::find_data_file(name, "models", ".xml")).model;
    const locomotion::NamedMotions* all = model->find(properties::given_motions, 0);
    if (!all) continue;
    for (const auto& [purpose, motion] : *all) {
      ++motions;
      Simulation simulation;
      Entity& robot = simulation.world().add("robot", model);
      simulation.attach<locomotion::KeyframePlayer>("keyframe_player", robot, locomotion::KeyframePlayer::rate_hz,
                                                    motion);
      simulation.run(from_seconds(duration(motion)));
      EXPECT_NEAR(robot.base().get(properties::motion_time), duration(motion), 0.01) << name << ": " << purpose;
    }
  }
  EXPECT_GE(motions, 12);
}

TEST(MotionFile, AKeyframePlayerNeedsAMotion) {
  const fs::path file = write(robot("controller = \"keyframes\"\n"));
  EXPECT_THROW(scene::Scene{file}, SetupError);
  fs::remove(file);
}

}  // namespace
}  // namespace murosimf::robot
