// The program as a user meets it: exit codes, one clear line for every error, JSON, pictures.
#include <chrono>

#include "tests/apps/program.h"

namespace murosimf::test {
namespace {

const std::string robot_scene = "[[robots]]\nname = \"r\"\nmodel = \"MODEL\"\ncontroller = \"none\"\n";

fs::path scene_with_model(const fs::path& model) {
  std::string text = robot_scene;
  text.replace(text.find("MODEL"), 5, model.string());
  return write("scene.toml", text);
}

TEST(Cli, RunsAScene) {
  const Result result = murosimf("run walk --duration 1");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.errors, "") << "no progress bar where there is no terminal";
  EXPECT_NE(result.output.find("times real time"), std::string::npos);
  EXPECT_NE(result.output.find("state hash"), std::string::npos);
}

TEST(Cli, EveryCommandHasHelp) {
  for (const std::string& command : commands()) {
    const Result result = murosimf(command + " --help");
    EXPECT_EQ(result.exit_code, 0) << command;
    EXPECT_NE(result.output.find("Usage: murosimf " + command), std::string::npos) << result.output;
  }
}

TEST(Cli, JsonGoesToStandardOutputOrAFile) {
  const Result result = murosimf("run walk --duration 1 --json -");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.output.front(), '{');
  const fs::path file = scratch("report.json");
  EXPECT_EQ(murosimf("run walk --duration 1 --json " + file.string()).exit_code, 0);
  EXPECT_NE(read_file(file).find("\"simulated_s\""), std::string::npos);
}

TEST(Cli, RealTimeTakesTheTimeItSays) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(murosimf("run walk --duration 1 --speed 4").exit_code, 0);
  // only the lower bound: a busy machine may be slower
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(250));
}

TEST(Cli, RunsFromAnyWorkingDirectory) {
  const fs::path before = fs::current_path();
  fs::current_path("/");
  EXPECT_EQ(murosimf("run three_on_three --duration 0.1").exit_code, 0);
  fs::current_path(before);
}

TEST(Cli, ListsNames) {
  EXPECT_NE(murosimf("list levels").output.find("kinematic_walking"), std::string::npos);
  const std::string laws = murosimf("list contacts").output;
  for (const char* law : {"implicit_stick", "paper", "paper_multipoint", "kelvin_voigt"})
    EXPECT_NE(laws.find(std::string(law) + " "), std::string::npos) << law;
  EXPECT_NE(murosimf("list sensors").output.find("ground_truth"), std::string::npos);
  EXPECT_NE(murosimf("list parts").output.find("mpu6050\n"), std::string::npos);
  const std::string plan = murosimf("list plan three_on_three").output;
  const auto sense = plan.find("sense    imu"), contact = plan.find("contact  ground_contact");
  EXPECT_LT(sense, contact) << plan;
  EXPECT_LT(contact, plan.find("motion   simplified_dynamics")) << plan;
  EXPECT_NE(plan.find(" blue1 (2) blue2 (2) "), std::string::npos) << "pressure cells of both feet: " << plan;
  EXPECT_NE(murosimf("list properties").output.find("joint_position"), std::string::npos);
}

TEST(Cli, ChecksAModel) {
  const Result result = murosimf("check kid21");
  EXPECT_NE(result.output.find("sensor imu: imu on torso, 200 Hz, part mpu6050"), std::string::npos);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.output.find("4.3"), std::string::npos);
  EXPECT_EQ(murosimf("check kid21 --json -").output.front(), '{');
}

TEST(Cli, ExaminesARobotThatHasAnError) {
  const fs::path robot = write("odd.xml",
                               "<mujoco><worldbody>\n<body name='b' gravcomp='1'><freejoint/><geom size='.1'/></body>\n"
                               "</worldbody></mujoco>\n");
  const Result strict = murosimf("check " + robot.string() + " --json -");
  EXPECT_EQ(strict.exit_code, 1);
  EXPECT_NE(strict.output.find("\"severity\": \"error\""), std::string::npos) << strict.output;
  EXPECT_NE(strict.output.find("odd.xml:2"), std::string::npos);
  EXPECT_NE(strict.output.find("\"bodies\": 1"), std::string::npos) << "what can be read is shown";
  EXPECT_EQ(murosimf("check " + robot.string() + " --lenient").exit_code, 0);
}

