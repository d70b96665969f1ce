/// servo_variants.h - kid21 with other servos.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "murosimf/robot/robot_reader.h"
#include "tests/temp_folder.h"

namespace murosimf::test {

/// kid21 with this number of all servos scaled, by a changed copy of its table.
inline ModelPtr kid21_with(const std::string& key, double factor) {
  const std::filesystem::path models = std::string(MUROSIMF_SOURCE_DIR) + "/models";
  const std::filesystem::path copy =
      fixtures::temp_folder().string() + "/" + fmt::format("kid21_{}_{}_{}", key, factor, getpid());
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
  ModelPtr model = robot::read_robot(copy / "kid21.xml").model;
  std::filesystem::remove_all(copy);
  return model;
}

/// kid21 whose legs have an MX-64 at 12 V with friction model M6, motor and friction of one published set (Duclusaud et al., ICRA
/// 2025, parameter files of github.com/Rhoban/bam): k_t = 1.602 N m/A, R = 2.316 ohm.
inline ModelPtr kid21_with_m6() {
  const std::filesystem::path models = std::string(MUROSIMF_SOURCE_DIR) + "/models";
  const std::filesystem::path copy = fixtures::temp_folder().string() + "/" + fmt::format("kid21_m6_{}", getpid());
  std::filesystem::create_directories(copy);
  std::filesystem::copy_file(models / "kid21.xml", copy / "kid21.xml");
  std::ifstream table(models / "kid21.toml");
  std::ofstream changed(copy / "kid21.toml");
  bool legs = false;
  for (std::string line; std::getline(table, line);) {
    if (line.starts_with("[")) legs = line == "[servos.mx64]";
    const bool number = legs && line.find(" = ") != std::string::npos && !line.starts_with("joints");
    if (!number) changed << line << '\n';
    if (line != "[servos.mx64]") continue;
    changed << "voltage = 12\nstall_torque = 8.300\nno_load_speed = 7.491\nposition_gain = 41.97\nduty_limit = 0.9625\n"
               "rotor_inertia = 0.01227\ncoulomb_friction = 6e-7\nviscous_friction = 0.02534\n"
               "stribeck_friction = 0.1227\nstribeck_rate = 2.575\nstribeck_exponent = 0.841\n"
               "motor_load_friction = 0.3115\nexternal_load_friction = 2e-8\nstribeck_motor_load_friction = 0.1877\n"
               "stribeck_external_load_friction = 0.0141\nquadratic_motor_load_friction = 0.00691\n"
               "quadratic_external_load_friction = 0.0100\n";
  }
  changed.close();
  ModelPtr model = robot::read_robot(copy / "kid21.xml").model;
  std::filesystem::remove_all(copy);
  return model;
}

}  // namespace murosimf::test
