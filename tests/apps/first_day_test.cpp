// What people do on their first day: change friction and masses, push, complete, look up.
#include "tests/apps/program.h"

namespace murosimf::test {
namespace {

bool first_day_has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::string data_folder = std::string(MUROSIMF_SOURCE_DIR) + "/examples/data/";

TEST(FirstDay, ChangesFrictionAndMassAndSaysSo) {
  const Result result = murosimf(
      "run nudge --duration 0.2 --set materials.friction=0.3 --set field.friction=0.2 --set robot.torso.mass=1.2");
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_TRUE(first_day_has(result.output, "note: robot: torso: mass 1.2 kg instead of 1.1 kg, its inertia scaled by"))
      << result.output;
  expect_mistake("run nudge --set robot.torso.mass=0", {"--set 'robot.torso.mass=0'", "above 0"});
  expect_mistake("run nudge --set materials.rubbr.friction=1", {"unknown material 'rubbr'", "'rubber'"});
}

TEST(FirstDay, PushesAreEvents) {
  const Result result = murosimf("run nudge --duration 0.2 --json - --push 'robot.torso=[30,0,0]@0.1..0.15'");
  EXPECT_TRUE(first_day_has(result.output, "push on robot.torso: force (30, 0, 0) N, until 0.15 s")) << result.errors;
  expect_mistake("run walk --push 'walker.torso=[30,0,0]@0.1..0.15'", {"kinematic_walking", "ignores forces"});
}

TEST(FirstDay, LogsAllJointsByOneName) {
  const fs::path table = scratch("joints.csv");
  EXPECT_EQ(murosimf("run nudge --duration 0.05 --log robot.joint_torque --out " + table.string()).exit_code, 0);
  const std::string text = read_file(table);
  const std::string header = text.substr(0, text.find('\n'));
  EXPECT_EQ(std::count(header.begin(), header.end(), ','), 21) << header;
  EXPECT_TRUE(header.starts_with("time [s],robot.j_torso.joint_torque [N m],robot.j_neck.joint_torque [N m]"))
      << header;
  expect_mistake("run walk --duration 0 --log walker.joint_torque --out " + table.string(),
                 {"have no 'joint_torque' at kinematic_walking"});
}

TEST(FirstDay, ForcesComeBeforeMoments) {
  const fs::path table = scratch("force.csv");
  EXPECT_EQ(murosimf("run nudge --duration 0.05 --set 'robot.torso.applied_force=[5,0,0,0,0,0]' --log "
                     "robot.torso.applied_force --out " +
                     table.string())
                .exit_code,
            0);
  const std::string text = read_file(table);
  EXPECT_TRUE(text.starts_with("time [s],robot.torso.applied_force.fx [N],")) << text.substr(0, 200);
  EXPECT_TRUE(first_day_has(text, "\n0.01,5,0,0,0,0,0")) << text;
}

TEST(FirstDay, ListsMaterialsScenesAndModels) {
  EXPECT_TRUE(first_day_has(murosimf("list materials").output, "carpet     rubber           0.8"));
  EXPECT_TRUE(first_day_has(murosimf("list scenes").output, "three_on_three\n"));
  EXPECT_TRUE(first_day_has(murosimf("list models").output, "kid21\n"));
}

TEST(FirstDay, PlaysTheRamp) {
  const Result result = murosimf("run ramp --duration 0.5");
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_TRUE(first_day_has(result.output, "brick"));
}

TEST(FirstDay, ReadsTheSampleRobotAndRecordings) {
  const Result check = murosimf("check " + data_folder + "robot.urdf");
  EXPECT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_TRUE(first_day_has(check.output, "sample_biped: 3.700 kg, 14 joints"));
  EXPECT_FALSE(first_day_has(check.output, "warning")) << check.output;
  EXPECT_EQ(murosimf("run walk --duration 0.1 --set walker.model=" + data_folder + "robot.urdf").exit_code, 0);
  const Result replay = murosimf("replay-servo " + data_folder + "recordings --servo xl330_m4");
  EXPECT_EQ(replay.exit_code, 0) << replay.errors;
  EXPECT_TRUE(first_day_has(replay.output, "up_and_down")) << replay.output;
}

TEST(FirstDay, SaysWhichProgramItIs) {
  const std::string text = murosimf("--version").output;
  for (const char* part :
       {"murosimf 0.", "(commit ", "build: ", "pictures o", "cameras o", "fits o", "calibrations o"}) {
    EXPECT_TRUE(first_day_has(text, part)) << part << " in " << text;
  }
}

TEST(FirstDay, EveryJsonHasASchema) {
  EXPECT_TRUE(first_day_has(murosimf("run walk --duration 0.1 --json -").output, "\"schema\": \"murosimf/run/1\""));
  EXPECT_TRUE(first_day_has(murosimf("check kid21 --json -").output, "\"murosimf/check/1\""));
  EXPECT_TRUE(first_day_has(
      murosimf("compare walk --entity walker --levels kinematic_walking --duration 0.1 --repeat 1 --json -").output,
      "\"murosimf/compare/1\""));
  EXPECT_TRUE(first_day_has(murosimf("replay-servo " + data_folder + "recordings --servo xl330 --json -").output,
                            "\"murosimf/replay-servo/1\""));
}

/// What bash offers for a line whose last word is to be completed.
std::string offered(const std::string& words, int last) {
  const fs::path out = scratch("offered");
  const std::string command =
      "bash -c 'source <(" MUROSIMF_PROGRAM " completion bash); COMP_WORDS=(" MUROSIMF_PROGRAM " " + words +
      "); COMP_CWORD=" + std::to_string(last) + "; _murosimf; echo \" ${COMPREPLY[*]} \"' >" + out.string() + " 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  return read_file(out);
}

TEST(FirstDay, BashCompletesCommandsOptionsAndNames) {
  EXPECT_EQ(offered("ru", 1), " run \n");
  const std::string all = offered("\"\"", 1);
  for (const std::string& command : commands()) EXPECT_TRUE(first_day_has(all, " " + command + " ")) << command;
  EXPECT_TRUE(first_day_has(offered("run --pu", 2), " --push "));
  EXPECT_TRUE(first_day_has(offered("run thr", 2), " three_on_three "));
  EXPECT_EQ(offered("list mat", 2), " materials \n");
  EXPECT_TRUE(first_day_has(offered("check kid", 2), " kid21 "));
  expect_mistake("completion fish", {"fish"});
}

TEST(FirstDay, ZshGetsAScriptOfItsOwn) {
  const std::string script = murosimf("completion zsh").output;
  EXPECT_TRUE(script.starts_with("#compdef murosimf\n"));
  EXPECT_TRUE(first_day_has(script, "'run:Run a scene and say what happened'"));
  EXPECT_TRUE(first_day_has(script, "blue.*.level=simplified_dynamics'\\'''")) << "a quote inside quotes";
}

TEST(FirstDay, TheManualPageHasEveryCommand) {
  const std::string page = murosimf("man").output;
  EXPECT_TRUE(page.starts_with(".TH MUROSIMF 1"));
  for (const std::string& command : commands()) {
    std::string name = command;
    if (const auto dash = name.find('-'); dash != std::string::npos) name.replace(dash, 1, "\\-");
    EXPECT_TRUE(first_day_has(page, ".SS murosimf " + name + "\n")) << command;
  }
  EXPECT_TRUE(first_day_has(page, "\\fB\\-\\-push\\fR"));
}

}  // namespace
}  // namespace murosimf::test
