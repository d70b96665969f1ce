// JPEG files that surfaces show: what is read, and what is refused.
#include <gtest/gtest.h>

#include "murosimf/dataset/jpeg_bytes.h"
#include "murosimf/render/picture_reading.h"
#include "tests/fixtures.h"

namespace murosimf::dataset {
namespace {

using fixtures::error_of;
using fixtures::says;

class JpegReading : public testing::Test {
 protected:
  void SetUp() override {
    try {
      check_jpeg_bytes();
    } catch (const SetupError& error) {
      GTEST_SKIP() << error.what();
    }
    imaging::ColorImage image(24, 16);
    for (int v = 0; v < 16; ++v) {
      for (int u = 0; u < 24; ++u) image(u, v) = {static_cast<std::uint8_t>(u < 8 ? 250 : 10), 100, 60};
    }
    bytes_ = jpeg_bytes(image, 95);
  }
  std::string bytes_;
};

TEST_F(JpegReading, HasRowsFromTheTopAndColors) {
  const imaging::ColorImage image = render::picture_of_file(bytes_);
  ASSERT_EQ(image.width(), 24);
  ASSERT_EQ(image.height(), 16);
  EXPECT_NEAR(image(2, 5).red, 250, 6);
  EXPECT_NEAR(image(20, 15).red, 10, 6);
  EXPECT_NEAR(image(20, 15).green, 100, 6);
}

// Broken ones are one line, whatever is cut off or turned over; none is read as if it were whole.
TEST_F(JpegReading, RefusesTruncatedOnes) {
  for (std::size_t size = 2; size + 2 <= bytes_.size(); size += 7) {
    const std::string what = error_of([&] { (void)render::picture_of_file(bytes_.substr(0, size)); });
    EXPECT_TRUE(says(what, {"the picture cannot be read: "})) << size << ' ' << what;
    EXPECT_EQ(what.find('\n'), std::string::npos);
  }
}

TEST_F(JpegReading, SurvivesBrokenOnes) {
  int refused = 0;
  for (std::size_t i = 2; i < bytes_.size(); ++i) {
    std::string broken = bytes_;
    broken[i] = static_cast<char>(broken[i] ^ 0x5a);
    try {
      (void)render::picture_of_file(broken);
    } catch (const SetupError& error) {
      ++refused;
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
  EXPECT_GT(refused, 100);
}

TEST_F(JpegReading, RefusesHugeOnesBeforeTheyAreRead) {
  std::string huge = bytes_;
  const std::size_t frame = huge.find("\xff\xc0");
  ASSERT_NE(frame, std::string::npos);
  huge.replace(frame + 5, 4, "\xff\x00\xff\x00", 4);
  EXPECT_TRUE(
      says(error_of([&] { (void)render::picture_of_file(huge); }), {"65280 x 65280 pixels", "make it smaller"}));
}

}  // namespace
}  // namespace murosimf::dataset
