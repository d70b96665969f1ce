/// program.h - runs the program from outside and looks at what it says.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/temp_folder.h"

namespace murosimf::test {

namespace fs = std::filesystem;

struct Result {
  int exit_code = 0;
  std::string output, errors;
};

inline std::string read_file(const fs::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

inline fs::path scratch(const std::string& name) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  return fixtures::temp_folder() / (std::string("cli_") + info->test_suite_name() + "_" + info->name() + "_" + name);
}

inline Result murosimf(const std::string& arguments) {
  const fs::path out = scratch("out"), err = scratch("err");
  const std::string command =
      std::string(MUROSIMF_PROGRAM) + " " + arguments + " >" + out.string() + " 2>" + err.string() + " </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(out), read_file(err)};
}

/// One line on standard error that has all the parts; no output.
inline void expect_mistake(const std::string& arguments, const std::vector<std::string>& parts, int exit_code = 2) {
  const Result result = murosimf(arguments);
  EXPECT_EQ(result.exit_code, exit_code) << arguments;
  EXPECT_EQ(result.output, "") << arguments;
  EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
  for (const std::string& part : parts)
    EXPECT_NE(result.errors.find(part), std::string::npos) << arguments << " said: " << result.errors;
}

inline fs::path write(const std::string& name, const std::string& text) {
  const fs::path file = scratch(name);
  std::ofstream(file) << text;
  return file;
}

}  // namespace murosimf::test
