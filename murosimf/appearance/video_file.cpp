#include "murosimf/appearance/video_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::appearance {
namespace {

constexpr std::array kinds{".mp4", ".webm", ".gif", ".mkv", ".mov", ".avi"};
constexpr const char* no_ffmpeg =
    "it is not installed (Debian and Ubuntu: ffmpeg); pictures need --out FILE.png instead of --video";

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& reason) {
  throw SetupError(fmt::format("cannot write '{}': {}", file.string(), reason));
}

const std::filesystem::path& checked(const std::filesystem::path& file) {
  if (std::ranges::find(kinds, file.extension().string()) == kinds.end()) {
    throw SetupError(fmt::format("'{}': its extension must say which kind of video it is: {}", file.string(),
                                 fmt::join(kinds, ", ")));
  }
  return file;
}

const std::filesystem::path& checked_for_numbers(const std::filesystem::path& file) {
  if (checked(file).extension() == ".mkv") return file;
  throw SetupError(fmt::format("'{}': a video keeps numbers, as depths and labels are, only as .mkv", file.string()));
}

const std::filesystem::path& checked(const std::filesystem::path& file, VideoFile::Pixels pixels) {
  return pixels == VideoFile::Pixels::numbers ? checked_for_numbers(file) : checked(file);
}

/// The number behind the last "frame=" of ffmpeg's progress.
std::int64_t last_frame(const std::string& progress) {
  constexpr std::string_view word = "frame=";
  const auto place = progress.rfind(word);
  if (place == std::string::npos) return 0;
  std::int64_t count = 0;
  std::from_chars(progress.data() + place + word.size(), progress.data() + progress.size(), count);
  return count;
}

/// Output options: most players need even sizes and 4:2:0; a GIF has a palette for each picture and
/// no dither, which would double its size; numbers are stored without loss.
std::vector<std::string> form_of(const std::filesystem::path& file, VideoFile::Pixels pixels) {
  if (pixels == VideoFile::Pixels::numbers) return {"-c:v", "ffv1", "-level", "3", "-pix_fmt", "gray16le"};
  if (file.extension() == ".gif") {
    return {"-vf", "split[a][b];[a]palettegen=stats_mode=single:max_colors=128[p];[b][p]paletteuse=new=1:dither=none"};
  }
  return {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p"};
}

std::vector<std::string> command(const std::filesystem::path& file, VideoFile::Pixels pixels, int width, int height,
                                 double rate) {
  std::vector<std::string> words{"ffmpeg",    "-y",
                                 "-loglevel", "error",
                                 "-f",        "rawvideo",
                                 "-pix_fmt",  pixels == VideoFile::Pixels::numbers ? "gray16" : "rgb24",
                                 "-s",        fmt::format("{}x{}", width, height),
                                 "-r",        fmt::format("{}", rate),
                                 "-i",        "-"};
  for (std::string& word : form_of(file, pixels)) words.push_back(std::move(word));
  words.push_back("file:" + file.string());  // a name with a colon is not an address
  return words;
}

}  // namespace

void check_video(const std::filesystem::path& file) {
  files::check_writable(checked(file));
  files::ChildPipe({"ffmpeg", "-version"}, no_ffmpeg).finish();
}

void check_number_video(const std::filesystem::path& file) { check_video(checked_for_numbers(file)); }

VideoFile::VideoFile(std::filesystem::path file, Pixels pixels, int width, int height, double frames_per_second)
    : file_(std::move(file)), part_(checked(file_, pixels), files::PartFile::Extension::of_file) {
  ffmpeg_.emplace(command(part_.path(), pixels, width, height, frames_per_second), no_ffmpeg);
}

VideoFile::~VideoFile() = default;

void VideoFile::add(std::span<const std::byte> picture) {
  MUROSIMF_ASSERT(ffmpeg_.has_value() && !picture.empty());
  ffmpeg_->write(picture);
  ++pictures_;
}

void VideoFile::finish() {
  const std::string errors = ffmpeg_->finish();
  if (!errors.empty()) refuse(file_, "ffmpeg says: " + errors);
  check_whole();
  part_.commit();
}

/// Reads the video again, without decoding.
void VideoFile::check_whole() const {
  const auto read = files::run_process({"ffmpeg", "-v", "error", "-nostdin", "-i", "file:" + part_.path().string(),
                                        "-map", "0:v", "-c", "copy", "-progress", "pipe:1", "-f", "null", "-"},
                                       {});
  const std::int64_t there = read ? last_frame(read->output) : 0;
  if (read && read->exit_code == 0 && read->errors.empty() && there == pictures_) return;
  refuse(file_, fmt::format("of {} pictures {} can be read again; is the disk full?", pictures_, there));
}

}  // namespace murosimf::appearance