TEST(Cli, WritesThePictureAndTheRolesOfARobot) {
  const fs::path picture = scratch("robot.png"), roles = scratch("robot.toml");
  const fs::path robot = write("plain.xml",
                               "<mujoco><worldbody><body name='b'><freejoint/><geom size='.1'/><body name='arm'>"
                               "<joint name='j'/><geom size='.1' pos='.3 0 0'/></body></body></worldbody>"
                               "<actuator><motor joint='j' forcerange='-2 2'/></actuator></mujoco>");
  fs::remove(roles);
  const Result result =
      murosimf("check " + robot.string() + " --roles " + roles.string() + " --picture " + picture.string());
  if (result.errors == "") {
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(read_file(picture).substr(1, 3), "PNG");
  } else {
    EXPECT_NE(result.errors.find("pictures"), std::string::npos) << result.errors;
  }
  EXPECT_NE(result.output.find("arm"), std::string::npos) << result.output;
  EXPECT_NE(read_file(roles).find("[servos.servo_1]"), std::string::npos);
  expect_mistake("check " + robot.string() + " --roles " + roles.string(), {"it is there already"});
  expect_mistake("check kid21 --roles " + scratch("kid21.toml").string(), {"the TOML file beside the robot"});
  expect_mistake("check kid21 --picture /no/such/folder/p.png", {"/no/such/folder/p.png"});
}

TEST(CliMistakes, InTheCommandLine) {
  expect_mistake("", {"subcommand"});
  expect_mistake("fly", {"unknown command 'fly'"});
  expect_mistake("run", {"scene"});
  expect_mistake("run walk --threads 0", {"--threads"});
  expect_mistake("run walk --seed -1", {"--seed"});
  expect_mistake("list robots", {"robots"});
  expect_mistake("list plan", {"name a scene"});
  expect_mistake("list plan three_on_thre", {"three_on_thre.toml", "among the scenes"});
  expect_mistake("list levels walk", {"only 'plan' is of a scene"});
  expect_mistake("run walk --duration -1", {"--duration -1"});
  expect_mistake("run walk --duration nan", {"--duration nan"});
  expect_mistake("run walk --duration 1e300", {"--duration"});
  expect_mistake("run walk --speed fast", {"--speed 'fast'"});
  expect_mistake("run walk --speed 0", {"speed 0"});
  expect_mistake("run walk --set walker.levl=x", {"did you mean 'level'?"});
  expect_mistake("run walk --set walker.contact=implicit",
                 {"--set 'walker.contact=implicit'", "unknown contact law 'implicit'",
                  "did you mean 'implicit_stick'?"});
}

TEST(CliMistakes, InFiles) {
  expect_mistake("run no_such_scene", {"no file 'no_such_scene'"});
  expect_mistake("run " + write("empty.toml", "").string(), {"empty"});
  expect_mistake("run " + write("broken.toml", "a = 1\nb = [1,\n").string(), {"broken.toml:"});
  expect_mistake("run " + scene_with_model("/no/such/model.xml").string(), {"scene.toml:1:1", "/no/such/model.xml"});
  expect_mistake("run " + scene_with_model(write("text.xml", "not xml at all")).string(), {"text.xml"});
  expect_mistake("check " + write("text.xml", "not xml at all").string(), {"text.xml"}, 1);
  const std::string head =
      "<mujoco><worldbody>\n<body name='b'><freejoint/><inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>\n";
  const std::string tail = "</body></worldbody></mujoco>\n";
  expect_mistake(
      "check " +
          write("axis.xml",
                head +
                    "<body><joint name='j' axis='0 0 0'/><inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/></body>" +
                    tail)
              .string(),
      {"axis.xml:3", "axis"}, 1);
  expect_mistake(
      "check " +
          write("mass.xml",
                head +
                    "<body><joint name='j' axis='0 0 1'/><inertial pos='0 0 0' mass='-1' diaginertia='1 1 1'/></body>" +
                    tail)
              .string(),
      {"mass.xml:3", "mass"}, 1);
}

TEST(Cli, WritesNumberedPicturesAndTheSameResult) {
  const fs::path folder = scratch("pictures");
  const Result plain = murosimf("run walk --duration 0.5 --json -");
  const Result result =
      murosimf("run walk --duration 0.5 --json - --pictures " + folder.string() + " --picture-every 0.2");
  for (const char* missing : {"cairo was missing", "no pictures by OpenGL"}) {
    if (result.errors.find(missing) != std::string::npos) GTEST_SKIP() << result.errors;
  }
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  for (const char* name : {"0000.png", "0001.png", "0002.png"}) EXPECT_EQ(read_file(folder / name).substr(1, 3), "PNG");
  EXPECT_FALSE(fs::exists(folder / "0003.png"));
  const auto hash = [](const Result& r) { return r.output.substr(r.output.find("state_hash"), 34); };
  EXPECT_EQ(hash(result), hash(plain));
}

