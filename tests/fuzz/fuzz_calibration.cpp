// Calibrations of cameras, YAML.
#include "murosimf/components/camera_info.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  fuzz::feed(data, size, ".yaml", [](const auto& file) {
    const components::CameraCalibration info = components::read_camera_info(file);
    (void)imaging::Lens(info.lens).fold_remark();
    (void)components::camera_info_yaml(info);
  });
  return 0;
}
