/// robot_data.h - robot files of teams, which are no part of this project: tests that want them are skipped without.
#pragma once

#include <cstdlib>
#include <filesystem>

namespace murosimf {

/// The folder that MUROSIMF_TEST_DATA names, or shared/data beside the project.
inline std::filesystem::path test_data() {
  const char* variable = std::getenv("MUROSIMF_TEST_DATA");
  return variable ? std::filesystem::path(variable) : std::filesystem::path(MUROSIMF_SOURCE_DIR) / "../shared/data";
}

inline std::filesystem::path k1_urdf() { return test_data() / "robots/booster_k1/K1_22dof.urdf"; }
inline std::filesystem::path k1_mjcf() { return test_data() / "robots/booster_k1/K1_22dof.xml"; }
inline std::filesystem::path wolfgang_urdf() {
  return test_data() / "robots/wolfgang_op/wolfgang_description/urdf/robot.urdf";
}

}  // namespace murosimf