TEST(CliMistakes, OutputsThatCannotBeWrittenAreRefusedBeforeTheRun) {
  expect_mistake("run walk --duration 1 --json /no/such/folder/report.json",
                 {"cannot write '/no/such/folder/report.json'"});
  expect_mistake("run walk --duration 1 --picture /no/such/folder/field.png", {"/no/such/folder/field.png"});
  expect_mistake("run walk --duration 1 --pictures /proc/no/such/folder", {"/proc/no/such/folder"});
  expect_mistake("run walk --duration 1 --pictures /dev/null", {"/dev/null"});
  expect_mistake("run walk --duration 1 --pictures " + scratch("pictures").string() + " --picture-every 0",
                 {"--picture-every 0: must be at least 0.001 s"});
  expect_mistake("run walk --duration 1 --picture-every 1", {"--pictures"});
  expect_mistake("run walk --duration 1 --json /tmp", {"cannot write '/tmp'"});
}

TEST(CliMistakes, AFullDiskIsReported) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const fs::path err = scratch("err");
  const int status =
      std::system((std::string(MUROSIMF_PROGRAM) + " run walk --duration 0.1 >/dev/full 2>" + err.string()).c_str());
  EXPECT_EQ(WEXITSTATUS(status), 2);
  EXPECT_NE(read_file(err).find("cannot write to standard output"), std::string::npos);
}

TEST(Cli, RefusesToBenchWhatItDoesNotKnow) {
  expect_mistake("bench", {"what"});
  expect_mistake("bench colision", {"colision", "collision"});
  expect_mistake("bench collision --json /nowhere/b.json", {"/nowhere/b.json"});
}

TEST(Cli, ListsBoundingVolumes) {
  const Result result = murosimf("list volumes");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.output, "sphere\naabb\nobb\ncapsule\n");
}

TEST(Cli, SaysWhichBoundingVolumesThereAre) {
  expect_mistake("run walk --set 'walker.volume=spere'", {"walker", "spere", "sphere"});
  expect_mistake("run walk --set 'walker.no_contact=[[\"l_foot\",\"r_fot\"]]' --set walker.self_collision=true",
                 {"walker", "r_fot", "r_foot"});
}

/// A recording of a servo at rest whose goal jumps and which follows in part; 1 s.
std::string servo_log(const std::string& trajectory = "step", const std::string& motor = "xl330") {
  std::ostringstream text;
  text << "{\"mass\": 0.49, \"length\": 0.1, \"kp\": 400, \"motor\": \"" << motor << "\", \"trajectory\": \""
       << trajectory << "\", \"entries\": [";
  for (int i = 0; i <= 100; ++i) {
    const double t = 0.005 * i, position = t < 0.2 ? 0.0 : 0.35 * (1 - 1 / (1 + 60 * (t - 0.2) * (t - 0.2)));
    text << (i ? ",\n" : "\n") << "{\"timestamp\": " << t << ", \"position\": " << position
         << ", \"speed\": 0, \"input_volts\": 7.3, \"goal_position\": " << (t < 0.2 ? 0.0 : 0.6)
         << ", \"torque_enable\": true}";
  }
  return text.str() + "]}";
}

TEST(Cli, FitsAServoAndReplaysIt) {
  const fs::path log = write("log.json", servo_log()), servo = scratch("servo.toml"), again = scratch("again.toml");
  const std::string command = "fit-servo " + log.string() + " --model m1 --starts 2 --seed 3";
  const Result on_two_threads = murosimf(command + " --threads 2 --out " + again.string());
  if (on_two_threads.errors.find("NLopt was missing") != std::string::npos) GTEST_SKIP() << "no NLopt in this build";
  EXPECT_EQ(on_two_threads.exit_code, 0) << on_two_threads.errors;
  const Result fit = murosimf(command + " --threads 1 --json - --out " + servo.string());
  EXPECT_EQ(fit.exit_code, 0) << fit.errors;
  EXPECT_EQ(fit.errors, "") << "no progress where there is no terminal";
  EXPECT_NE(fit.output.find("\"prior\": \"xl330\""), std::string::npos) << fit.output;
  EXPECT_EQ(read_file(servo), read_file(again)) << "the same seed, the same file";

  const Result replay = murosimf("replay-servo " + log.string() + " --servo " + servo.string() + " --json -");
  EXPECT_EQ(replay.exit_code, 0) << replay.errors;
  const auto error_in = [](const std::string& json) {
    const auto place = json.find("\"mean_error_rad\": ");
    return json.substr(place, json.find_first_of(",\n", place) - place);
  };
  EXPECT_EQ(error_in(replay.output), error_in(fit.output)) << "the file holds the servo that was fitted";
}

TEST(Cli, SaysWhatAFitHasNotSeen) {
  const fs::path folder = scratch("logs");
  fs::create_directories(folder);
  std::ofstream(folder / "a.json") << servo_log("step");
  std::ofstream(folder / "b.json") << servo_log("jump");
  const Result result =
      murosimf("fit-servo " + folder.string() + " --model m1 --starts 1 --prior none --cross-validate trajectory" +
               " --validate " + (folder / "b.json").string() + " --out " + scratch("servo.toml").string());
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  for (const char* part : {"mean of step, fitted to the others", "mean of logs that were not fitted", "left out: jump",
                           "share of windows 0, by what fits foresee of other trajectories: 0: "}) {
    EXPECT_NE(result.output.find(part), std::string::npos) << part << " in\n" << result.output;
  }
}

