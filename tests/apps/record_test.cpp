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
  const std::string command = "trap '' XFSZ; ulimit -f 400; exec " + std::string(MUROSIMF_PROGRAM) + arguments;
  const fs::path errors = scratch("errors"), script = write("script.sh", command);
  const int status =
      std::system(("bash " + script.string() + " 2>" + errors.string() + " >/dev/null </dev/null").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 2);
  const std::string said = read_file(errors);
  EXPECT_NE(said.find("nothing is recorded any more: cannot write"), std::string::npos) << said;
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  EXPECT_NE(read_file(report).find("\"simulated_s\": 20"), std::string::npos) << "the run went on";
}

}  // namespace
}  // namespace murosimf::test
