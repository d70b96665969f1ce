// Recording as a user meets it.
#include "tests/apps/program.h"

namespace murosimf::test {
namespace {

TEST(Record, WritesAFileAndALayoutBesideIt) {
  const fs::path file = scratch("run.mcap");
  const Result run = murosimf("run walk --duration 0.3 --record " + file.string());
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(read_file(file).substr(1, 4), "MCAP");
  EXPECT_NE(read_file(fs::path(file).replace_extension(".foxglove.json")).find("3D!bodies"), std::string::npos);
}

TEST(Record, MistakesAreOneLine) {
  expect_mistake("run walk --record " + scratch("no/folder.mcap").string(), {"there is no folder"});
  expect_mistake("run walk --record-rate 10", {"--record-rate", "--record"});
  const std::string file = " --record " + scratch("run.mcap").string();
  expect_mistake("run walk --record-what everything" + file, {"--record-what", "everything", "poses"});
  expect_mistake("run walk --record-rate 5000" + file, {"5000 Hz", "1000"});
}

// A file system of 200 kB would need a privilege; a limit to the size of files does the same.
TEST(Record, GoesOnWithoutTheDiskAndSaysSoOnce) {
  const fs::path file = scratch("limited.mcap"), report = scratch("report.json");
  const std::string arguments = " run walk --duration 20 --record " + file.string() + " --json " + report.string();
  const std::string command = "ulimit -f 400; exec " + std::string(MUROSIMF_PROGRAM) + arguments;
  const fs::path errors = scratch("errors"), script = write("script.sh", command);
  const int status =
      std::system(("bash " + script.string() + " 2>" + errors.string() + " >/dev/null </dev/null").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 2);
  const std::string said = read_file(errors);
  EXPECT_NE(said.find("nothing is recorded any more: cannot write"), std::string::npos) << said;
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  EXPECT_NE(read_file(report).find("\"simulated_s\": 20"), std::string::npos) << "the run went on";
}

TEST(Record, IsReplayedWithTheReportOfTheRun) {
  const fs::path file = scratch("run.mcap");
  const std::string scene = "run three_on_three --no-cameras --duration 1";
  const Result plain = murosimf(scene), recorded = murosimf(scene + " --record " + file.string());
  EXPECT_EQ(state_hash_in(plain.output), state_hash_in(recorded.output));
  const Result replayed = murosimf("replay " + file.string());
  EXPECT_EQ(replayed.exit_code, 0) << replayed.errors;
  EXPECT_NE(replayed.output.find(recorded.output), std::string::npos) << replayed.output;
  EXPECT_NE(replayed.output.find("seed: 2\n"), std::string::npos) << replayed.output;
  EXPECT_NE(replayed.output.find("run three_on_three --no-cameras"), std::string::npos) << replayed.output;
}

// Sensors are recorded with all digits: the table is the log's, byte for byte.
TEST(Record, IsExportedAsTheLogOfTheSameRun) {
  const fs::path file = scratch("run.mcap"), log = scratch("log.csv"), table = scratch("table.csv");
  const Result run = murosimf("run nudge --duration 1 --record " + file.string() +
                              " --record-what sensors --log robot.imu --log robot.left_foot --out " + log.string());
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  const Result exported = murosimf("export " + file.string() + " robot.imu robot.left_foot --csv " + table.string());
  EXPECT_EQ(exported.exit_code, 0) << exported.errors;
  EXPECT_EQ(read_file(table), read_file(log));
  EXPECT_GT(read_file(log).size(), 10000U);
  const fs::path array = scratch("array.npy");
  EXPECT_EQ(murosimf("export " + file.string() + " --npy " + array.string()).exit_code, 0);
  EXPECT_EQ(read_file(array).substr(1, 5), "NUMPY");
}

TEST(Record, IsExportedAsMotionCapture) {
  const fs::path file = scratch("run.mcap"), motion = scratch("walker.bvh");
  EXPECT_EQ(murosimf("run walk --duration 0.5 --record " + file.string()).exit_code, 0);
  const std::string bvh = "export " + file.string() + " --bvh " + motion.string();
  const Result exported = murosimf(bvh + " --robot walker");
  EXPECT_EQ(exported.exit_code, 0) << exported.errors;
  EXPECT_EQ(exported.output + exported.errors, "");
  EXPECT_NE(read_file(motion).find("Frames: 51\nFrame Time: 0.010000000\n"), std::string::npos);
  expect_mistake(bvh + " --robot wlker", {"'wlker'", "did you mean 'walker'"});
  expect_mistake(bvh + " walker.*", {"--bvh", "no names of numbers"});
  expect_mistake("export " + file.string() + " --robot walker", {"--robot", "--bvh"});
}

TEST(Record, ExportAndReplayRefuseMistakesInOneLine) {
  const fs::path file = scratch("run.mcap");
  EXPECT_EQ(murosimf("run walk --duration 0.1 --record " + file.string()).exit_code, 0);
  const std::string csv = " --csv " + scratch("table.csv").string();
  expect_mistake("export " + file.string(), {"--csv", "--npy"});
  expect_mistake("export " + file.string() + " walker.j_l_shim" + csv, {"walker.j_l_shim", "unknown number"});
  const std::string table = write("table.txt", "time [s],x\n0,1\n").string();
  for (const std::string& command : {"export " + table + csv, "replay " + table, "repair " + table}) {
    expect_mistake(command, {table, "no MCAP file"});
  }
}

TEST(Record, CutOffIsReadWithAWarningAndRepaired) {
  const fs::path file = scratch("cut.mcap");
  EXPECT_EQ(murosimf("run walk --duration 3 --record " + file.string()).exit_code, 0);
  fs::resize_file(file, fs::file_size(file) * 2 / 3);
  const Result replayed = murosimf("replay " + file.string());
  EXPECT_EQ(replayed.exit_code, 0);
  EXPECT_NE(replayed.errors.find("'murosimf repair' mends it"), std::string::npos) << replayed.errors;
  EXPECT_NE(replayed.output.find("there is no report in it"), std::string::npos) << replayed.output;
  const Result repaired = murosimf("repair " + file.string());
  EXPECT_EQ(repaired.exit_code, 0) << repaired.errors;
  EXPECT_NE(repaired.output.find("is whole: "), std::string::npos) << repaired.output;
  EXPECT_EQ(murosimf("replay " + file.string()).errors, "");
}

}  // namespace
}  // namespace murosimf::test
