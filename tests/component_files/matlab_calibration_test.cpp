#include "murosimf/component_files/matlab_calibration.h"

#include <gtest/gtest.h>

#include "tests/component_files/calibration_file.h"
#include "tests/law.h"

namespace murosimf::component_files {
namespace {

/// As the toolbox saves it, with invented numbers.
const CalibrationFile calib_results{"Calib_Results.m", R"(% Intrinsic and Extrinsic Camera Parameters
%
% fc = [ 1 ; 1 ];   in a comment

%-- Focal length:
fc = [ 657.500000000000000 ; 658.250000000000000 ];

%-- Principal point:
cc = [ 303.250000000000000 ; 242.500000000000000 ];

%-- Skew coefficient:
alpha_c = 0.004000000000000;

%-- Distortion coefficients:
kc = [ -0.256000000000000 ; 0.130000000000000 ; -0.000200000000000 ; 3.5e-05 ; +0.010000000000000 ];

%-- Focal length uncertainty:
fc_error = [ 0.3 ; 0.4 ];

%-- Image size:
nx = 640;
ny = 480;

%-- Various other variables (may be ignored if you do not use the Matlab Calibration Toolbox):
n_ima = 1;)"
                                                       "\t\t"
                                                       R"(% Number of calibration images
est_dist = [ 1 ; 1 ; 1 ; 1 ; 0 ];

omc_1 = [ NaN ; NaN ; NaN ];
)"};

/// The reader's error, without the name of the folder.
std::string message(const std::string& text) {
  return calib_results.message(text, [](const std::filesystem::path& file) { return read_calibration(file); });
}

TEST(MatlabCalibration, IsReadAsTheToolboxWritesIt) {
  const imaging::LensSpec lens = read_calibration(calib_results.write(calib_results.good)).lens;
  EXPECT_EQ(lens.model, "plumb_bob");
  EXPECT_EQ(lens.width, 640);
  EXPECT_EQ(lens.height, 480);
  EXPECT_EQ(lens.fx, 657.5);
  EXPECT_EQ(lens.fy, 658.25);
  EXPECT_EQ(lens.cx, 303.25);
  EXPECT_EQ(lens.cy, 242.5);
  EXPECT_EQ(lens.skew, 0.004 * 657.5);
  EXPECT_EQ(lens.coefficients, (std::vector<double>{-0.256, 0.13, -0.0002, 3.5e-05, 0.01}));
}

// The formulas of the toolbox's page, with its own letters.
TEST(MatlabCalibration, SeesPointsWhereTheToolboxHasThem) {
  const imaging::Lens lens(read_calib_results(calib_results.write(calib_results.good)).lens);
  law::Worst error;
  for (const Vec3d& point : {Vec3d{0.3, -0.2, 1}, {-0.4, 0.3, 1.2}, {0.1, 0.35, 0.9}}) {
    const double x = point.x / point.z, y = point.y / point.z, r2 = x * x + y * y;
    const double kc[] = {-0.256, 0.13, -0.0002, 3.5e-05, 0.01};
    const double radial = 1 + kc[0] * r2 + kc[1] * r2 * r2 + kc[4] * r2 * r2 * r2;
    const double xd = radial * x + 2 * kc[2] * x * y + kc[3] * (r2 + 2 * x * x);
    const double yd = radial * y + kc[2] * (r2 + 2 * y * y) + 2 * kc[3] * x * y;
    const double u = 657.5 * (xd + 0.004 * yd) + 303.25, v = 658.25 * yd + 242.5;
    const imaging::Pixel seen = lens.project(point).value();
    error.see(std::hypot(seen.u - u, seen.v - v), point.x);
  }
  law::expect_below({.law = "calibration of the toolbox for Matlab: where points are seen",
                     .level = "plumb_bob with skew",
                     .source = "x_p = fc(1) (x_d(1) + alpha_c x_d(2)) + cc(1) (Bouguet)"},
                    error, 1e-10, "px");
}

TEST(MatlabCalibration, MayLackSkewAndTheLastCoefficient) {
  std::string text = calib_results.with("alpha_c = 0.004000000000000;\n", "");
  text.replace(text.find(" ; +0.01"), 20, "");
  const imaging::LensSpec lens = read_calibration(calib_results.write(text)).lens;
  EXPECT_EQ(lens.skew, 0);
  EXPECT_EQ(lens.coefficients.size(), 4U);
  const auto spread =
      calib_results.with("fc = [ 657.500000000000000 ; 658.250000000000000 ];", "fc=[657.5 % x\n 658.25] % y");
  EXPECT_EQ(read_calibration(calib_results.write(spread)).lens.fy, 658.25) << "without semicolons, over two lines";
}

TEST(MatlabCalibration, SaysInWhichLineItIsWrong) {
  EXPECT_EQ(message(calib_results.with("nx = 640;\n", "")), "Calib_Results.m: 'nx' is missing");
  EXPECT_EQ(message(calib_results.with("nx = 640", "nx = wide")),
            "Calib_Results.m:21: 'nx' must be finite numbers, not 'wide'");
  EXPECT_EQ(message(calib_results.with("nx = 640", "nx = 640.5")),
            "Calib_Results.m:21: 'nx' is 640.5; it must be a whole number");
  EXPECT_EQ(message(calib_results.with("ny = 480", "ny = 0")),
            "Calib_Results.m:22: the picture's height is 0; it must be 1 to 8192 pixels");
  EXPECT_EQ(message(calib_results.with("658.250000000000000", "NaN")),
            "Calib_Results.m:6: 'fc' must be finite numbers, not 'NaN'");
  EXPECT_EQ(message(calib_results.with("657.5", "-657.5")),
            "Calib_Results.m:6: the focal length fx is -657.5; it must be above 0, in pixels");
  EXPECT_EQ(message(calib_results.with(" ; 242.500000000000000", "")),
            "Calib_Results.m:9: 'cc' has 1 numbers; it needs 2");
  EXPECT_EQ(message(calib_results.with("alpha_c = 0.004", "alpha_c = 1.004")).substr(0, 35),
            "Calib_Results.m:12: the skew is 660");
  EXPECT_EQ(message(calib_results.with(" ; 3.5e-05 ; +0.010000000000000", "")),
            "Calib_Results.m:15: 'kc' has 3 numbers; it needs 4 or 5");
  EXPECT_EQ(message(calib_results.with("3.5e-05", "3.5e-05x")),
            "Calib_Results.m:15: 'kc' must be finite numbers, not '3.5e-05x'");
  EXPECT_EQ(message(calib_results.with("+0.010000000000000 ]", "0")),
            "Calib_Results.m:15: the list has no end: ']' is missing");
  EXPECT_EQ(message(calib_results.good + "nx = 320;\n"), "Calib_Results.m:29: 'nx' is there twice, first in line 21");
  EXPECT_EQ(message(""), "Calib_Results.m: 'nx' is missing");
  EXPECT_THROW(static_cast<void>(read_calibration("/no/such/Calib_Results.m")), SetupError);
}

}  // namespace
}  // namespace murosimf::component_files