/// A roll of 1 m/s that loses 0.3 m/s^2, 40 times per second until it stops.
std::string roll_log() {
  std::ostringstream text;
  text << "time [s],ball.position.x [m]\n";
  for (int i = 0; i < 150; ++i) {
    const double t = std::min(i / 40.0, 1 / 0.3);
    text << i / 40.0 << ',' << t - 0.15 * t * t << '\n';
  }
  return text.str();
}

TEST(Cli, FitsContactAndScenesTakeIt) {
  const fs::path log = write("roll.csv", roll_log()), out = scratch("ball.toml");
  const Result fit =
      murosimf("fit-contact --roll " + log.string() + " --pair ball carpet --json - --out " + out.string());
  EXPECT_EQ(fit.exit_code, 0) << fit.errors;
  // 0.3 m/s^2 of a solid ball: 7/5 x 0.3 / 9.81 = 0.04281
  EXPECT_NE(read_file(out).find("rolling = 0.04281"), std::string::npos) << read_file(out);
  EXPECT_NE(fit.output.find("\"key\": \"rolling\""), std::string::npos) << fit.output;
  const fs::path scene = write("fitted.toml", "duration = 0.1\n[ball]\n" + read_file(out));
  EXPECT_EQ(murosimf("run " + scene.string()).exit_code, 0);
}

TEST(CliMistakes, InContactFits) {
  const std::string log = write("roll.csv", roll_log()).string(), out = " --out " + scratch("b.toml").string();
  const std::string pair = " --pair ball carpet";
  expect_mistake("fit-contact" + pair + out, {"nothing to fit", "--roll"});
  expect_mistake("fit-contact --roll " + log + " --pair ball" + out, {"--pair takes two"});
  expect_mistake("fit-contact --roll " + log + out, {"--pair"});
  expect_mistake("fit-contact --roll " + log + pair + " --radius 0.05" + out, {"--mass"});
  expect_mistake("fit-contact --drop " + log + pair + out, {"roll.csv", "no column 'z'"});
  expect_mistake("fit-contact --roll none.csv" + pair + out, {"none.csv"});
  expect_mistake("fit-contact --roll " + log + pair + " --out " + log, {"roll.csv"});
  expect_mistake("fit-contact --roll " + write("two.csv", "time,x\n0,0\n1,1\n").string() + pair + out,
                 {"two.csv", "2 samples"});
}

TEST(CliMistakes, InServoFits) {
  const std::string log = write("log.json", servo_log()).string(), out = " --out " + scratch("s.toml").string();
  if (murosimf("fit-servo " + log + " --model m7" + out).errors.find("NLopt was missing") != std::string::npos) {
    GTEST_SKIP() << "no NLopt in this build";
  }
  expect_mistake("fit-servo " + log + " --model m7" + out, {"unknown friction model 'm7'"});
  expect_mistake("fit-servo " + log + " --servo xl333" + out, {"unknown servo type 'xl333'", "xl330"});
  expect_mistake("fit-servo " + log + " --servo mx28" + out, {"mx28", "firmware_gain"});
  expect_mistake("fit-servo " + log + " --prior xl33" + out, {"unknown prior 'xl33'", "xl330"});
  expect_mistake("fit-servo " + log + " --out /nowhere/s.toml", {"/nowhere"});
  expect_mistake("fit-servo " + log + " --cross-validate gain" + out, {"all logs have the same gain"});
  expect_mistake("fit-servo " + log + " --cross-validate color" + out, {"unknown split 'color'"});
  expect_mistake("fit-servo none.json" + out, {"there is no log 'none.json'"});
  expect_mistake("fit-servo " + write("cut.json", servo_log().substr(0, 300)).string() + out, {"cut.json", "no JSON"});
  const std::string other = write("other.json", servo_log("step", "mx64")).string();
  expect_mistake("fit-servo " + log + " " + other + out, {"other motors"});
  expect_mistake("replay-servo " + log + " --servo xl333", {"unknown servo type 'xl333'", "xl330"});
  expect_mistake("replay-servo " + log + " --servo mx28", {"firmware_gain"});
  expect_mistake("replay-servo " + log, {"--servo"});
}

TEST(CliMistakes, PlotsNeedGnuplot) {
  const std::string log = write("log.json", servo_log()).string();
  const char* path = std::getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  expect_mistake("replay-servo " + log + " --servo xl330 --plot " + scratch("plots").string(), {"gnuplot"});
  setenv("PATH", path, 1);
}

}  // namespace
}  // namespace murosimf::test
