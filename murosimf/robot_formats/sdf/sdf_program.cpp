#include "murosimf/robot_formats/sdf/sdf_program.h"

#include <array>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::robot_formats::sdf {

namespace fs = std::filesystem;

bool has_sdf_program() { return true; }

fs::path sdf_program(const fs::path& file) {
  std::error_code error;
  const fs::path beside = fs::read_symlink("/proc/self/exe", error).parent_path() / "murosimf-sdf-frames";
  for (const fs::path& place : std::array{beside, fs::path(MUROSIMF_SDF_BUILT), fs::path(MUROSIMF_SDF_INSTALLED)}) {
    if (fs::is_regular_file(place, error)) return place;
  }
  throw SetupError(
      fmt::format("{}: SDF files need the program murosimf-sdf-frames, which is neither beside this program nor {}",
                  file.string(), MUROSIMF_SDF_INSTALLED));
}

}  // namespace murosimf::robot_formats::sdf
