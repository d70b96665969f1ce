/// urdf_files.h - URDF files of tests, in a folder of its own for every test, so that tests can run at the same time.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "murosimf/robot_formats/urdf/urdf_reader.h"
#include "tests/description_checks.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::robot_formats::urdf::urdf_files {

using description_checks::any_contains;
using description_checks::contains;
using description_checks::expect_near;
using description_checks::names_unused;

inline std::filesystem::path test_folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string("urdf_") + test->test_suite_name() + "_" + test->name();
  std::ranges::replace(name, '/', '_');
  const auto folder = fixtures::temp_folder() / name;
  std::filesystem::create_directories(folder);
  return folder;
}

/// Writes a file into the test's folder.
inline std::filesystem::path write(const std::string& name, const std::string& text) {
  const auto file = test_folder() / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

inline robot_formats::RobotDescription read(const std::string& text, const robot_formats::ReaderOptions& options = {}) {
  return read_urdf(write("robot.urdf", text), options);
}

/// A tetrahedron with legs of 1 m as an OBJ file.
inline std::string tetrahedron() { return "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"; }

/// <robot> and its base, a link of 1 kg, in line 1; `inside` begins in line 2.
inline std::string robot_xml(const std::string& inside) {
  return "<robot name='r'><link name='base'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1'/></inertial>"
         "</link>\n" +
         inside + "</robot>";
}

inline std::string link(const std::string& name, const std::string& inside = "") {
  return "<link name='" + name + "'>" + inside + "</link>\n";
}

inline std::string solid(double mass = 1) {
  return "<inertial><mass value='" + std::to_string(mass) + "'/><inertia ixx='1' iyy='1' izz='1'/></inertial>";
}

/// A joint in one line.
inline std::string joint(const std::string& type, const std::string& parent, const std::string& child,
                         const std::string& inside = "", const std::string& name = "j") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" + child + "'/>" +
         inside + "</joint>\n";
}

/// The base and a limb at joint `j`, which stands in line 3.
inline std::string with_joint(const std::string& type, const std::string& inside) {
  return robot_xml(link("limb", solid()) + joint(type, "base", "limb", inside));
}

const std::string any_limit = "<limit lower='-1' upper='1' effort='2' velocity='3'/>";

/// A robot of one link; `inside` stands in line 2.
inline std::string with_link(const std::string& inside) {
  return "<robot name='r'><link name='base'>\n" + inside + "</link></robot>";
}

inline std::string collision_xml(const std::string& geometry) {
  return "<collision><geometry>" + geometry + "</geometry></collision>";
}
inline std::string visual(const std::string& geometry, const std::string& material = "") {
  return "<visual><geometry>" + geometry + "</geometry>" + material + "</visual>";
}

inline std::string message(const std::string& text, bool lenient = false) {
  return fixtures::error_of([&] { (void)read(text, {.lenient = lenient}); });
}

}  // namespace murosimf::robot_formats::urdf::urdf_files
