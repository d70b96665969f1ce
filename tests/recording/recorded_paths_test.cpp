// A recording has nothing of the folders of the computer where it was made, and can be repeated elsewhere.
#include "murosimf/recording/recorded_paths.h"

#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

#include "tests/fixtures.h"
#include "tests/recording/repeatable_run.h"

namespace murosimf {
namespace {

using namespace recording;
namespace fs = std::filesystem;

class RecordedPathsTest : public testing::Test {
 protected:
  void SetUp() override {
    home_ = (folder_.path() / "home/alice").string();
    fs::create_directories(home_ + "/team/robots");
    if (const char* before = std::getenv("HOME")) before_ = before;
    ::setenv("HOME", home_.c_str(), 1);
  }
  void TearDown() override { ::setenv("HOME", before_.c_str(), 1); }

  fixtures::TempFolder folder_;
  std::string home_, before_;
};

TEST_F(RecordedPathsTest, FilesKeepTheirPlacesToEachOther) {
  const RecordedPaths paths({home_ + "/team/scenes/game.toml", home_ + "/team/robots/a.xml", "/opt/parts/imu.toml",
                             "/opt/parts/deep/gyro.toml", fs::path(MUROSIMF_SOURCE_DIR) / "models/kid21.xml"},
                            {});
  EXPECT_EQ(paths.reduced(home_ + "/team/scenes/game.toml"), "/user/scenes/game.toml");
  EXPECT_EQ(paths.reduced(home_ + "/team/scenes/../robots/a.xml"), "/user/robots/a.xml");
  EXPECT_EQ(paths.reduced("/opt/parts/deep/gyro.toml"), "/user_2/deep/gyro.toml");
  EXPECT_EQ(paths.reduced(fs::path(MUROSIMF_SOURCE_DIR) / "models/kid21.xml"), "/program/models/kid21.xml");
  EXPECT_EQ(paths.reduced("/somewhere/else.toml"), "/elsewhere/else.toml");
  EXPECT_EQ(paths.folders().at("/user"), "~/team\n");
}

TEST_F(RecordedPathsTest, PackagesKeepTheirNames) {
  const RecordedPaths paths({home_ + "/ws/my_robot/urdf/a.urdf", home_ + "/ws/my_robot/meshes/a.stl"}, {});
  EXPECT_EQ(paths.reduced(home_ + "/ws/my_robot/meshes/a.stl"), "/user/my_robot/meshes/a.stl");
}

TEST_F(RecordedPathsTest, TextsAndCommandLinesAreReduced) {
  const RecordedPaths paths({home_ + "/team/game.toml"}, {});
  EXPECT_EQ(paths.in_text("a.model=" + home_ + "/team/a.xml, " + home_ + "/notes, " + home_ + "2/x"),
            "a.model=/user/a.xml, ~/notes, " + home_ + "2/x");
  EXPECT_EQ(paths.in_command_line("/usr/local/bin/murosimf run '" + home_ +
                                  "/team/game.toml' --set a.model=/data/bob/a.xml "
                                  "--record /scratch/bob/x.mcap --out=../o.csv"),
            "murosimf run '/user/game.toml' --set a.model=a.xml --record x.mcap --out=../o.csv");
}

// Of a scene, a robot beside it, one by its whole name, and one in an option: none of it is there any more.
TEST_F(RecordedPathsTest, ARunIsRepeatedFromTheFileAlone) {
  const fs::path team = home_ + "/team", models = fs::path(MUROSIMF_SOURCE_DIR) / "models";
  for (const char* robot : {"beside", "whole", "option"}) {
    fs::copy_file(models / "kid21.xml", team / "robots" / (std::string(robot) + ".xml"));
    fs::copy_file(models / "kid21.toml", team / "robots" / (std::string(robot) + ".toml"));
  }
  fs::create_directory(team / "scenes");
  std::ofstream(team / "scenes/game.toml")
      << "duration = 1\n[[robots]]\nname = 'a'\nmodel = '../robots/beside.xml'\n"
      << "[[robots]]\nname = 'b'\nposition = [1, 0]\nmodel = '" << (team / "robots/whole.xml").string() << "'\n"
      << "[[robots]]\nname = 'c'\nposition = [2, 0]\nmodel = 'kid21'\n";
  const fs::path file =
      fixtures::record("shared.mcap",
                       {.scene = (team / "scenes/game.toml").string(),
                        .time = std::chrono::seconds(1),
                        .how = {.overrides = {"c.model=" + (team / "robots/option.xml").string()}, .cameras = false}});
  fs::rename(home_, folder_.path() / "gone");
  fixtures::expect_repeatable(file);
  const McapReader reader(file);
  for (const AttachmentIndex& one : reader.contents().attachments) {
    EXPECT_EQ(one.name.find("alice"), std::string::npos) << one.name;
    if (one.name == "files/user/scenes/game.toml") continue;  // what its author wrote
    EXPECT_EQ(reader.attachment(one).data.find("alice"), std::string::npos) << one.name;
  }
  for (const MetadataIndex& one : reader.contents().metadata) {
    for (const auto& [key, value] : reader.metadata(one).values) {
      EXPECT_EQ((key + value).find("alice"), std::string::npos) << key << ": " << value;
    }
  }
}

}  // namespace
}  // namespace murosimf
