// Logging and plotting as a user meets them.
#include "tests/apps/program.h"

namespace murosimf::test {
namespace {

bool has_gnuplot() { return std::system("gnuplot --version >/dev/null 2>&1") == 0; }

TEST(Log, IsATableOfNumbersOverTime) {
  const fs::path file = scratch("run.csv");
  const Result run =
      murosimf("run walk --duration 0.1 --log 'walker.pelvis.position' --log 'w*.l_foot.joint_velocity' --out " +
               file.string() + " --log-rate 50");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  const std::string text = read_file(file);
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "time [s],walker.pelvis.position.x [m],walker.pelvis.position.y [m],walker.pelvis.position.z [m],"
            "walker.l_foot.joint_velocity [rad/s]");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 5);
  EXPECT_NE(text.find("\n0.08,"), std::string::npos);
}

TEST(Log, IsAnArrayForNumPyIfItIsNamedSo) {
  const fs::path file = scratch("run.npy");
  const Result run = murosimf("run walk --duration 0.1 --log walker.pelvis.position --out " + file.string());
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  const std::string bytes = read_file(file);
  EXPECT_EQ(bytes.substr(1, 5), "NUMPY");
  EXPECT_NE(bytes.find("('walker.pelvis.position.z [m]', '<f8')], 'fortran_order': False, 'shape': (10,), }"),
            std::string::npos);
  expect_mistake("plot " + file.string(), {file.string(), "array for NumPy", "CSV"});
}

TEST(Log, OfAllJointsIsOnePicture) {
  const fs::path table = scratch("joints.csv"), picture = scratch("joints.png");
  const Result run = murosimf("run walk --duration 0.05 --log 'walker.*.joint_position' --out " + table.string());
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  const std::string text = read_file(table), header = text.substr(0, text.find('\n'));
  EXPECT_EQ(std::count(header.begin(), header.end(), ','), 21) << "joints only: " << header;
  if (!has_gnuplot()) GTEST_SKIP() << "no gnuplot here";
  const Result drawn = murosimf("plot " + table.string() + " --out " + picture.string());
  EXPECT_EQ(drawn.exit_code, 0) << drawn.errors;
  EXPECT_EQ(read_file(picture).substr(1, 3), "PNG");
}

TEST(Log, OfAMistakeIsOneLineAndNoFile) {
  const std::string out = " --out " + scratch("run.csv").string();
  expect_mistake("run walk --log walker.pelvis.position", {"--log", "--out"});
  expect_mistake("run walk" + out, {"--out", "--log"});
  expect_mistake("run walk --log-rate 50", {"--log-rate", "--log"});
  expect_mistake("run walk --log wlker.pelvis.position" + out, {"--log 'wlker", "did you mean 'walker'"});
  expect_mistake("run walk --log walker.pelvis.position --log-rate 0" + out, {"0 Hz"});
  expect_mistake("run walk --log walker.pelvis.position --log-rate fast" + out, {"--log-rate"});
  EXPECT_FALSE(fs::exists(scratch("run.csv")));
}

TEST(Log, IsRefusedBeforeTheRunWhereItCannotBeWritten) {
  expect_mistake("run eleven_a_side --duration 100000 --log '*.pelvis.position' --out /no/such/folder/run.csv",
                 {"cannot write '/no/such/folder/run.csv'"});
}

TEST(Log, OfAFullDiskIsOneLine) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const Result run = murosimf("run walk --duration 0.1 --log walker.pelvis.position --out /dev/full");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.errors.find("cannot write '/dev/full'"), std::string::npos) << run.errors;
  EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
}

TEST(PlotCommand, DrawsALogBesideIt) {
  if (!has_gnuplot()) GTEST_SKIP() << "no gnuplot here";
  const fs::path file = scratch("run.csv"), picture = scratch("run.png"), other = scratch("other.png");
  EXPECT_EQ(murosimf("run walk --duration 0.1 --log 'walker.pelvis.*_velocity' --out " + file.string()).exit_code, 0);
  EXPECT_EQ(murosimf("plot " + file.string()).errors, "");
  EXPECT_EQ(read_file(picture).substr(1, 3), "PNG");
  EXPECT_EQ(murosimf("plot " + file.string() + " '*.*.*.x' --out " + other.string()).exit_code, 0);
  EXPECT_EQ(read_file(other).substr(1, 3), "PNG");
  EXPECT_NE(read_file(other), read_file(picture));
}

TEST(PlotCommand, MistakesAreOneLine) {
  const std::string table = write("run.csv", "t,height\n0,1\n1,2\n").string();
  expect_mistake("plot /no/such/run.csv", {"/no/such/run.csv", "there is no such file"});
  expect_mistake("plot " + table + " heigt", {"run.csv", "did you mean 'height'"});
  expect_mistake("plot " + write("bad.csv", "t,a\n0,high\n").string(), {"bad.csv:2:3", "'high' is no number"});
  expect_mistake("plot " + table + " --out " + table, {"pictures are PNG files"});
  if (!has_gnuplot()) return;
  expect_mistake("plot " + table + " --out /no/such/folder/a.png", {"cannot write '/no/such/folder/a.png'"});
  expect_mistake("plot " + write("none.csv", "t,a\n").string(), {"nothing to draw"});
}

}  // namespace
}  // namespace murosimf::test
