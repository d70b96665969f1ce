/// sdf_files.h - SDF files of tests, in a folder of its own for every test, so that tests can run at the same time.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "murosimf/robot_formats/sdf/sdf_program.h"
#include "murosimf/robot_formats/sdf/sdf_reader.h"
#include "tests/description_checks.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::robot_formats::sdf::sdf_files {

using description_checks::any_contains;
using description_checks::contains;
using description_checks::expect_near;
using description_checks::names_unused;

/// Tests of what libsdformat resolves; where it is missing they skip themselves.
class SdfTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_sdf_program()) GTEST_SKIP() << "this build has no libsdformat";
  }
};

/// Writes a file into the test's folder.
inline std::filesystem::path write(const std::string& name, const std::string& text) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto file =
      fixtures::temp_folder() / (std::string("sdf_") + test->test_suite_name() + "_" + test->name()) / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

inline robot_formats::RobotDescription read(const std::string& text, const robot_formats::ReaderOptions& options = {}) {
  return read_sdf(write("robot.sdf", text), options);
}

/// A model with links and joints from line 2 on.
inline std::string model(const std::string& inside, const std::string& name = "r") {
  return "<sdf version='1.9'><model name='" + name + "'>\n" + inside + "\n</model></sdf>\n";
}

inline std::string inertial() {
  return "<inertial><mass>2</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>";
}

inline std::string link(const std::string& name, const std::string& inside = "") {
  return "<link name='" + name + "'>" + inertial() + inside + "</link>\n";
}

inline std::string joint(const std::string& type, const std::string& parent, const std::string& child,
                         const std::string& inside = "", const std::string& name = "j") {
  return "<joint name='" + name + "' type='" + type + "'><parent>" + parent + "</parent><child>" + child + "</child>" +
         inside + "</joint>\n";
}

/// Links a and b, and a joint j from one to the other.
inline std::string pair(const std::string& type, const std::string& inside = "", const std::string& child_pose = "") {
  return model(link("a") + link("b", child_pose) + joint(type, "a", "b", inside));
}

inline robot_formats::JointDescription joint_of(const std::string& type, const std::string& inside) {
  return read(pair(type, inside)).bodies.at(1).joints.at(0);
}

inline std::string message(const std::string& text, bool lenient = false) {
  return fixtures::error_of([&] { (void)read(text, {.lenient = lenient}); });
}

/// The place of a body in the base.
inline Transformd place_in_base(const robot_formats::RobotDescription& robot, const std::string& name) {
  Transformd place;
  int i = 0;
  while (robot.bodies.at(i).name != name) ++i;
  for (; robot.bodies[i].parent >= 0; i = robot.bodies[i].parent) place = robot.bodies[i].place * place;
  return place;
}

}  // namespace murosimf::robot_formats::sdf::sdf_files
