// Replaces the reader and writer of calibrations where yaml-cpp is missing.
#include "murosimf/component_files/camera_info.h"
#include "murosimf/model/error.h"

namespace murosimf::component_files {
namespace {

[[noreturn]] void refuse() {
  throw SetupError(
      "camera calibrations are off in this build: yaml-cpp was missing (Debian and Ubuntu: libyaml-cpp-dev)");
}

}  // namespace

CameraCalibration read_camera_info(const std::filesystem::path& /*file*/) { refuse(); }

std::string camera_info_yaml(const CameraCalibration& /*info*/) { refuse(); }

}  // namespace murosimf::component_files
