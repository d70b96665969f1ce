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

struct Refused {
  std::string text;
  int line;
  std::string words;
};

TEST_F(RandomisationFile, ErrorsAreOneLineWithPlace) {
  const Refused all[]{
      {"[light]\nbrightnes = 1\n", 2, "did you mean 'brightness'"},
      {"\n[lamps]\n", 2, "'lamps'"},
      {"[sensor]\nblur = [2, 1]\n", 2, "must begin with the lower number"},
      {"[sensor]\nblur = [1, 50]\n", 2, "is 50: must be 0 to 20"},
      {"[sensor]\nblur = 'much'\n", 2, "must be [lowest, highest]"},
      {"[picture]\n\nformat = 'jpg'\n", 3, "did you mean 'jpeg'"},
      {"[picture]\nsamples = 3\n", 2, "1, 2, 4 or 8"},
      {"[light]\npresets = ['day',\n'dai']\n", 3, "did you mean 'day'"},
      {"[lens]\ncount = 2\nperspective = 0\n", 3, "all weights are 0"},
      {"[robots]\nstanding = 0\nmoving = 0\ndown = 0\n", 2, "standing, moving, down: all weights are 0"},
      {"[lens]\nfov_deg = [60, 160]\n", 2, "above 150"},
      {"[ball]\ncolors = [[1, 0]]\n", 2, "list of colors"},
  };
  for (const Refused& one : all) {
    const std::string error = error_of(one.text);
    EXPECT_NE(error.find("ranges.toml:" + std::to_string(one.line) + ":"), std::string::npos) << error;
    EXPECT_NE(error.find(one.words), std::string::npos) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
}

TEST_F(RandomisationFile, CountsAreWholeNumbers) {
  for (const char* text : {"[people]\ncount = 2.5\n", "[people]\nthings = 0.5\n", "[lens]\ncount = 1.5\n",
                           "[picture]\nsamples = 2.5\n", "[picture]\nleast_pixels = 12.5\n"}) {
    const std::string error = error_of(text);
    EXPECT_NE(error.find("ranges.toml:2:"), std::string::npos) << error;
    EXPECT_NE(error.find("must be a whole number"), std::string::npos) << error;
  }
  EXPECT_EQ(read("[people]\ncount = 3.0\n").people.count, 3);
}

}  // namespace
}  // namespace murosimf::dataset
