#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/robot_formats/sdf/sdf_program.h"

namespace murosimf::robot_formats::sdf {

bool has_sdf_program() { return false; }

std::filesystem::path sdf_program(const std::filesystem::path& file) {
  throw SetupError(
      fmt::format("{}: SDF files need libsdformat (libsdformat-dev), which this build has not", file.string()));
}

}  // namespace murosimf::robot_formats::sdf
