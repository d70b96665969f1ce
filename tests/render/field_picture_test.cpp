// Needs MUROSIMF_HAS_CAIRO and cairo; without them there are no pictures.
#include "murosimf/render/field_picture.h"

#include <gtest/gtest.h>

#ifndef MUROSIMF_HAS_CAIRO

TEST(FieldPicture, IsWritten) { GTEST_SKIP() << "this build has no cairo"; }

#else

#include <cstdint>
#include <fstream>
#include <limits>

#include <unistd.h>

#include "murosimf/files/output_file.h"
#include "murosimf/model/error.h"
#include "murosimf/scene_file/field.h"
#include "tests/render/picture.h"
#include "tests/temp_folder.h"

namespace murosimf::render {
namespace {

namespace fs = std::filesystem;

constexpr Color red{0.85, 0.15, 0.15}, blue{0.15, 0.4, 0.85}, orange{1, 0.5, 0};

class FieldPicture : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fixtures::temp_folder() / ("field_picture_test." + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] fs::path file(const std::string& name = "match.png") const { return folder_ / name; }
  [[nodiscard]] Picture draw(const std::vector<Path>& paths, const std::string& title = {}) const {
    files::write_file(file(), field_picture_png(markings_, paths, {100, title}));
    return {file(), 100};
  }
  [[nodiscard]] std::string refusal(const FieldPictureOptions& options) const {
    try {
      (void)field_picture_png(markings_, {}, options);
    } catch (const SetupError& error) {
      return error.what();
    }
    return "";
  }
  fs::path folder_;
  Markings markings_ = scene_file::field_markings(scene_file::kid_size_2008);
};

/// Big-endian number of an IHDR chunk, which begins at byte 16 of every PNG.
std::uint32_t header_number(const fs::path& file, std::streamoff offset) {
  std::ifstream in(file, std::ios::binary);
  in.seekg(offset);
  unsigned char bytes[4] = {};
  in.read(reinterpret_cast<char*>(bytes), 4);
  return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 | std::uint32_t{bytes[2]} << 8 | bytes[3];
}

TEST_F(FieldPicture, HasTheSizeOfTheGround) {
  files::write_file(file(), field_picture_png(markings_, {}, {160, ""}));
  EXPECT_EQ(header_number(file(), 0), 0x89504e47u);  // the signature of PNG
  EXPECT_EQ(header_number(file(), 16), 1184u);       // 6 m and two border strips of 0.7 m
  EXPECT_EQ(header_number(file(), 20), 864u);        // 4 m and two of them
}

TEST_F(FieldPicture, ShowsLinesToScaleOnGreen) {
  const Picture picture = draw({});
  EXPECT_TRUE(is_white(picture.at(0, 1.2)));       // half line
  EXPECT_TRUE(is_white(picture.at(0.6, 0)));       // center circle
  EXPECT_TRUE(is_white(picture.at(-2.975, 1.6)));  // goal line
  EXPECT_TRUE(is_green(picture.at(-2.93, 1.6)));   // beside it
  EXPECT_TRUE(is_white(picture.at(1.2, -1.975)));  // touch line
  EXPECT_TRUE(is_white(picture.at(2.425, 0.5)));   // goal area
  EXPECT_TRUE(is_white(picture.at(-1.2, 0.05)));   // penalty mark
  EXPECT_TRUE(is_green(picture.at(1.0, 1.0)));
  const Color frame = picture.at(3.2, 0.8);  // of the goal: yellow
  EXPECT_TRUE(frame.red > 200 && frame.green > 150 && frame.blue < 60);
  EXPECT_TRUE(is_green(picture.at(-3.5, -1.8)));  // border strip
}

TEST_F(FieldPicture, ShowsRobotsPathsAndBall) {
  const Path robot{"red_1", red, {{-2, 1, 0}, {-1, 1, 0}}, 0.2, pi / 2, false, 7};
  const Path other{"blue_1", blue, {{1, -1, 0}}, 0.2, 0, false, 3};
  const Path ball{"ball", orange, {{0.5, 1.5, 0}, {1.5, 1.5, 0}}, 0.06, 0, true, -1};
  const Picture picture = draw({robot, other, ball});
  // a robot that looks along y has its shoulders along x and its arrow above
  EXPECT_TRUE(is_reddish(picture.at(-1.15, 1)));
  EXPECT_TRUE(is_reddish(picture.at(-0.85, 1)));
  EXPECT_TRUE(is_white(picture.at(-1, 1.21)));
  EXPECT_TRUE(is_bluish(picture.at(1, -0.85)));
  EXPECT_TRUE(is_white(picture.at(1.21, -1)));
  EXPECT_TRUE(is_reddish(picture.at(-1.3, 1))) << "the path's end is not drawn in the team's color";
  EXPECT_TRUE(is_white(picture.at(-2, 1))) << "the start ring is not white inside";
  const Color at_ball = picture.at(1.5, 1.48);
  EXPECT_NEAR(at_ball.red, 255, 2);
  EXPECT_NEAR(at_ball.green, 128, 2);
  EXPECT_NEAR(at_ball.blue, 0, 2);
}

TEST_F(FieldPicture, ShowsWhatIsLaidOverIt) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  FieldPictureOptions options{.pixels_per_meter = 100, .title = {}};
  options.overlay.circles = {{{1, 1, 0}, 0.3, red}, {{-1, 1, 0}, 0.3, blue, true}, {{nan, 0, 0}, 0.3, red}};
  options.overlay.lines = {{{{-2, -1.5, 0}, {-1, -1.5, 0}}, red, true, 0.05}, {{{1, 1, 0}}, red}};
  options.overlay.arrows = {{{1.5, -1, pi / 2}, 0.4, blue}, {{1, 1, nan}, 0.4, red}};
  files::write_file(file(), field_picture_png(markings_, {}, options));
  const Picture picture(file(), 100);
  EXPECT_TRUE(is_reddish(picture.at(1.3, 1)));  // a ring is empty inside
  EXPECT_TRUE(is_green(picture.at(1.1, 1)));
  EXPECT_TRUE(is_bluish(picture.at(-1, 1.1)));
  EXPECT_TRUE(is_reddish(picture.at(-1.6, -1.5)));
  EXPECT_TRUE(is_reddish(picture.at(-0.95, -1.5)));  // its head goes on where it ends
  EXPECT_TRUE(is_bluish(picture.at(1.5, -0.8)));     // along y
  EXPECT_TRUE(is_bluish(picture.at(1.5, -0.65)));
  EXPECT_TRUE(is_green(picture.at(1.8, -1)));
}

