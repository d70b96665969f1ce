/// xacro_file_test - robots with macros; those that start the program are skipped where it is not installed.
#include "murosimf/robot_formats/urdf/xacro_file.h"

#include <cstdlib>

#include "murosimf/files/child_process.h"
#include "murosimf/files/file_access.h"
#include "tests/fixtures.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot_formats::urdf {
namespace {

using urdf_files::test_folder;
using urdf_files::write;

bool has_xacro() {
  const auto result = files::run_process({"python3", "-c", "import xacro"}, "");
  return result && result->exit_code == 0;
}

std::string with_macros(const std::string& include = "") {
  return "<robot name='r' xmlns:xacro='http://ros.org/wiki/xacro'><xacro:arg name='mass' default='2'/>" + include +
         "<xacro:macro name='ball' params='name'><link name='${name}'><inertial><mass value='${$(arg mass) / 4}'/>"
         "<inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link></xacro:macro>"
         "<xacro:ball name='base'/></robot>";
}

TEST(Xacro, MacrosAndArgumentsCount) {
  if (!has_xacro()) GTEST_SKIP() << "python3 has no package xacro: pip install xacro";
  const auto file = write("robot.urdf.xacro", with_macros());
  EXPECT_EQ(read_xacro(file).bodies[0].solid.mass, 0.5);
  EXPECT_EQ(read_xacro(file, {.xacro = {{"mass", "6"}}}).bodies[0].solid.mass, 1.5);
}

TEST(Xacro, PackagesAreFoundAsThoseOfMeshes) {
  if (!has_xacro()) GTEST_SKIP() << "python3 has no package xacro: pip install xacro";
  write("parts_of_it/more.xacro",
        "<robot><link name='more'/><joint name='j' type='fixed'><parent link='base'/>"
        "<child link='more'/></joint></robot>");
  const auto file =
      write("robots/robot.xacro", with_macros("<xacro:include filename='$(find parts_of_it)/more.xacro'/>"));
  EXPECT_EQ(read_xacro(file).bodies.size(), 2u);
  const auto lost = write("robots/lost.xacro", with_macros("<xacro:include filename='$(find nowhere)/more.xacro'/>"));
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { (void)read_xacro(lost); }),
                             {"lost.xacro: there is no package 'nowhere'", "MUROSIMF_PACKAGE_PATH"}));
}

// Python searches for modules in the folder where it is started, which may be that of a downloaded robot.
TEST(Xacro, NoModuleBesideTheRobotIsRun) {
  if (!has_xacro()) GTEST_SKIP() << "python3 has no package xacro: pip install xacro";
  const auto file = write("robot.urdf.xacro", with_macros());
  write("xacro.py", "open('was_run', 'w')");
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(test_folder());
  const double mass = read_xacro(file).bodies[0].solid.mass;
  std::filesystem::current_path(before);
  EXPECT_EQ(mass, 0.5);
  EXPECT_FALSE(std::filesystem::exists(test_folder() / "was_run"));
}

TEST(Xacro, MistakesAreOneLine) {
  if (!has_xacro()) GTEST_SKIP() << "python3 has no package xacro: pip install xacro";
  const auto file = write("robot.xacro", with_macros("<xacro:nothing/>"));
  const std::string error = fixtures::error_of([&] { (void)read_xacro(file); });
  EXPECT_TRUE(fixtures::says(error, {"robot.xacro: xacro gives up: ", "nothing"}));
  EXPECT_EQ(error.find('\n'), std::string::npos);
}

// No program is started for a file that comes over a network.
TEST(Xacro, IsRefusedWhereReadsAreLimited) {
  const auto file = write("robot.xacro", with_macros());
  const auto allowed = std::make_shared<const files::AllowedFiles>(std::vector<std::filesystem::path>{test_folder()});
  const files::FileScope only({.only_from = allowed});
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { (void)read_xacro(file); }), {"comes over a network"}));
}

TEST(Xacro, WithoutPythonTheMessageSaysWhatToInstall) {
  const auto file = write("robot.xacro", with_macros());
  const char* path = std::getenv("PATH");
  const std::string before = path ? path : "";
  setenv("PATH", test_folder().c_str(), 1);
  const std::string error = fixtures::error_of([&] { (void)read_xacro(file); });
  setenv("PATH", before.c_str(), 1);
  EXPECT_TRUE(fixtures::says(error, {"pip install xacro"}));
}

}  // namespace
}  // namespace murosimf::robot_formats::urdf
