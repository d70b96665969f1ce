/// matlab_calibration.h - calibrations of the Camera Calibration Toolbox for Matlab (Bouguet), which the paper's authors used
/// (6.2): the file Calib_Results.m that it saves.
///
///     fc = [ 657.64 ; 658.04 ];                   % focal lengths [px]
///     cc = [ 303.19 ; 242.56 ];                   % center [px]; the middle of the first pixel is 0, 0
///     alpha_c = 0.0004;                           % skew coefficient: the skew is alpha_c fc(1); may be missing
///     kc = [ -0.256 ; 0.130 ; -0.0002 ; 0.00003 ; 0 ];   % radial r^2, r^4, tangential, tangential, radial r^6
///     nx = 640;                                   % size of the picture [px]
///     ny = 480;
///
/// With x, y = X/Z, Y/Z the toolbox sees a point at KK [x_d; y_d; 1], KK = [fc(1) alpha_c fc(1) cc(1); 0 fc(2) cc(2); 0 0 1],
/// where x_d, y_d are those of plumb_bob with k1 k2 p1 p2 k3 = kc. Everything else in the file (uncertainties, places of the
/// calibration pattern) is not read. The file is not executed: values are numbers and lists of numbers.
/// Source: Bouguet, Camera Calibration Toolbox for Matlab, "Description of the calibration parameters".
#pragma once

#include <filesystem>

#include "murosimf/component_files/camera_info.h"

namespace murosimf::component_files {

/// Throws SetupError with file:line: names that are missing or stand there twice, values that are no numbers, not finite or of
/// the wrong count; everything that imaging::Lens refuses. The calibration has no name.
[[nodiscard]] CameraCalibration read_calib_results(const std::filesystem::path& file);

}  // namespace murosimf::component_files
