/// proto_files.h - PROTO files of tests, in a folder of its own for every test, so that tests can run at the same time.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "murosimf/robot_formats/proto/proto_reader.h"
#include "tests/description_checks.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::robot_formats::proto::proto_files {

using description_checks::any_contains;
using description_checks::contains;
using description_checks::expect_near;
using description_checks::names_unused;

/// Writes a file into the test's folder.
inline std::filesystem::path write(const std::string& name, const std::string& text) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto file =
      fixtures::temp_folder() / (std::string("proto_") + test->test_suite_name() + "_" + test->name()) / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

inline robot_formats::RobotDescription read(const std::string& text, const robot_formats::ReaderOptions& options = {}) {
  return read_proto(write("robot.proto", text), options);
}

/// A Robot of 1 kg with children from line 5 on.
inline std::string robot(const std::string& children, const std::string& version = "R2023b") {
  return "#VRML_SIM " + version + " utf8\n" +
         "PROTO Mine [ field SFString name \"mine\" ]\n"
         "{ Robot { name IS name physics Physics { mass 1 inertiaMatrix [ 1 1 1, 0 0 0 ] }\n"
         "children [\n" +
         children + "\n] } }\n";
}

/// A Solid of 1 kg.
inline std::string limb(const std::string& inside = "", const std::string& name = "limb") {
  return "Solid { name \"" + name + "\" physics Physics { mass 1 inertiaMatrix [ 1 1 1, 0 0 0 ] } " + inside + " }";
}

/// A Robot with a boundingObject and this Physics in its own Solid.
inline std::string block(const std::string& bounding, const std::string& physics,
                         const std::string& version = "R2023b") {
  return "#VRML_SIM " + version + " utf8\nPROTO B [ ] { Solid { name \"b\"\nboundingObject " + bounding +
         "\nphysics Physics { " + physics + " } } }\n";
}

inline std::string message(const std::string& text, bool lenient = false) {
  return fixtures::error_of([&] { (void)read(text, {.lenient = lenient}); });
}

}  // namespace murosimf::robot_formats::proto::proto_files
