/// written_scene.h - the scene of one test, as a file.
#pragma once

#include <algorithm>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/temp_folder.h"

namespace murosimf::fixtures {

/// Writes the scene of the running test, in the place of what it has written before. The file's name.
inline std::string write_scene(const std::string& text) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(test->test_suite_name()) + "_" + test->name() + ".toml";
  std::ranges::replace(name, '/', '_');  // of tests with parameters
  std::string file = (temp_folder() / name).string();
  std::ofstream(file) << text;
  return file;
}

}  // namespace murosimf::fixtures
