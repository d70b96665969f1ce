/// video_file_test - the input of the other program, and the removal of unfinished videos.
#include "murosimf/appearance/video_file.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::appearance {
namespace {

namespace fs = std::filesystem;
using fixtures::error_of;
using fixtures::says;

class VideoFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fixtures::temp_folder() /
              (std::string("video_file_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  [[nodiscard]] std::string at(const char* name) const { return (folder_ / name).string(); }
  static std::string text_of(const fs::path& file) {
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }
  [[nodiscard]] int files() const {
    return static_cast<int>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  fs::path folder_;
};

using ChildPipes = VideoFiles;

std::span<const std::byte> bytes(const std::string& text) { return std::as_bytes(std::span(text)); }

TEST_F(ChildPipes, CarryAllBytesInOrder) {
  std::string text;
  for (int i = 0; i < 300000; ++i) text += std::to_string(i);
  files::ChildPipe pipe({"sh", "-c", "cat > '" + at("out") + "'"}, "");
  pipe.write(bytes(text.substr(0, 7)));
  pipe.write({});
  pipe.write(bytes(text.substr(7)));
  pipe.finish();
  EXPECT_TRUE(text_of(at("out")) == text);
}

TEST_F(ChildPipes, HandArgumentsOverAsTheyAre) {
  files::ChildPipe pipe({"sh", "-c", "printf %s \"$1\" > \"$2\"", "sh", "two words; $HOME 'x'", at("out")}, "");
  pipe.finish();
  EXPECT_EQ(text_of(at("out")), "two words; $HOME 'x'");
}

TEST_F(ChildPipes, EndProgramsThatNobodyWaitsFor) {
  {
    files::ChildPipe pipe({"sh", "-c", "cat > '" + at("out") + "'; echo whole > '" + at("end") + "'"}, "");
    pipe.write(bytes("half"));
  }
  EXPECT_FALSE(fs::exists(at("end")));
}

TEST_F(ChildPipes, SayWhatTheProgramSaidLast) {
  const auto error = [](const std::string& script) {
    return error_of([&] { files::ChildPipe({"sh", "-c", script}, "").finish(); });
  };
  EXPECT_TRUE(says(error("echo first >&2; echo 'no room' >&2; exit 3"), {"'sh' gave up: no room"}));
  EXPECT_TRUE(says(error("printf 'frame 1\\rframe 2\\rtoo big' >&2; exit 1"), {"gave up: too big"}));
  EXPECT_TRUE(says(error("exit 1"), {"gave up without a word"}));
  EXPECT_TRUE(says(error("kill -9 $$"), {"gave up without a word"}));
  EXPECT_TRUE(says(error_of([] { const files::ChildPipe pipe({"no_such_program"}, "install it"); }),
                   {"cannot run 'no_such_program': install it"}));
}

TEST_F(VideoFiles, ThatNobodyFinishesLeaveNothingAndKeepWhatWasThere) {
  if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no ffmpeg here";
  std::ofstream(at("a.mp4")) << "old";
  {
    VideoFile video(at("a.mp4"), VideoFile::Pixels::colors, 16, 16, 10);
    for (int i = 0; i < 3; ++i) video.add(imaging::ColorImage(16, 16));
  }
  EXPECT_EQ(text_of(at("a.mp4")), "old");
  EXPECT_EQ(files(), 1);
  VideoFile video(at("a.mp4"), VideoFile::Pixels::colors, 16, 16, 10);
  video.add(imaging::ColorImage(16, 16));
  EXPECT_EQ(text_of(at("a.mp4")), "old") << "until it is whole";
  video.finish();
  EXPECT_EQ(text_of(at("a.mp4")).substr(4, 4), "ftyp");
  EXPECT_EQ(files(), 1);
}

// The pictures that a program reads are those that were added.
TEST_F(VideoFiles, OfNumbersLoseNothing) {
  if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no ffmpeg here";
  std::string added;
  {
    VideoFile video(at("depth.mkv"), VideoFile::Pixels::numbers, 33, 7, 10);
    for (int i = 0; i < 3; ++i) {
      imaging::NumberImage picture(33, 7);
      std::uint32_t noise = 7;
      for (std::uint16_t& number : picture.pixels()) {
        noise = 1664525 * noise + 1013904223;
        number = static_cast<std::uint16_t>((noise >> 16) + static_cast<std::uint32_t>(i));
        added += static_cast<char>(number & 255);
        added += static_cast<char>(number >> 8);
      }
      video.add(picture);
    }
    video.finish();
  }
  const std::string read =
      "ffmpeg -loglevel error -i '" + at("depth.mkv") + "' -f rawvideo -pix_fmt gray16le '" + at("raw") + "'";
  ASSERT_EQ(std::system(read.c_str()), 0);
  EXPECT_TRUE(text_of(at("raw")) == added);
  EXPECT_TRUE(says(error_of([&] { check_number_video(at("depth.mp4")); }), {"depth.mp4", ".mkv"}));
}

TEST_F(VideoFiles, OfNoKnownKindAreRefused) {
  for (const char* name : {"film", "film.", ".mp4", "film.mp3", "film.MP4"}) {
    EXPECT_TRUE(says(error_of([&] { check_video(at(name)); }), {name, "extension", ".mp4, .webm, .gif"})) << name;
  }
  EXPECT_TRUE(says(error_of([&] { const VideoFile v(at("no/such/a.mp4"), VideoFile::Pixels::colors, 8, 8, 10); }),
                   {"there is no folder"}));
  EXPECT_EQ(files(), 0);
}

}  // namespace
}  // namespace murosimf::appearance
