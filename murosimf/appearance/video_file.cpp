#include "murosimf/appearance/video_file.h"

#include <algorithm>
#include <array>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "murosimf/files/output_file.h"
#include "murosimf/model/error.h"

namespace murosimf::appearance {
namespace {

constexpr std::array kinds{".mp4", ".webm", ".gif", ".mkv", ".mov", ".avi"};
constexpr const char* no_ffmpeg =
    "it is not installed (Debian and Ubuntu: ffmpeg); pictures need --out FILE.png instead of --video";

void check_file(const std::filesystem::path& file) {
  if (std::ranges::find(kinds, file.extension().string()) == kinds.end()) {
    throw SetupError(fmt::format("'{}': its extension must say which kind of video it is: {}", file.string(),
                                 fmt::join(kinds, ", ")));
  }
  files::check_writable(file);
}

/// Most players want even sizes and 4:2:0; a GIF has a palette for each picture.
std::vector<std::string> form_of(const std::filesystem::path& file) {
  if (file.extension() == ".gif") {
    return {"-vf", "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1"};
  }
  return {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p"};
}

std::vector<std::string> command(const std::filesystem::path& file, int width, int height, double rate) {
  std::vector<std::string> words{"ffmpeg",    "-y",
                                 "-loglevel", "error",
                                 "-f",        "rawvideo",
                                 "-pix_fmt",  "rgb24",
                                 "-s",        fmt::format("{}x{}", width, height),
                                 "-r",        fmt::format("{}", rate),
                                 "-i",        "-"};
  for (std::string& word : form_of(file)) words.push_back(std::move(word));
  words.push_back("file:" + file.string());  // a name with a colon is no address
  return words;
}

}  // namespace

void check_video(const std::filesystem::path& file) {
  check_file(file);
  files::ChildPipe({"ffmpeg", "-version"}, no_ffmpeg).finish();
}

VideoFile::VideoFile(std::filesystem::path file, int width, int height, double frames_per_second)
    : file_(std::move(file)), part_(file_) {
  check_file(file_);
  part_.replace_filename(fmt::format(".{}.{}.part{}", file_.stem().string(), ::getpid(), file_.extension().string()));
  half_video_.emplace(part_);
  ffmpeg_.emplace(command(part_, width, height, frames_per_second), no_ffmpeg);
}

VideoFile::~VideoFile() {
  ffmpeg_.reset();
  std::error_code ignored;
  std::filesystem::remove(part_, ignored);
}

void VideoFile::add(const imaging::ColorImage& picture) { ffmpeg_->write(std::as_bytes(picture.pixels())); }

void VideoFile::finish() {
  ffmpeg_->finish();
  std::error_code error;
  std::filesystem::rename(part_, file_, error);
  if (error) throw SetupError(fmt::format("cannot write '{}': {}", file_.string(), error.message()));
}

}  // namespace murosimf::appearance
