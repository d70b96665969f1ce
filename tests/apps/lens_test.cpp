#include "tests/apps/program.h"

namespace murosimf::test {
namespace {

std::string calibration(const std::string& fx, const std::string& k1) {
  return "image_width: 640\nimage_height: 480\ncamera_matrix:\n  rows: 3\n  cols: 3\n  data: [" + fx +
         ", 0, 320, 0, 400, 240, 0, 0, 1]\ndistortion_model: plumb_bob\n"
         "distortion_coefficients:\n  rows: 1\n  cols: 4\n  data: [" +
         k1 + ", 0, 0, 0]\n";
}

class CliLens : public testing::Test {
 protected:
  void SetUp() override {
    if (murosimf("lens wolfgang_rory").errors.find("yaml-cpp was missing") != std::string::npos) {
      GTEST_SKIP() << "no yaml-cpp in this build";
    }
  }
};

TEST_F(CliLens, ShowsACalibration) {
  const Result result = murosimf("lens nubots_frankie");
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  for (const char* text :
       {"model          equidistant\n", "picture        1280 x 1024 px\n", "focal length   435.20 x 435.20 px\n",
        "in the picture 132.", "field of view  horizontal 18"}) {
    EXPECT_NE(result.output.find(text), std::string::npos) << text << " is not in\n" << result.output;
  }
  EXPECT_EQ(result.output.find("warning"), std::string::npos);
  EXPECT_NE(murosimf("list lenses").output.find("wolfgang_rory\n"), std::string::npos);
}

TEST_F(CliLens, WarnsOfAFold) {
  const Result result = murosimf("lens " + write("fold.yaml", calibration("400", "-0.5")).string());
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_NE(result.output.find("warning        the distortion folds over at 39.2 deg, inside the picture"),
            std::string::npos)
      << result.output;
}

TEST_F(CliLens, ConvertsAndNamesTheError) {
  const fs::path out = scratch("out.yaml");
  const Result result = murosimf("lens wolfgang_rory --as ray_polynomial --out " + out.string());
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_NE(result.output.find("as ray_polynomial\n"), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("fit error      0."), std::string::npos) << result.output;
  EXPECT_NE(murosimf("lens " + out.string()).output.find("model          ray_polynomial\n"), std::string::npos);
}

TEST_F(CliLens, RefusesMistakes) {
  expect_mistake("lens", {"file"});
  expect_mistake("lens no_such_lens", {"no file 'no_such_lens'", "lenses"});
  expect_mistake("lens " + write("zero.yaml", calibration("0", "0")).string(), {"zero.yaml:4", "focal length fx is 0"});
  expect_mistake("lens wolfgang_rory --as plumbob", {"wolfgang_rory.yaml", "did you mean 'plumb_bob'?"});
  expect_mistake("lens nubots_frankie --as plumb_bob", {"nubots_frankie.yaml", "cannot show rays 13"});
  expect_mistake("lens wolfgang_rory --out /nowhere/a.yaml", {"/nowhere/a.yaml"});
}

}  // namespace
}  // namespace murosimf::test
