// Control software in shared libraries: it sees and sets what it should, with any number of threads, from saved states and after
// resets; and what it does wrong is told with its name while the others play on.
#include "murosimf/control_software/library_software.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "murosimf/control_software/controller_task.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::control_software {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

const std::string controllers = MUROSIMF_CONTROLLERS "/";

/// The walker with a library; options as "options.error=far".
std::vector<std::string> walker_with(const std::string& library, const std::vector<std::string>& options = {}) {
  std::vector<std::string> overrides{"walker.controller=library", "walker.library=" + library};
  for (const std::string& option : options) overrides.push_back("walker." + option);
  return overrides;
}

scene::SceneOptions with(std::vector<std::string> overrides, int threads = 1) {
  return {.threads = threads, .overrides = std::move(overrides), .cameras = false};
}

scene::RunReport report_of(const scene::Scene& scene) { return scene::make_report(scene, 1s, {}); }

const SoftwareReport& software(const scene::Scene& scene, const std::string& robot = "walker") {
  return *software_report(scene.simulation().world().entity(robot));
}

double head_target(const scene::Scene& scene, const std::string& robot = "walker") {
  return scene.simulation().world().entity(robot).object("j_head").get(properties::joint_target);
}

std::size_t open_files() {
  const fs::directory_iterator all("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

std::string refusal(const std::string& library, const std::vector<std::string>& options = {}) {
  const std::string message =
      fixtures::error_of([&] { scene::Scene("walk", with(walker_with(controllers + library, options))); });
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  return message;
}

TEST(LibrarySoftware, IsCalledAtItsRateAndTimed) {
  scene::Scene scene("walk", with(walker_with(controllers + "controller_1.so", {"call_budget=1e-9"})));
  scene.simulation().run(2s);
  const SoftwareReport& report = software(scene);
  EXPECT_EQ(report.calls, 100);
  EXPECT_EQ(report.rate_hz, 50);
  EXPECT_EQ(report.over_budget, 100);  // nothing takes less than a nanosecond
  EXPECT_GT(report.worst, Duration{});
  EXPECT_GE(report.spent, report.worst);
  EXPECT_EQ(report.refused, 0U);
  EXPECT_NE(head_target(scene), 0);
  ASSERT_EQ(report_of(scene).control.size(), 1U);
  EXPECT_EQ(report_of(scene).control[0].robot, "walker");
}

TEST(LibrarySoftware, HasTheRateOfTheScene) {
  scene::Scene scene("walk", with(walker_with(controllers + "controller_1.so", {"control_rate=200"})));
  scene.simulation().run(1s);
  EXPECT_EQ(software(scene).calls, 200);
}

std::uint64_t hash_after(double s, int threads) {
  std::vector<std::string> overrides{"blue.*.level=simplified_dynamics"};
  for (const std::string robot : {"blue1", "blue2", "blue3", "red1", "red2", "red3"}) {
    overrides.push_back(robot + ".controller=library");
    overrides.push_back(robot + ".library=" + controllers + "controller_1.so");
  }
  scene::Scene scene("three_on_three", with(overrides, threads));
  scene.simulation().run(from_seconds(s));
  return scene.simulation().state_hash();
}

// Six instances share a global variable: in another order of calls their commands would be others.
TEST(LibrarySoftware, GivesTheSameStateWithAnyNumberOfThreads) {
  const std::uint64_t one = hash_after(1, 1);
  EXPECT_EQ(hash_after(1, 2), one);
  EXPECT_EQ(hash_after(1, 3), one);
}

TEST(LibrarySoftware, BeginsAgainAfterAReset) {
  for (const std::string library : {"controller_1.so", "controller_2.so"}) {
    scene::Scene scene("walk", with(walker_with(controllers + library)));
    std::vector<double> first, second;
    for (std::vector<double>* targets : {&first, &second}) {
      scene.reset();
      for (int i = 0; i < 50; ++i) {
        targets->push_back(head_target(scene));
        scene.simulation().run(20ms);
      }
    }
    if (library == "controller_2.so") {
      EXPECT_EQ(first, second);
      EXPECT_EQ(first[0], 0.05);  // set by its start
    }
    EXPECT_EQ(software(scene).calls, 50);
  }
}

TEST(LibrarySoftware, GoesOnFromASavedState) {
  const auto overrides = walker_with(controllers + "controller_2.so", {"level=simplified_dynamics"});
  scene::Scene scene("walk", with(overrides));
  scene.simulation().run(700ms);
  const std::vector<std::byte> state = scene.save();
  scene.simulation().run(500ms);
  const std::uint64_t there = scene.simulation().state_hash();
  scene.load(state);
  scene.simulation().run(500ms);
  EXPECT_EQ(scene.simulation().state_hash(), there);
  scene::Scene other("walk", with(overrides));
  other.load(state);
  other.simulation().run(500ms);
  EXPECT_EQ(other.simulation().state_hash(), there);
}

TEST(LibrarySoftware, HasWrongNumbersRefusedAndCounted) {
  for (const std::string error : {"no_number", "infinite", "far"}) {
    scene::Scene scene("walk", with(walker_with(controllers + "controller_2.so",
                                                {"options.error=" + error, "options.at=0.5"})));
    scene.simulation().run(500ms);
    EXPECT_EQ(software(scene).refused, 0U);
    scene.simulation().run(500ms);
    EXPECT_EQ(software(scene).refused, 25U) << error;
    EXPECT_EQ(head_target(scene), 0.05) << "what held before still holds";
    EXPECT_TRUE(fixtures::says(software(scene).first_refusal, {"at 0.500 s: joint.target of j_head is", "not in"}));
    ASSERT_FALSE(report_of(scene).warnings.empty());
  }
}

TEST(LibrarySoftware, EndsAloneIfItThrows) {
  scene::Scene scene("three_on_three",
                     with({"blue1.controller=library", "blue1.library=" + controllers + "controller_1.so",
                           "blue1.options.error=throw", "blue1.options.at=0.5"}));
  scene.simulation().run(1s);
  EXPECT_EQ(software(scene, "blue1").calls, 26);
  EXPECT_TRUE(fixtures::says(software(scene, "blue1").ended,
                             {"at 0.500 s: library '", "controller_1.so' of blue1: its step threw: no such state"}));
  EXPECT_EQ(scene.simulation().now(), Duration(1s));
  const double before = scene.simulation().world().entity("red1").base().get(properties::position).x;
  scene.simulation().run(2s);
  EXPECT_NE(scene.simulation().world().entity("red1").base().get(properties::position).x, before);
  scene.reset();  // it may try again
  scene.simulation().run(100ms);
  EXPECT_EQ(software(scene, "blue1").calls, 5);
  EXPECT_EQ(software(scene, "blue1").ended, "");
}

TEST(LibrarySoftware, EndsAloneIfItThrowsANumber) {
  scene::Scene scene("walk", with(walker_with(controllers + "controller_1.so", {"options.error=throw_number"})));
  scene.simulation().run(100ms);
  EXPECT_TRUE(fixtures::says(software(scene).ended, {"its step threw something that is no std::exception"}));
}

TEST(LibrarySoftware, EndsAloneIfItDoesNotComeBack) {
  scene::Scene scene("walk", with(walker_with(controllers + "controller_1.so",
                                              {"options.error=loop", "options.at=0.1", "call_budget=0.001"})));
  scene.simulation().run(1s);
  EXPECT_TRUE(
      fixtures::says(software(scene).ended, {"at 0.100 s: library '", "its step did not come back within 1 s"}));
  EXPECT_EQ(software(scene).over_budget, 1);
  EXPECT_GE(software(scene).worst, Duration(1s));
  EXPECT_EQ(scene.simulation().now(), Duration(1s));
}

class CrashingLibrary : public testing::TestWithParam<std::pair<const char*, const char*>> {};

// In a process of its own: what a crash leaves of this one is unknown.
TEST_P(CrashingLibrary, EndsTheRunAndIsTold) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  const auto [error, signal] = GetParam();
  const auto run = [&] {
    scene::Scene scene("walk", with(walker_with(controllers + "controller_1.so",
                                                {std::string("options.error=") + error, "options.at=0.5"})));
    try {
      scene.simulation().run(2s);
    } catch (const SoftwareCrash& crash) {
      const bool told = fixtures::says(crash.what(), {"walker: at 0.500 s: library '", "its step crashed (", signal});
      const bool in_time = scene.simulation().now() < Duration(600ms);
      const bool reported = !report_of(scene).warnings.empty();
      std::_Exit(told && in_time && reported ? 17 : 18);
    }
    std::_Exit(19);
  };
  const std::string line = std::string("murosimf: library '.*controller_1.so' of walker: its step crashed .") + signal;
  EXPECT_EXIT(run(), testing::ExitedWithCode(17), line);
}

INSTANTIATE_TEST_SUITE_P(Signals, CrashingLibrary,
                         testing::Values(std::pair("segv", "SIGSEGV"), std::pair("abort", "SIGABRT"),
                                         std::pair("fpe", "SIGFPE"), std::pair("overflow", "SIGSEGV")),
                         [](const auto& info) { return std::string(info.param.first); });

TEST(LibrarySoftware, IsRefusedInOneLine) {
  EXPECT_TRUE(fixtures::says(refusal("nosuch.so"), {"no file '", "nosuch.so'"}));
  EXPECT_TRUE(fixtures::says(refusal(""), {"no file '"}));
  EXPECT_TRUE(fixtures::says(refusal("controller_no_entry.so"),
                             {"controller_no_entry.so: this is no control software: it has no function "
                              "murosimf_controller_entry"}));
  EXPECT_TRUE(fixtures::says(refusal("controller_nothing.so"), {"murosimf_controller_entry returns nothing"}));
  EXPECT_TRUE(fixtures::says(refusal("controller_other_abi.so"),
                             {"made for version 7 of murosimf_controller.h, but this program has versions 1 to 3"}));
  EXPECT_TRUE(fixtures::says(refusal("controller_no_step.so"), {"lacks create, destroy or step"}));
  EXPECT_TRUE(fixtures::says(refusal("controller_save_alone.so"), {"one of save and load"}));
  EXPECT_TRUE(fixtures::says(refusal("controller_rate.so"), {"its rate is -1 Hz"}));
  EXPECT_TRUE(fixtures::says(refusal("controller_unknown_symbol.so"),
                             {"controller_unknown_symbol.so: cannot be loaded: ", "nobody_has_defined_this"}));
}

TEST(LibrarySoftware, MayRefuseItsRobot) {
  EXPECT_TRUE(fixtures::says(refusal("controller_1.so", {"options.refuse=1"}), {"of walker: it is Monday"}));
  EXPECT_TRUE(fixtures::says(refusal("controller_1.so", {"options.signal=imu.gyroscop"}),
                             {"unknown signal 'imu.gyroscop'; did you mean 'imu.gyroscope'?"}));
  EXPECT_TRUE(fixtures::says(refusal("controller_1.so", {"options.error=create"}), {"its create threw: no memory"}));
  EXPECT_TRUE(fixtures::says(refusal("controller_1.so", {"options.eror=far"}),
                             {"unknown option of library '", "'eror'; did you mean 'error'?"}));
  EXPECT_TRUE(fixtures::says(refusal("controller_1.so", {"options.at=early"}),
                             {"the option 'at' is a text; it must be a number"}));
}

// Whether it is refused, throws, or runs to the end.
TEST(LibrarySoftware, LeavesNoFileOpen) {
  const auto use = [] {
    for (const std::string name :
         {"nosuch.so", "controller_other_abi.so", "controller_no_entry.so", "controller_unknown_symbol.so"}) {
      (void)refusal(name);
    }
    for (const std::string error : {"create", "throw", "far"}) {
      try {
        scene::Scene scene("walk", with(walker_with(controllers + "controller_1.so", {"options.error=" + error})));
        scene.simulation().run(40ms);
      } catch (const SetupError&) {
      }
    }
  };
  use();  // what the process keeps from then on
  const std::size_t files = open_files();
  use();
  EXPECT_EQ(open_files(), files);
}

/// Runs until the robot's software has said something, for 10 s at most. The last thing that it has said.
std::string wait_for_news(scene::Scene& scene, std::size_t many) {
  for (int i = 0; i < 1000 && software(scene).said.size() < many; ++i) {
    scene.simulation().run(20ms);
    std::this_thread::sleep_for(10ms);
  }
  return software(scene).said.empty() ? "" : software(scene).said.back().text;
}

/// As linkers do: another file in its place.
void put(const std::string& from, const fs::path& to) {
  const fs::path next = to.string() + ".next";
  fs::copy_file(controllers + from, next);
  fs::last_write_time(next, fs::file_time_type::clock::now());
  fs::rename(next, to);
}

TEST(LibrarySoftware, IsExchangedWhenItsFileChanges) {
  const fs::path file = fixtures::temp_folder() / ("exchanged_" + std::to_string(::getpid()) + ".so");
  put("controller_1.so", file);
  scene::Scene scene("walk", with(walker_with(file.string(), {"reload=true"})));
  scene.simulation().run(1s);
  EXPECT_NEAR(head_target(scene), 0.1, 0.0501);
  put("controller_2.so", file);
  EXPECT_EQ(wait_for_news(scene, 1), "the library was loaded anew and goes on");
  scene.simulation().run(100ms);
  EXPECT_NEAR(head_target(scene), 0.2, 0.0501);
  // one that cannot be loaded changes nothing
  put("controller_other_abi.so", file);
  EXPECT_TRUE(fixtures::says(wait_for_news(scene, 2), {"the library was not loaded anew: ", "made for version 7"}));
  scene.simulation().run(100ms);
  EXPECT_NEAR(head_target(scene), 0.2, 0.0501);
  put("controller_1.so", file);
  EXPECT_EQ(wait_for_news(scene, 3), "the library was loaded anew and goes on");
  scene.simulation().run(100ms);
  EXPECT_NEAR(head_target(scene), 0.1, 0.0501);
  fs::remove(file);
}

// A scene file is data: code that it names runs only if the program says so.
TEST(LibrarySoftware, OfAFileIsLoadedOnlyIfThatIsAllowed) {
  const fs::path file = fixtures::temp_folder() / ("untrusted_" + std::to_string(::getpid()) + ".toml");
  std::ofstream(file) << "[[robots]]\nname = \"walker\"\nmodel = \"kid21\"\ncontroller = \"library\"\nlibrary = \""
                      << controllers << "controller_1.so\"\n";
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { scene::Scene scene(file); }),
                             {file.string() + ":5:11: this file has control software loaded", "--libraries"}));
  scene::Scene scene(file, {.libraries = true});
  scene.simulation().run(100ms);
  EXPECT_EQ(software(scene).calls, 5);
  fs::remove(file);
}

TEST(LibrarySoftware, WalksToTheBallByTheWalkEngine) {
  const std::string file = MUROSIMF_SOURCE_DIR "/examples/controllers/to_the_ball.toml";
  scene::Scene scene(file, with({"defaults.library=" MUROSIMF_EXAMPLE_CONTROLLERS "/walk_to_ball.so"}));
  scene.simulation().run(15s);
  for (const char* robot : {"left", "right"}) {
    ASSERT_EQ(software(scene, robot).said.size(), 1U);
    EXPECT_EQ(software(scene, robot).said[0].text, "I am at the ball");
    const Vec3d place = scene.simulation().world().entity(robot).base().get(properties::position);
    EXPECT_LT(std::hypot(place.x, place.y), 0.3);
  }
}

TEST(LongestCall, IsASecondOrTenBudgets) {
  EXPECT_EQ(longest_call({}), Duration(10s));
  EXPECT_EQ(longest_call(1ms), Duration(1s));
  EXPECT_EQ(longest_call(200ms), Duration(2s));
}

}  // namespace
}  // namespace murosimf::control_software
