// `murosimf compare` as a user meets it: tables, JSON, plots, one clear line for every error.
#include <sstream>

#include "tests/apps/program.h"

namespace murosimf::test {
namespace {

const std::string short_push = "compare push --entity robot --duration 1 --repeat 1 ";

TEST(CompareCommand, BeginsWithAVerdictAndALineForEachLevel) {
  const Result result = murosimf(short_push);
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.errors, "");
  std::vector<std::string> lines;
  std::istringstream output(result.output);
  for (std::string line; std::getline(output, line);) lines.push_back(line);
  const std::vector<std::string> parts{
      "Push: simplified_dynamics is adequate: falls at the same time, at ",
      "not adequate: does not fall, the reference does; ",
      "simplified_dynamics   cost ",
      "full_dynamics         cost ",
      "compared with articulated_dynamics: robot for 1 s, seed 1; its motion",
      "for what reads inertial sensors: simplified_dynamics, full_dynamics are adequate"};
  ASSERT_EQ(lines.size(), parts.size()) << result.output;
  for (std::size_t i = 0; i < parts.size(); ++i) EXPECT_NE(lines[i].find(parts[i]), std::string::npos) << lines[i];
}

TEST(CompareCommand, PrintsTablesIfAsked) {
  const std::string brief = murosimf(short_push).output, long_one = murosimf(short_push + "--details").output;
  for (const char* part : {"us per s", "center_max", "others_speed", "accelerometer_peak", "|a|-g rms",
                           "kinematic_walking    -                   not adequate: does not fall",
                           "full_dynamics and up are needed for joint torques"}) {
    EXPECT_EQ(brief.find(part), std::string::npos) << part;
    EXPECT_NE(long_one.find(part), std::string::npos) << part << " in " << long_one;
  }
}

TEST(CompareCommand, WhatIsNamedAsOutcomeDecidesAlone) {
  const std::string run = short_push + "--levels kinematic_walking,full_dynamics ";
  EXPECT_NE(murosimf(run + "--outcome robot.falls").output.find("not adequate: robot.falls: does not fall"),
            std::string::npos);
  const Result result = murosimf(run + "--outcome ball.speed --outcome ball.touched=0.05");
  EXPECT_EQ(result.output.find("Push: kinematic_walking is adequate: ball.speed within 0.00 m/s, "), 0U)
      << result.output;
  EXPECT_NE(result.output.find("ball.speed, ball.touched alone"), std::string::npos);
  expect_mistake(run + "--outcome ball.sped",
                 {"--outcome 'ball.sped'", "known: ball.way, end, speed, touched; robot.way, end"});
}

TEST(CompareCommand, WritesJsonWithOneEntryPerLevel) {
  const std::string json = murosimf(short_push + "--levels kinematic_walking,full_dynamics --json -").output;
  ASSERT_FALSE(json.empty());
  EXPECT_EQ(json.front(), '{');
  for (const char* key :
       {"\"entries\"", "\"cost_us_per_s\"", "\"deviations\"", "\"center_max\"", "\"events\"", "\"falls\"",
        "\"thresholds\"", "\"recommendation\"", "\"sentence\"", "\"adequate\"", "\"reasons\"", "\"peak_torque_Nm\""}) {
    EXPECT_NE(json.find(key), std::string::npos) << key;
  }
  std::size_t entries = 0;
  for (auto at = json.find("\"cost_us_per_s\""); at != std::string::npos; at = json.find("\"cost_us_per_s\"", at + 1))
    ++entries;
  EXPECT_EQ(entries, 2U);
}

TEST(CompareCommand, SaysHowSureItIs) {
  const std::string run = short_push + "--levels kinematic_walking,articulated_dynamics ";
  const Result one = murosimf(run + "--seeds 2");
  EXPECT_EQ(one.exit_code, 0) << one.errors;
  for (const char* part : {"Push: only articulated_dynamics is adequate\n", "not adequate: in 0 of 2 seeds; seed 1: ",
                           "robot for 1 s, seeds 1 to 2; ", "seeds had no effect: all runs of a level are the same"}) {
    EXPECT_NE(one.output.find(part), std::string::npos) << part << " in " << one.output;
  }
  const Result many = murosimf(run + "--seeds 4 --servo-tolerance 5 --outcome robot.falls");
  for (const char* part :
       {"not adequate: in 0 of 4 seeds (0 %, 0 to 49 % of all with a confidence of 95 %); seed 1: ",
        "yardstick: articulated_dynamics with the model's servos in 4 of 4 seeds (100 %, 51 to 100 %",
        "seeds 1 to 4, gains of its servos within 5 %", "only the servos differ"}) {
    EXPECT_NE(many.output.find(part), std::string::npos) << part << " in " << many.output;
  }
  const std::string json = murosimf(run + "--seeds 2 --json -").output;
  for (const char* key :
       {"\"seeds\"", "\"seeds_differ\": false", "\"judgement\": \"not adequate\"", "\"yardstick\": null"}) {
    EXPECT_NE(json.find(key), std::string::npos) << key << " in " << json;
  }
}

TEST(CompareCommand, DrawsPlots) {
  if (std::system("gnuplot --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no gnuplot here";
  const fs::path folder = scratch("plots");
  const Result result = murosimf(short_push + "--plots " + folder.string());
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  for (const char* name : {"center_of_mass.png", "torso.png", "foot_clearance.png", "torque.png"}) {
    EXPECT_EQ(read_file(folder / name).substr(1, 3), "PNG") << name;
  }
}

TEST(CompareCommand, RefusesMistakes) {
  expect_mistake("compare", {"scene"});
  expect_mistake("compare push", {"--entity"});
  expect_mistake("compare pusj --entity robot", {"no file 'pusj'"});
  expect_mistake("compare push --entity robt", {"--entity 'robt'", "did you mean 'robot'?"});
  expect_mistake("compare push --entity ball", {"a ball has one level"});
  expect_mistake(short_push + "--levels full", {"--levels", "did you mean 'full_dynamics'?"});
  expect_mistake(short_push + "--contacts papr", {"--contacts", "did you mean 'paper'?"});
  expect_mistake(short_push + "--threshold pich=3", {"--threshold 'pich=3'", "did you mean 'pitch'?"});
  expect_mistake(short_push + "--threshold pitch=many", {"must be a number from 0"});
  expect_mistake(short_push + "--outcome bal.end",
                 {"--outcome 'bal.end': nothing that moves is called 'bal'; known: "});
  expect_mistake(short_push + "--outcome ball", {"write NAME.QUANTITY"});
  expect_mistake(short_push + "--outcome ball.end=far", {"the tolerance must be a number from 0"});
  expect_mistake("compare push --entity robot --duration 0", {"--duration 0"});
  expect_mistake("compare push --entity robot --repeat 0", {"--repeat", "0 not in range"});
  expect_mistake(short_push + "--seeds 0", {"--seeds", "0 not in range"});
  expect_mistake(short_push + "--servo-tolerance 100", {"--servo-tolerance", "100 not in range"});
  expect_mistake(short_push + "--servo-tolerance 5 --levels full_dynamics",
                 {"--servo-tolerance: full_dynamics, the most detailed level that ran, has no servos"});
  expect_mistake(short_push + "--set robot.levl=x", {"did you mean 'level'?"});
  expect_mistake(short_push + "--json /no/such/folder/a.json", {"cannot write '/no/such/folder/a.json'"});
}

TEST(CompareCommand, ChecksTheFolderOfPlotsBeforeItComputes) {
  if (std::system("gnuplot --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no gnuplot here";
  expect_mistake(short_push + "--plots /proc/no/such/folder", {"/proc/no/such/folder"});
  expect_mistake(short_push + "--plots /dev/null", {"/dev/null"});
}

}  // namespace
}  // namespace murosimf::test
