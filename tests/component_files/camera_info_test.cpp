#include "murosimf/component_files/camera_info.h"

#include <gtest/gtest.h>

#include "tests/component_files/calibration_file.h"

namespace murosimf::component_files {
namespace {

const CalibrationFile info_file{"camera_info.yaml", R"(image_width: 640
image_height: 480
camera_name: left
camera_matrix:
  rows: 3
  cols: 3
  data: [417.5, 0, 317.25, 0, 416, 227, 0, 0, 1]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [-0.286, 0.0815, -0.0001, -0.0003, 0]
rectification_matrix:
  rows: 3
  cols: 3
  data: [1., 0., 0., 0., 1., 0., 0., 0., 1.]
projection_matrix:
  rows: 3
  cols: 4
  data: [400, 0, 310, 0, 0, 400, 220, 0, 0, 0, 1, 0]
)"};

/// The reader's error, without the name of the folder.
std::string message(const std::string& text) {
  return info_file.message(text, [](const std::filesystem::path& file) { return read_camera_info(file); });
}

class CameraInfoFile : public testing::Test {
 protected:
  void SetUp() override {
    if (message(info_file.good).find("yaml-cpp was missing") != std::string::npos)
      GTEST_SKIP() << "this build has no yaml-cpp";
  }
};

TEST_F(CameraInfoFile, IsReadAsRosWritesIt) {
  const auto [name, lens] = read_camera_info(info_file.write(info_file.good));
  EXPECT_EQ(name, "left");
  EXPECT_EQ(lens.model, "plumb_bob");
  EXPECT_EQ(lens.width, 640);
  EXPECT_EQ(lens.height, 480);
  EXPECT_EQ(lens.fx, 417.5);
  EXPECT_EQ(lens.fy, 416);
  EXPECT_EQ(lens.cx, 317.25);
  EXPECT_EQ(lens.cy, 227);
  EXPECT_EQ(lens.coefficients, (std::vector<double>{-0.286, 0.0815, -0.0001, -0.0003, 0}));
}

TEST_F(CameraInfoFile, ComesBackAsItWasWritten) {
  const std::vector<imaging::LensSpec> lenses{
      {"plumb_bob", 640, 480, 417.123456789012, 416, 317.1, 227, {-0.286, 0.0815, -0.0001, -0.0003, 1e-17}},
      {"rational_polynomial", 640, 480, 417, 416, 317, 227, {0.9, 0.15, -0.0004, 0.0008, 0.004, 1.2, 0.3, 0.02}},
      {"equidistant", 1280, 1024, 435.2, 435.2, 613, 513, {-0.0445, 0.00385, -0.0003, 1.0 / 3}},
      {"ray_polynomial", 640, 480, 417, 416, 317, 227, {1, 0, 0.08, 0, -0.02, 0.001}}};
  for (const imaging::LensSpec& lens : lenses) {
    const auto [name, again] = read_camera_info(info_file.write(camera_info_yaml({"blue 1: left", lens})));
    EXPECT_EQ(name, "blue 1: left");
    EXPECT_EQ(again.model, lens.model);
    EXPECT_EQ(again.width, lens.width);
    EXPECT_EQ(again.fx, lens.fx);
    EXPECT_EQ(again.cy, lens.cy);
    EXPECT_EQ(again.coefficients, lens.coefficients);
  }
}

TEST_F(CameraInfoFile, KeepsSkew) {
  const imaging::LensSpec lens = read_camera_info(info_file.write(info_file.with("[417.5, 0,", "[417.5, -2.25,"))).lens;
  EXPECT_EQ(lens.skew, -2.25);
  EXPECT_EQ(read_calibration(info_file.write(camera_info_yaml({"", lens}))).lens.skew, -2.25);
}

TEST_F(CameraInfoFile, IsWrittenAsOthersExpectIt) {
  const imaging::LensSpec plain{.width = 640, .height = 480, .fx = 400, .fy = 400, .cx = 320, .cy = 240};
  EXPECT_EQ(read_camera_info(info_file.write(camera_info_yaml({"", plain}))).lens.coefficients, std::vector<double>(5));
  const imaging::LensSpec fisheye{"equidistant", 640, 480, 400, 400, 320, 240, {0.1}};
  EXPECT_EQ(read_camera_info(info_file.write(camera_info_yaml({"", fisheye}))).lens.coefficients,
            (std::vector<double>{0.1, 0, 0, 0}));
}

TEST_F(CameraInfoFile, SaysInWhichLineItIsWrong) {
  const auto expect = [](const std::string& text, const std::string& said) { EXPECT_EQ(message(text), said); };
  expect(info_file.with("image_width: 640\n", ""), "camera_info.yaml:1: 'image_width' is missing");
  expect(info_file.with("image_width: 640", "image_width: wide"),
         "camera_info.yaml:1: 'image_width' must be a whole number");
  expect(info_file.with("image_width: 640", "image_width: 0"),
         "camera_info.yaml:1: the picture's width is 0; it must be 1 to 8192 pixels");
  expect(info_file.with("image_height: 480", "image_height: 100000"),
         "camera_info.yaml:2: the picture's height is 100000; it must be 1 to 8192 pixels");
  expect(info_file.with("417.5", "0"), "camera_info.yaml:5: the focal length fx is 0; it must be above 0, in pixels");
  expect(info_file.with("417.5", ".nan"), "camera_info.yaml:7: data of 'camera_matrix' must be finite numbers");
  expect(info_file.with("317.25, 0, 416", "317.25, 2, 416"),
         "camera_info.yaml:5: 'camera_matrix' must be [fx, skew, cx, 0, fy, cy, 0, 0, 1]");
  expect(info_file.with("[417.5, 0,", "[417.5, 500,"),
         "camera_info.yaml:5: the skew is 500; its size must be below the focal length fx, 417.5, in pixels");
  expect(info_file.with("227, 0, 0, 1]", "227, 0, 0]"),
         "camera_info.yaml:7: 'camera_matrix' has 8 numbers in data, but 3 rows and 3 cols");
  expect(info_file.with("plumb_bob", "plumbob"),
         "camera_info.yaml:8: unknown lens model 'plumbob'; did you mean 'plumb_bob'?");
  expect(info_file.with("plumb_bob", "rational_polynomial"),
         "camera_info.yaml:10: 'rational_polynomial' has 5 coefficients; it needs 8: k1 k2 p1 p2 k3 k4 k5 k6");
  expect(info_file.with("  data: [-0.286, 0.0815, -0.0001, -0.0003, 0]\n", ""),
         "camera_info.yaml:10: 'data' is missing");
  expect(info_file.with("-0.0003, 0]", "-0.0003, x]"),
         "camera_info.yaml:12: data of 'distortion_coefficients' must be finite numbers");
  expect(info_file.with("0, 0, 0, 1, 0]", "0, 0, 0, 1, inf]"),
         "camera_info.yaml:20: data of 'projection_matrix' must be finite numbers");
  expect("", "camera_info.yaml:1: this is no camera calibration: there are no fields");
  expect("just a text", "camera_info.yaml:1: this is no camera calibration: there are no fields");
  EXPECT_EQ(message("a: [1, 2\nb: {").find("camera_info.yaml:"), 0U) << message("a: [1, 2\nb: {");
  EXPECT_THROW(static_cast<void>(read_camera_info("/no/such/file.yaml")), SetupError);
}

TEST_F(CameraInfoFile, OfEveryLensThatComesAlongIsALens) {
  ASSERT_GE(lens_names().size(), 4U);
  for (const std::string& name : lens_names()) {
    const auto info = read_camera_info(find_lens_file(name));
    EXPECT_EQ(info.name, name);
    EXPECT_NO_THROW(imaging::Lens{info.lens}) << name;
  }
}

}  // namespace
}  // namespace murosimf::component_files
