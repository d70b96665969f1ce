// `murosimf convert`: what it writes, and what it leaves as it is.
#include "tests/apps/program.h"

namespace murosimf::test {
namespace {

TEST(Convert, WritesAModelOnceUnlessForced) {
  const fs::path folder = scratch("folder"), out = folder / "robot.xml";
  fs::create_directories(folder);
  const Result first = murosimf("convert kid21 --out " + out.string());
  EXPECT_EQ(first.exit_code, 0) << first.errors;
  EXPECT_NE(first.output.find("21 joints, 4.3 kg"), std::string::npos) << first.output;
  EXPECT_EQ(read_file(folder / "robot.toml"), read_file(fs::path(MUROSIMF_SOURCE_DIR) / "models/kid21.toml"));
  EXPECT_NE(murosimf("check " + out.string()).output.find("4.3"), std::string::npos);

  expect_mistake("convert kid21 --out " + out.string(), {"robot.xml", "--force"});
  expect_mistake("convert " + out.string() + " --force --out " + out.string(),
                 {"this file is read by the same command"});
  const Result again = murosimf("convert kid21 --force --out " + out.string());
  EXPECT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_NE(again.output.find("kept as it is"), std::string::npos) << again.output;
}

// A table that names its files has them at the new place: a motion and the one that it mirrors, steps, a servo, a part.
TEST(Convert, BringsTheFilesThatTheTableNames) {
  const fs::path source = fs::path(MUROSIMF_SOURCE_DIR), from = scratch("from"), to = scratch("to"),
                 out = to / "robot.xml";
  fs::create_directories(from / "motions/kicks");
  fs::create_directories(to);
  fs::copy(source / "models/kid21.xml", from / "robot.xml");
  fs::copy(source / "models/kid21_steps.csv", from / "step_multiple.csv");
  fs::copy(source / "motions/kick_right.toml", from / "motions/kicks/right.toml");
  fs::copy(source / "servos/mx28.toml", from / "neck.toml");
  fs::copy(source / "parts/mpu6050.toml", from / "inertial.toml");
  fs::copy(source / "motions/dive_left.toml", scratch("dive.toml"));
  std::ofstream(from / "left.toml") << "mirror_of = \"kicks/right\"\n";
  std::ofstream(from / "robot.toml")
      << "[soles]\nleft = 'l_sole'\nright = 'r_sole'\n[balance]\nsteps = 'step_multiple.csv'\n"
         "[motions]\nkick_left = 'left.toml'\nget_up_front = 'get_up_front'\ndive_left = '../"
      << scratch("dive.toml").filename().string()
      << "'\n[servos.neck]\ntype = 'neck.toml'\njoints = ['j_neck']\n[sensors.imu]\ntype = 'imu'\npart = "
         "'inertial.toml'\n";
  const Result result = murosimf("convert " + (from / "robot.xml").string() + " --out " + out.string());
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  for (const char* file :
       {"step_multiple.csv", "left.toml", "motions/kicks/right.toml", "neck.toml", "inertial.toml"}) {
    EXPECT_EQ(read_file(to / file), read_file(from / file)) << file;
    EXPECT_NE(result.output.find((to / file).string() + ": copied"), std::string::npos) << result.output;
  }
  EXPECT_FALSE(fs::exists(to / "motions/get_up_front.toml")) << "the program has it";
  EXPECT_NE(result.output.find("dive.toml: the TOML file names it, but"), std::string::npos) << result.output;
  fs::rename(from, scratch("away"));
  EXPECT_EQ(murosimf("check " + out.string()).errors, "") << "nothing of the old place is needed";
}

TEST(Convert, NamesMistakes) {
  expect_mistake("convert kid21", {"--out"});
  expect_mistake("convert kid21 --out robot.toml", {"'robot.toml'", ".xml"});
  expect_mistake("convert kid21 --out /no/such/folder/r.xml", {"/no/such/folder/r.xml", "there is no folder"});
  expect_mistake("convert kid22 --out " + scratch("r.xml").string(), {"kid22"});
  expect_mistake("convert kid21 --fit boxx --out " + scratch("r.xml").string(), {"--fit", "did you mean 'box'?"});
}

}  // namespace
}  // namespace murosimf::test
