#include "murosimf/dataset/randomisation.h"

#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "tests/temp_folder.h"

namespace murosimf::dataset {
namespace {

class RandomisationFile : public testing::Test {
 protected:
  Randomisation read(const std::string& text) const {
    std::ofstream(file()) << text;
    return read_randomisation(file());
  }
  std::string error_of(const std::string& text) const {
    try {
      (void)read(text);
    } catch (const SetupError& error) {
      return error.what();
    }
    return "";
  }
  [[nodiscard]] std::filesystem::path file() const { return folder_.path() / "ranges.toml"; }

  fixtures::TempFolder folder_;
};

TEST_F(RandomisationFile, TheOneThatComesWithTheProgramIsRead) {
  const Randomisation soccer = read_randomisation("soccer");
  EXPECT_EQ(soccer.picture.format, "jpeg");
  EXPECT_LT(soccer.light.brightness.low, soccer.light.brightness.high);
  EXPECT_EQ(soccer.ball.colors.size(), 4U);
}

TEST_F(RandomisationFile, WhatIsNotNamedDoesNotVary) {
  const Randomisation plain = read("");
  EXPECT_EQ(plain.light.brightness.low, plain.light.brightness.high);
  EXPECT_EQ(plain.sensor.blur.high, 0);
  EXPECT_EQ(plain.lens.fov_deg.low, plain.lens.fov_deg.high);
}

TEST_F(RandomisationFile, ANumberAloneIsAFixedOne) {
  const Randomisation fixed = read("[sensor]\nblur = 1.5\n[light]\npresets = ['day']\n");
  EXPECT_EQ(fixed.sensor.blur.low, 1.5);
  EXPECT_EQ(fixed.sensor.blur.high, 1.5);
  EXPECT_EQ(fixed.light.presets, std::vector<std::string>{"day"});
}

TEST_F(RandomisationFile, ErrorsAreOneLineWithPlace) {
  EXPECT_NE(error_of("[light]\nbrightnes = 1\n").find("ranges.toml:2:"), std::string::npos);
  EXPECT_NE(error_of("[light]\nbrightnes = 1\n").find("did you mean 'brightness'"), std::string::npos);
  EXPECT_NE(error_of("[lamps]\n").find("'lamps'"), std::string::npos);
  EXPECT_NE(error_of("[sensor]\nblur = [2, 1]\n").find("must begin with the lower number"), std::string::npos);
  EXPECT_NE(error_of("[sensor]\nblur = [1, 50]\n").find("is 50: must be 0 to 20"), std::string::npos);
  EXPECT_NE(error_of("[sensor]\nblur = 'much'\n").find("must be [lowest, highest]"), std::string::npos);
  EXPECT_NE(error_of("[picture]\nformat = 'jpg'\n").find("did you mean 'jpeg'"), std::string::npos);
  EXPECT_NE(error_of("[picture]\nsamples = 3\n").find("1, 2, 4 or 8"), std::string::npos);
  EXPECT_NE(error_of("[light]\npresets = ['dai']\n").find("did you mean 'day'"), std::string::npos);
  EXPECT_NE(error_of("[lens]\nperspective = 0\n").find("all weights are 0"), std::string::npos);
  EXPECT_NE(error_of("[ball]\ncolors = [[1, 0]]\n").find("list of colors"), std::string::npos);
}

}  // namespace
}  // namespace murosimf::dataset
