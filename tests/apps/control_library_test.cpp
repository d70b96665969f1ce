// Control software in libraries, from outside: what the program writes and returns when one crashes, and what files may name.
#include <nlohmann/json.hpp>

#include "tests/apps/program.h"

namespace murosimf::test {
namespace {

const std::string library = MUROSIMF_CONTROLLERS "/controller_1.so";
const std::string walker_with_library = "--set walker.controller=library --set walker.library=" + library;

std::string crash_line(const std::string& signal) {
  return "murosimf: library '" + library + "' of walker: its step crashed (" + signal + "); the run ends here\n";
}

TEST(ControlLibrary, IsReportedAsJson) {
  const Result result = murosimf("run walk --duration 1 --json - --set walker.call_budget=5 " + walker_with_library);
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const nlohmann::json control = nlohmann::json::parse(result.output)["control"].at(0);
  EXPECT_EQ(control["robot"], "walker");
  EXPECT_EQ(control["software"], library);
  EXPECT_EQ(control["calls"], 50);
  EXPECT_EQ(control["rate_hz"], 50);
  EXPECT_EQ(control["budget_us"], 5e6);
  EXPECT_EQ(control["over_budget"], 0);
  EXPECT_EQ(control["ended"], "");
  EXPECT_GE(control["worst_us"].get<double>(), control["us_per_call"].get<double>());
}

// What the run has shown up to the crash is written, and nothing but one line says more.
TEST(ControlLibrary, ThatCrashesEndsTheRunWithItsReports) {
  const fs::path log = scratch("log.csv"), json = scratch("report.json");
  const Result result =
      murosimf("run walk --duration 5 --log walker.joint_target --out " + log.string() + " --json " + json.string() +
               " " + walker_with_library + " --set walker.options.error=segv --set walker.options.at=1.5");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.errors, crash_line("SIGSEGV"));
  const nlohmann::json report = nlohmann::json::parse(read_file(json));
  EXPECT_EQ(report["stopped"]["by"], "a crash");
  EXPECT_NEAR(report["simulated_s"].get<double>(), 1.5, 0.01);
  EXPECT_NE(report["control"][0]["ended"].get<std::string>().find("its step crashed (SIGSEGV)"), std::string::npos);
  const std::string rows = read_file(log);
  EXPECT_NE(rows.find("\n1.49,"), std::string::npos);
  EXPECT_EQ(rows.find("\n1.6,"), std::string::npos);
}

TEST(ControlLibrary, ThatCrashesEndsOtherCommandsToo) {
  const Result result = murosimf("render walk --time 1 --out " + scratch("picture.png").string() + " " +
                                 walker_with_library + " --set walker.options.error=abort");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_TRUE(result.errors.ends_with(crash_line("SIGABRT"))) << result.errors;
}

std::string walker_that(const std::string& mischief, const std::string& where = "step") {
  return " --set walker.controller=library --set walker.library=" MUROSIMF_CONTROLLERS
         "/controller_mischief.so --set walker.options.at=1.5 --set walker.options.mischief=" +
         mischief + " --set walker.options.where=" + where;
}

/// The one line about it, and all that the run has shown before.
void expect_crash(const std::string& mischief, const std::string& text) {
  const fs::path log = scratch("log.csv"), json = scratch("report.json"), recording = scratch("recording.mcap");
  const Result result = murosimf("run walk --duration 5 --log walker.joint_target --out " + log.string() + " --json " +
                                 json.string() + " --record " + recording.string() + walker_that(mischief));
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_TRUE(
      result.errors.ends_with("murosimf: library '" MUROSIMF_CONTROLLERS "/controller_mischief.so' of walker: " + text +
                              "; the run ends here\n"))
      << result.errors;  // err() says a word of its own first
  const nlohmann::json report = nlohmann::json::parse(read_file(json));
  EXPECT_EQ(report["stopped"]["by"], "a crash");
  EXPECT_NE(report["control"][0]["ended"].get<std::string>().find(text), std::string::npos);
  EXPECT_NE(read_file(log).find("\n1.49,"), std::string::npos);
  EXPECT_EQ(murosimf("replay " + recording.string()).exit_code, 0);
  for (const fs::path& file : {log, json, recording}) fs::remove(file);
}

TEST(ControlLibrary, ThatCallsExitEndsTheRunWithItsReports) {
  expect_crash("exit", "its step called exit(0)");
  expect_crash("_exit", "its step called _exit(7)");
  expect_crash("err", "its step called exit(0)");
}

TEST(ControlLibrary, ThatWritesBeyondItsRowsEndsTheRunWithItsReports) {
  expect_crash("led_beyond", "its step went beyond the end of 'robot.led', which has 3 numbers");
  expect_crash("input", "its step wrote to 'joint.position', which is to be read only (SIGSEGV)");
}

TEST(ControlLibrary, WhoseThreadCrashesEndsTheRunWithItsReports) {
  expect_crash("thread_segv", "a thread of its own crashed (SIGSEGV)");
  expect_crash("lost_thread_segv", "a thread of its own crashed (SIGSEGV)");
}

// The report is there by then, but all is not well.
TEST(ControlLibrary, ThatCrashesAtTheEndIsToldByTheExitCode) {
  for (const std::string& arguments :
       {walker_that("exit", "destroy"),
        std::string(" --set walker.controller=library --set walker.library=" MUROSIMF_CONTROLLERS
                    "/controller_unloading_segv.so")}) {
    const Result result = murosimf("run walk --duration 1 --json -" + arguments);
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_TRUE(result.errors.ends_with("; the run ends here\n")) << result.errors;
    EXPECT_EQ(nlohmann::json::parse(result.output)["stopped"], nullptr);
  }
}

TEST(ControlLibrary, ThatEndsTheProgramWhenItIsLoadedIsNamed) {
  expect_mistake("run walk --duration 1 --set walker.controller=library --set walker.library=" MUROSIMF_CONTROLLERS
                 "/controller_loading_exit.so",
                 {"controller_loading_exit.so': its loading called exit(0); the run ends here"}, 3);
  expect_mistake("run walk --duration 1" + walker_that("segv", "create"), {"its create crashed (SIGSEGV)"}, 3);
}

TEST(ControlLibrary, ThatChangesTheProcessIsWarnedOfOnce) {
  const fs::path json = scratch("report.json");
  const Result result =
      murosimf("run walk --duration 2 --json " + json.string() + walker_that("chdir") + " --set walker.options.many=5");
  EXPECT_EQ(result.exit_code, 0);
  const std::string warning =
      "walker: its control software has changed the working directory, 5 times, first at 1.500 s; put back";
  EXPECT_NE(result.output.find(warning), std::string::npos) << result.output;
  const nlohmann::json changed = nlohmann::json::parse(read_file(json))["control"][0]["changed"];
  EXPECT_EQ(changed, nlohmann::json::parse(R"([{"what": "the working directory", "times": 5, "first_s": 1.5}])"));
  fs::remove(json);
}

TEST(ControlLibrary, OfASceneFileNeedsAllowance) {
  const fs::path scene = write("scene.toml",
                               "[[robots]]\nname = \"walker\"\nmodel = \"kid21\"\ncontroller = \"library\"\n"
                               "library = \"" +
                                   library + "\"\n");
  expect_mistake("run " + scene.string() + " --duration 1", {"scene.toml:5:11: ", library, "--libraries"});
  EXPECT_EQ(murosimf("run " + scene.string() + " --duration 1 --libraries").exit_code, 0);
}

TEST(ControlLibrary, IsMissedInOneLine) {
  expect_mistake("run walk --set walker.controller=library", {"controller 'library' needs the name of a file"});
  expect_mistake("run walk --set walker.controller=library --set walker.library=nosuch", {"no file 'nosuch'"});
}

}  // namespace
}  // namespace murosimf::test
