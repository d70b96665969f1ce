/// program.h - runs the program from outside and looks at what it says.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
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

/// A name that no other test has, in a folder that is removed at the end.
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

/// What a report says of the state at the end.
inline std::string state_hash_in(const std::string& report) {
  const auto place = report.find("state hash ");
  return place == std::string::npos ? "none: " + report : report.substr(place + 11, 16);
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

/// All commands of the program, as --help has them.
inline std::vector<std::string> commands() {
  std::vector<std::string> names;
  std::stringstream help(murosimf("--help").output);
  std::string line;
  while (std::getline(help, line) && line != "Subcommands:") continue;
  while (std::getline(help, line) && line.size() > 2) names.push_back(line.substr(2, line.find(' ', 2) - 2));
  EXPECT_FALSE(names.empty()) << "the help looks different";
  return names;
}

/// Puts a program of this name, a shell script, into a folder. PATH with that folder first.
inline std::string path_with_program(const fs::path& folder, const std::string& name, const std::string& script) {
  fs::create_directories(folder);
  std::ofstream(folder / name) << "#!/bin/sh\n" << script << "\n";
  fs::permissions(folder / name, fs::perms::owner_all);
  return folder.string() + ":" + std::getenv("PATH");
}

/// One that says its version as the real ffmpeg, and then does as the script.
inline std::string path_with_ffmpeg(const fs::path& folder, const std::string& script) {
  return path_with_program(folder, "ffmpeg", "[ \"$1\" = -version ] && exit 0\n" + script);
}

}  // namespace murosimf::test
