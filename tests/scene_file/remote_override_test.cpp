// What requests over a network may set in a scene: what is on the list, with values that name no file outside.
#include "murosimf/scene_file/remote_override.h"

#include <gtest/gtest.h>

#include <fstream>

#include "murosimf/files/data_path.h"
#include "murosimf/files/file_access.h"
#include "murosimf/model/error.h"
#include "murosimf/scene_file/key_list.h"
#include "murosimf/scene_file/setting_targets.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::scene_file {
namespace {

using fixtures::says;

/// Empty if it is allowed.
std::string complaint(const std::string& text) {
  const auto allowed = std::make_shared<const files::AllowedFiles>(files::program_folders());
  const files::FileScope only({.only_from = allowed});
  try {
    check_remote_override(text, fixtures::temp_folder());
    return {};
  } catch (const SetupError& error) {
    return error.what();
  }
}

TEST(RemoteOverride, NumbersAndNamesOfWhatIsThere) {
  for (const char* text : {"duration=5",
                           "seed = 3",
                           "rate=auto",
                           "rate=500",
                           "gravity=[0, 0, -1.6]",
                           "body_contact=carry",
                           "robot.level=full_dynamics",
                           "blue.*.level=kinematic_walking",
                           "*.contact=kelvin_voigt",
                           "robot.controller=none",
                           "robot.command=[0.1, 0, 0]",
                           "robot.command.0=0.1",
                           "robot.position=[1, 2]",
                           "robot.fixed_base=true",
                           "robot.sensors=false",
                           "robot.sensors.imu.rate=100",
                           "blue.*.sensors.imu.gyroscope.noise=0.1",
                           "robot.options.speed=1",
                           "defaults.level_options.x=2",
                           "robot.link.delay=0.01",
                           "robot.torso.mass=1.2",
                           "robot.torso.applied_force=[5,0,0,0,0,0]",
                           "ball.radius=0.1",
                           "ball.color=[1, 0, 0]",
                           "ball.ball.linear_velocity=[1,0,0]",
                           "field.surface=grass",
                           "light.name=hall",
                           "start.jitter_position=0.1",
                           "materials.friction=0.5",
                           "materials.plastic.wood.friction=0.5",
                           "box.mass=2",
                           "box.shape=sphere",
                           "communication.loss=0.1",
                           "body_contact_options.sweeps=3",
                           "robot.model=kid21",
                           "robot.motion=get_up_front",
                           "defaults.model=models/kid21.xml",
                           "robot.controller=of_a_plug_in"}) {
    EXPECT_EQ(complaint(text), "") << text;
  }
  for (const std::string_view property : joint_properties()) {
    EXPECT_EQ(complaint("robot." + std::string(property) + "=0.1"), "") << "of all joints: " << property;
  }
}

TEST(RemoteOverride, NothingThatLoadsSoftwareOrNamesFiles) {
  for (const char* text : {"robot.library=lib.so",
                           "*.library=/tmp/lib.so",
                           "blue.*.library=lib.so",
                           "defaults.library=lib.so",
                           "robot.reload=true",
                           "robot.call_budget=1",
                           "robot.controller=library",
                           "robot.controller=python",
                           "robot.options.class=soft:Walk",
                           "robot.controller=tcp",
                           "robot.controller=serial",
                           "defaults.controller=library",
                           "robot.controller=a/b",
                           "robot.controller=1",
                           "robot.options.file=/etc/passwd",
                           "robot.options.bus=x.csv",
                           "defaults.options.file=x",
                           "robot.sensors.cam.calibration=/etc/passwd",
                           "robot.sensors.cam.lens=x",
                           "robot.sensors.cam={lens=\"x\"}",
                           "robot.sensors={cam={lens=\"x\"}}",
                           "robot.options={file=\"x\"}",
                           "robot.link={delay=1}",
                           "robot.name=x",
                           "robots=[{name=\"a\", library=\"x\"}]",
                           "defaults={library=\"x\"}",
                           "robot.level={a=1}",
                           "name=x",
                           "league.answer_port=53",
                           "league.place_penalized=false",
                           "views.a.eye=[\"x\"]",
                           "light.name=/etc/passwd",
                           "robot.level=../x",
                           "robot.level=\"a b\"",
                           "box.name=x",
                           "robot.no_contact=[[\"a\", \"b\"]]",
                           "field={}",
                           "robot.torso.applied_force={force=[1,2,3]}",
                           "robot.model=[1]",
                           "robot.model=1",
                           "robot.motion=true"}) {
    EXPECT_FALSE(complaint(text).empty()) << text;
  }
}

TEST(RemoteOverride, FilesOnlyAmongThoseThatMayBeRead) {
  const auto file = fixtures::temp_folder() / "outside_model.xml";
  std::ofstream(file) << "<mujoco/>";
  const std::string there = complaint("robot.model=" + file.string());
  EXPECT_TRUE(says(there, {"'robot.model=", "no file"}));
  std::filesystem::remove(file);
  EXPECT_EQ(complaint("robot.model=" + file.string()), there) << "it does not tell whether a file is there";
  for (const char* text : {"robot.model=/etc/passwd", "robot.model=../../../../../../etc/passwd", "box.model=/dev/zero",
                           "robot.model=/proc/self/environ", "robot.motion=/etc/x.toml", "robot.motion=../x"}) {
    EXPECT_FALSE(complaint(text).empty()) << text;
  }
}

TEST(RemoteOverride, TextsOfOneLineThatAreNotTooLong) {
  EXPECT_TRUE(says(complaint("seed=1\nlibrary=2"), {"more than one line"}));
  EXPECT_TRUE(says(complaint("seed=" + std::string(3000, '1')), {"more than 2000 bytes"}));
  EXPECT_TRUE(says(complaint("seed"), {"write PATH=VALUE"}));
  EXPECT_TRUE(says(complaint("robot.level=" + std::string(100, 'a')), {"takes one name"}));
  EXPECT_TRUE(says(complaint("robot.library=x"), {"'library' is not among the settings", "docs/supervise.md"}));
}

// A list of what is allowed: a key that is new in a scene file is closed.
TEST(RemoteOverride, KeysThatAreClosed) {
  const auto closed = [](const std::string& section, const std::string& path) {
    std::vector<std::string> keys;
    for (const std::string_view key : names_of(*find_section(section))) {
      if (complaint(path + std::string(key) + "=0").find("not among the settings") != std::string::npos)
        keys.emplace_back(key);
    }
    return keys;
  };
  using Keys = std::vector<std::string>;
  EXPECT_EQ(closed("", ""), (Keys{"name", "body_contact_options", "start", "air", "field", "view", "views", "light",
                                  "ball", "teams", "defaults", "robots", "bodies", "materials", "events", "pushes",
                                  "communication", "league", "algorithms"}));
  EXPECT_EQ(closed("robots", "robot."), (Keys{"name", "body", "xacro", "options", "level_options", "contact_options",
                                              "library", "call_budget", "reload", "link", "keyframe", "no_contact"}));
  EXPECT_EQ(closed("bodies", "box."), (Keys{"name", "file", "heights"}));
  EXPECT_EQ(closed("league", "league."), (Keys{"place_penalized", "answer_port"}));
  for (const char* section : {"start", "air", "field", "view", "light", "ball", "communication"}) {
    EXPECT_EQ(closed(section, std::string(section) + "."), Keys{}) << section;
  }
}

}  // namespace
}  // namespace murosimf::scene_file
