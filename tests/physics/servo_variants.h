/// servo_variants.h - kid21 with other servos.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "murosimf/io/mjcf_reader.h"

namespace murosimf::test {

/// kid21 with this number of all servos scaled, by a changed copy of its table.
inline ModelPtr kid21_with(const std::string& key, double factor) {
  const std::filesystem::path models = std::string(MUROSIMF_SOURCE_DIR) + "/models";
  const std::filesystem::path copy = testing::TempDir() + fmt::format("kid21_{}_{}_{}", key, factor, getpid());
  std::filesystem::create_directories(copy);
  std::filesystem::copy_file(models / "kid21.xml", copy / "kid21.xml");
  std::ifstream table(models / "kid21.toml");
  std::ofstream changed(copy / "kid21.toml");
  int found = 0;
  for (std::string line; std::getline(table, line);) {
    if (line.rfind(key + " = ", 0) == 0) {
      line = fmt::format("{} = {}", key, factor * std::stod(line.substr(key.size() + 3)));
      ++found;
    }
    changed << line << '\n';
  }
  changed.close();
  EXPECT_GT(found, 0) << "no servo says " << key;
  ModelPtr model = io::read_mjcf(copy / "kid21.xml").model;
  std::filesystem::remove_all(copy);
  return model;
}

}  // namespace murosimf::test
