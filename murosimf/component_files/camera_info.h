/// camera_info.h - calibrations of cameras in the YAML form of ROS (camera_calibration_parsers).
///
///     image_width: 640
///     image_height: 480
///     camera_name: left
///     camera_matrix: {rows: 3, cols: 3, data: [fx, skew, cx, 0, fy, cy, 0, 0, 1]}
///     distortion_model: plumb_bob                 # or another one of imaging/lens.h
///     distortion_coefficients: {rows: 1, cols: 5, data: [k1, k2, p1, p2, k3]}
///     rectification_matrix: {rows: 3, cols: 3, data: [1, 0, 0, 0, 1, 0, 0, 0, 1]}
///     projection_matrix: {rows: 3, cols: 4, data: [fx, skew, cx, 0, 0, fy, cy, 0, 0, 0, 1, 0]}
///
/// The last two are of rectified pictures, which a camera does not make: they are checked and otherwise ignored. They and
/// the name may be missing.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/files/data_path.h"
#include "murosimf/imaging/lens.h"

namespace murosimf::component_files {

struct CameraCalibration {
  std::string name;
  imaging::LensSpec lens;
};

/// Throws SetupError with file:line: fields that are missing, of another type, not finite or of the wrong count; a
/// camera matrix with other numbers than these; everything that imaging::Lens refuses.
[[nodiscard]] CameraCalibration read_camera_info(const std::filesystem::path& file);

/// The same form. A perspective lens becomes a plumb_bob with coefficients 0, which other readers support; coefficients
/// that may be missing are written as 0, as those expect.
[[nodiscard]] std::string camera_info_yaml(const CameraCalibration& info);

/// Of a file in either form: of the toolbox for Matlab (matlab_calibration.h) if its name ends in .m. Throws SetupError.
[[nodiscard]] CameraCalibration read_calibration(const std::filesystem::path& file);

/// The file of a name: itself, beside `beside`, or one of lenses/ (files/data_path.h).
[[nodiscard]] inline std::filesystem::path find_lens_file(std::string_view name,
                                                          const std::filesystem::path& beside = {}) {
  return files::find_data_file(name, "lenses", ".yaml", beside);
}

/// The names of the files in lenses/.
[[nodiscard]] inline std::vector<std::string> lens_names() { return files::data_file_names("lenses", ".yaml"); }

}  // namespace murosimf::component_files
