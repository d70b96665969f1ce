// The window as a user meets it, on a screen in memory: scripted sessions, and what the program says of them.
#include <cmath>

#include <nlohmann/json.hpp>

#include "tests/apps/program.h"
#include "tests/apps/virtual_display.h"

namespace murosimf::test {
namespace {

using nlohmann::json;

class View : public testing::Test {
 protected:
  void SetUp() override {
    if (murosimf("--version").output.find("viewer on") == std::string::npos) GTEST_SKIP() << "this build has no viewer";
    if (screen().name().empty()) GTEST_SKIP() << "there is no Xvfb (Debian and Ubuntu: xvfb)";
    setenv("DISPLAY", screen().name().c_str(), 1);
    unsetenv("WAYLAND_DISPLAY");
  }
  static const VirtualDisplay& screen() {
    static const VirtualDisplay display;
    return display;
  }
  /// Runs a script; what the program says of it.
  static json session(const std::string& scene, const std::string& script, const std::string& options = "") {
    const Result result =
        murosimf("view " + scene + " --script " + write("script", script).string() + " " + options + " --json -");
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return result.exit_code == 0 ? json::parse(result.output) : json();
  }
  static json entity(const json& report, const std::string& name) {
    for (const json& one : report["entities"]) {
      if (one["name"] == name) return one;
    }
    return {};
  }
  static bool has_command(const json& report, const std::string& part) {
    for (const json& one : report["commands"]) {
      if (one["text"].get<std::string>().find(part) != std::string::npos) return true;
    }
    return false;
  }
};

TEST_F(View, SelectPushSwitchLevelEditDragGoBack) {
  const fs::path picture = scratch("window.png");
  const json report = session("three_on_three",
                              "key Escape\n"
                              "settle\n"
                              "click blue1\n"
                              "press blue1 level\n"
                              "press simplified_dynamics\n"
                              "settle\n"
                              "push blue1 0.1 0 0\n"
                              "settle\n"
                              "twist blue1 0.1 0 0\n"
                              "settle\n"
                              "drag ball 0.75 0.5\n"
                              "settle\n"
                              "press position\n"  // of the selected object
                              "key Ctrl+A\n"
                              "type 0.5 0.25 0.05\n"
                              "settle\n"
                              "key Space\n"
                              "until 0.4\n"
                              "key Space\n"
                              "settle\n"
                              "scrub 0.2\n"
                              "settle\n"
                              "screenshot " +
                                  picture.string() + "\n",
                              "--paused");
  ASSERT_TRUE(report.is_object());
  EXPECT_EQ(report["schema"], "murosimf/view/1");
  EXPECT_EQ(entity(report, "blue1")["level"], "simplified_dynamics");
  EXPECT_TRUE(has_command(report, "blue1.level = simplified_dynamics"));
  EXPECT_TRUE(has_command(report, ".push = ["));
  EXPECT_TRUE(has_command(report, ".push = [0, 0, 0, ")) << report["commands"];
  EXPECT_TRUE(has_command(report, "ball.ball.position = [0.7")) << report["commands"];
  EXPECT_TRUE(has_command(report, "position = [0.5, 0.25, 0.05]")) << report["commands"];
  EXPECT_TRUE(report["paused"]);
  EXPECT_NEAR(report["simulated_s"].get<double>(), 0.2, 0.02);
  EXPECT_EQ(report["screenshots"].size(), 1U);
  EXPECT_GT(fs::file_size(picture), 10000U);
}

TEST_F(View, ResetKeepsTheRunAsABranch) {
  const json report =
      session("three_on_three", "key Space\nuntil 0.3\nkey Backspace\nsettle\nkey Space\nsettle\nsay done\n",
              "--paused --speed max");
  ASSERT_TRUE(report.is_object());
  EXPECT_GE(report["branches"].get<int>(), 2);
}

// A click on the middle of a slider puts the joint into the middle of its range; what robots bear is colored.
TEST_F(View, JointsAreMovedBySliders) {
  const fs::path picture = scratch("joints.png");
  const json report = session("nudge",
                              "key 1\nkey Z\nkey J\nkey P\nkey O\nkey O\nkey Space\nuntil 0.3\nkey Space\nsettle\n"
                              "press Joints\nsettle\npress joint j_l_shin\nsettle\nlook 60 11 1.6\nscreenshot " +
                                  picture.string() + "\n",
                              "--paused --roboviz 0");
  ASSERT_TRUE(report.is_object());
  EXPECT_TRUE(has_command(report, "j_l_shin.joint_position = ")) << report["commands"];
  EXPECT_EQ(report["drawings"]["packets"], 0);
  EXPECT_GT(fs::file_size(picture), 10000U);
}

// What is done in the window while it is recorded is repeated; there is no way back, and nothing is recorded that nobody asked for.
TEST_F(View, RecordsWhileSomebodyWantsIt) {
  const fs::path file = scratch("asked.mcap");
  const std::string script =
      "key Space\nuntil 0.3\nkey Space\nsettle\npress Record\nsettle\npush robot 0.2 0 0\nsettle\n"
      "key Space\nuntil 0.6\nkey Space\nsettle\nkey F9\nsettle\nkey Backspace\nsettle\n";
  const json report = session("nudge", script, "--paused --record " + file.string() + " --record-on asked --keep 1");
  ASSERT_TRUE(report.is_object());
  EXPECT_TRUE(has_command(report, ".push = ["));
  EXPECT_GT(report["simulated_s"].get<double>(), 0.5) << "no reset";
  EXPECT_NE(report["messages"].dump().find("the run is recorded"), std::string::npos) << report["messages"];
  const Result again = murosimf("rerun " + file.string());
  EXPECT_EQ(again.exit_code, 0) << again.output << again.errors;
  const fs::path other = scratch("nothing.mcap");
  ASSERT_TRUE(session("nudge", "until 0.1\nsettle\n", "--record " + other.string() + " --record-on asked").is_object());
  constexpr std::uintmax_t of_frames = 30'000;  // both begin with the files that the scene is made of
  EXPECT_LT(fs::file_size(other) + of_frames, fs::file_size(file)) << "nobody asked";
  const fs::path whole = scratch("whole.mcap");
  ASSERT_TRUE(session("nudge", "until 0.2\nsettle\n", "--record " + whole.string()).is_object());
  EXPECT_EQ(murosimf("rerun " + whole.string()).exit_code, 0);
  expect_mistake("view " + whole.string() + " --record " + other.string(), {"--record", "a recording already"});
}

// Rule: a run that is watched is the same as one that is not.
TEST_F(View, TheHashIsThatOfARun) {
  const json watched =
      session("three_on_three", "key C\nkey F\nkey G\nkey 1\nuntil 0.5\nsettle\n", "--duration 0.5 --speed max");
  ASSERT_TRUE(watched.is_object());
  const Result run = murosimf("run three_on_three --duration 0.5 --json -");
  EXPECT_EQ(watched["state_hash"], json::parse(run.output)["state_hash"]);
}

// The time line goes over all of a recording from the first moment on, and nobody can change what was.
TEST_F(View, ARecordingIsPlayedAndSoughtIn) {
  const fs::path file = scratch("game.mcap");
  ASSERT_EQ(murosimf("run three_on_three --duration 1 --record " + file.string()).exit_code, 0);
  const json sought =
      session(file.string(), "settle\nscrub 0.7\nsettle\nkey 1\nkey L\nsettle\nkey Left\nsettle\n", "--paused");
  ASSERT_TRUE(sought.is_object());
  EXPECT_NEAR(sought["simulated_s"].get<double>(), 0.69, 0.015) << "one frame before the place of the mouse";
  EXPECT_TRUE(sought["state_hash"].is_null());
  EXPECT_TRUE(sought["commands"].empty());
  EXPECT_NE(sought["messages"].dump().find("this is a recording"), std::string::npos);
  const json played = session(file.string(), "until 1\nsettle\n", "--speed max");
  const json run = json::parse(murosimf("run three_on_three --duration 1 --json -").output);
  for (int i = 0; i < 2; ++i) {
    const double there = entity(played, "blue2")["position"][i].get<double>();
    EXPECT_NEAR(there, entity(run, "blue2")["position"][i].get<double>(), 1e-4);
  }
  expect_mistake("view " + file.string() + " --seed 3", {"is a recording", "--seed"});
}

// The first word comes before the first picture.
TEST_F(View, AScriptMayBeginOnTheTimeLine) {
  const fs::path file = scratch("walk.mcap");
  ASSERT_EQ(murosimf("run walk --duration 2 --record " + file.string()).exit_code, 0);
  const json sought = session(file.string(), "scrub 1.2\nsettle\n", "--paused");
  ASSERT_TRUE(sought.is_object());
  EXPECT_NEAR(sought["simulated_s"].get<double>(), 1.2, 0.02);
}

TEST_F(View, ScreenshotAfterAWhile) {
  const fs::path picture = scratch("picture.png");
  const Result result = murosimf("view walk --after 0.5 --size 640x480 --screenshot " + picture.string());
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_NE(result.output.find("pictures in"), std::string::npos);
  EXPECT_GT(fs::file_size(picture), 5000U);
}

bool has_program(const std::string& name) {
  return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

/// Width and height of a PNG file.
std::pair<int, int> size_of(const fs::path& picture) {
  const std::string bytes = read_file(picture);
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = 256 * value + static_cast<unsigned char>(bytes.at(i));
    return value;
  };
  return {number(16), number(20)};  // PNG specification, 11.2.2
}

/// A screen whose points have two pixels in each direction.
std::pair<int, int> window_on_a_fine_screen(const char* screen) {
  const VirtualDisplay display(screen);
  setenv("DISPLAY", display.name().c_str(), 1);
  EXPECT_EQ(std::system("echo 'Xft.dpi: 192' | xrdb -load"), 0);
  const fs::path picture = scratch("fine.png");
  const Result result = murosimf("view walk --paused --after 0.5 --screenshot " + picture.string());
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  return size_of(picture);
}

TEST_F(View, IsTwiceAsLargeOnAFineScreenAndNeverLargerThanTheScreen) {
  if (!has_program("xrdb")) GTEST_SKIP() << "there is no xrdb (Debian and Ubuntu: x11-xserver-utils)";
  EXPECT_EQ(window_on_a_fine_screen("3000x1800x24"), std::pair(2560, 1440));
  EXPECT_EQ(window_on_a_fine_screen("1600x1000x24"), std::pair(1600, 1000));
}

// A click of xdotool has no length; each of them has to act, also where pictures take their time.
TEST_F(View, EveryClickCounts) {
  if (!has_program("xdotool")) GTEST_SKIP() << "there is no xdotool (Debian and Ubuntu: xdotool)";
  const fs::path report = scratch("clicks.json");
  constexpr int clicks = 8;
  const std::string view =
      std::string(MUROSIMF_PROGRAM) + " view walk --after 7 --json " + report.string() + " >/dev/null 2>&1 & ";
  ASSERT_EQ(std::system((view + "sleep 1.5; for i in 1 2 3 4 5 6 7 8; do xdotool mousemove 30 17 click 1; sleep 0.4; "
                                "xdotool mousemove 400 300; done; wait")
                            .c_str()),
            0);
  EXPECT_EQ(json::parse(read_file(report))["branches"], clicks + 1);
}

TEST_F(View, MistakesAreOneLine) {
  expect_mistake("view walk --script " + write("bad", "clik blue1\n").string(), {"clik", "click", ":1:"});
  expect_mistake("view walk --script " + write("nobody", "settle\nclick blue1\n").string(), {"blue1", ":2:"});
  expect_mistake("view walk --script " + write("item", "press Rest\n").string(), {"Rest", "Reset", ":1:"});
  expect_mistake("view walk --keys " + write("keys.toml", "resset = \"R\"\n").string(), {"resset", "reset"});
  expect_mistake("view nothing_here", {"nothing_here"});
  expect_mistake("view walk --size 12", {"--size", "WIDTHxHEIGHT"});
  expect_mistake("view walk --speed fast", {"--speed", "fast"});
}

TEST(ViewWithout, ADisplay) {
  if (murosimf("--version").output.find("viewer on") == std::string::npos) {
    expect_mistake("view walk", {"no window in this build", "--web", "render"});
    return;
  }
  const std::string before = std::getenv("DISPLAY") ? std::getenv("DISPLAY") : "";
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  expect_mistake("view walk", {"no window", "--web", "render"});
  if (!before.empty()) setenv("DISPLAY", before.c_str(), 1);
}

}  // namespace
}  // namespace murosimf::test