TEST_F(FieldPicture, KeepsTheWritingOffTheField) {
  // the robot itself stands far outside
  const std::vector<Path> teams{{"red_1", red, {{50, 50, 0}}},
                                {"a_team_with_a_very_long_name_that_must_shrink_1", blue, {}}};
  const std::string title(200, 'M');
  const Picture with = draw(teams, title);
  const Picture bare = draw({});
  int different_on_field = 0, different_in_strip = 0;
  for (int row = 0; row < with.rows(); ++row) {
    for (int column = 0; column < with.columns(); ++column) {
      const Color a = with.pixel(column, row), b = bare.pixel(column, row);
      if (a.red == b.red && a.green == b.green && a.blue == b.blue) continue;
      const bool on_field = row >= 70 && row < 470;
      const bool beside = column < 68 || column > 672;
      ++(on_field || beside ? different_on_field : different_in_strip);
    }
  }
  EXPECT_EQ(different_on_field, 0);
  EXPECT_GT(different_in_strip, 500);
}

TEST_F(FieldPicture, LeavesGapsWhereNumbersWentBad) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Picture picture = draw({{"red_1", red, {{-2, 1, 0}, {-1.5, 1, 0}, {nan, nan, 0}, {-0.5, 1, 0}, {-0.2, 1, 0}}},
                                {"red_2", red, {{0, 0, 0}, {1e300, -1e300, 0}, {nan, 0, 0}}, nan, nan},
                                {"red_3", red, {}}});
  EXPECT_TRUE(is_green(picture.at(-1, 1)));
  EXPECT_TRUE(is_reddish(picture.at(-1.6, 1)));
}

TEST_F(FieldPicture, RefusesImpossibleSizesAndText) {
  EXPECT_NE(refusal({0, ""}).find("pixels_per_meter is too small"), std::string::npos);
  EXPECT_NE(refusal({100000, ""}).find("pixels_per_meter is too large"), std::string::npos);
  EXPECT_NE(refusal({100, "\xff\xfe"}).find("UTF-8"), std::string::npos);
  markings_.half_width = 0;
  EXPECT_NE(refusal({}).find("half_width"), std::string::npos);
}

}  // namespace
}  // namespace murosimf::render

#endif
