#include "murosimf/viewer/key_map.h"

#include <fstream>
#include <set>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "tests/temp_folder.h"

namespace murosimf::viewer {
namespace {

std::filesystem::path file_with(const std::string& text) {
  const auto file = fixtures::temp_folder() / "keys.toml";
  std::ofstream(file) << text;
  return file;
}

std::string mistake_in(const std::string& text) {
  try {
    const KeyMap keys(file_with(text));
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
}

TEST(KeyMap, NoUsualKeyMeansTwoThings) {
  std::set<KeyChord> seen;
  for (const ActionInfo& info : actions()) {
    EXPECT_TRUE(seen.insert(read_chord(info.key)).second) << info.name << ": " << info.key;
    EXPECT_EQ(KeyMap().action_of(read_chord(info.key)), info.action) << info.name;
  }
}

TEST(KeyMap, ReadsChordsInAnyCase) {
  EXPECT_EQ(read_chord("ctrl+SHIFT+p"), (KeyChord{"P", true, true, false}));
  EXPECT_EQ(to_text(read_chord("alt+pageup")), "Alt+PageUp");
  EXPECT_THROW((void)read_chord("Hyper+P"), SetupError);
  EXPECT_THROW((void)read_chord("Ctrl+"), SetupError);
  EXPECT_THROW((void)read_chord("Spcae"), SetupError);
}

TEST(KeyMap, AFileGivesAnActionOtherKeys) {
  const KeyMap keys(
      file_with("run_or_pause = \"Enter\"\nplace_ball = [\"B\", \"Ctrl+B\"]\nreload = []\nreset = \"R\"\n"));
  EXPECT_EQ(keys.action_of({.key = "Enter"}), Action::run_or_pause);
  EXPECT_FALSE(keys.action_of({.key = "Space"}));
  EXPECT_EQ(keys.keys_of(Action::place_ball), "B, Ctrl+B");
  EXPECT_EQ(keys.keys_of(Action::reload), "");
  EXPECT_EQ(keys.action_of({.key = "R"}), Action::reset);
  EXPECT_EQ(keys.action_of({.key = "L"}), Action::next_level) << "others stay";
}

TEST(KeyMap, SaysWhereAMistakeIs) {
  EXPECT_NE(mistake_in("run_or_pose = \"Space\"\n").find("keys.toml:1"), std::string::npos);
  EXPECT_NE(mistake_in("run_or_pose = \"Space\"\n").find("did you mean 'run_or_pause'"), std::string::npos);
  EXPECT_NE(mistake_in("reset = \"R\"\nreload = \"R\"\n").find("stands for two actions"), std::string::npos);
  EXPECT_NE(mistake_in("reset = 3\n").find("write the name of a key"), std::string::npos);
  EXPECT_NE(mistake_in("reset = [3]\n").find("write the name of a key"), std::string::npos);
  EXPECT_NE(mistake_in("reset = \"Spcae\"\n").find("Space"), std::string::npos);
}

}  // namespace
}  // namespace murosimf::viewer
