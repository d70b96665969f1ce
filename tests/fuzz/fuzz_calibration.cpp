// Calibrations of cameras: YAML, and those of the toolbox for Matlab.
#include "murosimf/component_files/camera_info.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  const auto read = [](const auto& file) {
    const component_files::CameraCalibration info = component_files::read_calibration(file);
    (void)imaging::Lens(info.lens).fold_warning();
    (void)component_files::camera_info_yaml(info);
  };
  const bool matlab = size > 0 && data[0] == '%';
  fuzz::feed(data, size, matlab ? ".m" : ".yaml", read);
  return 0;
}
