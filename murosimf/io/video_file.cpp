#include "murosimf/io/video_file.h"

#include <system_error>

#include <fmt/format.h>

#include "murosimf/io/output_file.h"
#include "murosimf/model/error.h"

namespace murosimf::io {
namespace {

std::vector<std::string> command(const std::filesystem::path& file, int width, int height, double rate) {
  // most players want even sizes and 4:2:0
  return {"ffmpeg",     "-y",
          "-loglevel",  "error",
          "-f",         "rawvideo",
          "-pix_fmt",   "rgb24",
          "-s",         fmt::format("{}x{}", width, height),
          "-r",         fmt::format("{}", rate),
          "-i",         "-",
          "-vf",        "pad=ceil(iw/2)*2:ceil(ih/2)*2",
          "-pix_fmt",   "yuv420p",
          file.string()};
}

}  // namespace

VideoFile::VideoFile(std::filesystem::path file, int width, int height, double frames_per_second)
    : file_(std::move(file)), part_(file_) {
  if (file_.extension().empty()) {
    throw SetupError(
        fmt::format("'{}': a video needs an extension, like .mp4: it says of which kind it is", file_.string()));
  }
  check_writable(file_);
  part_.replace_filename(fmt::format(".{}.part{}", file_.stem().string(), file_.extension().string()));
  ffmpeg_.emplace(command(part_, width, height, frames_per_second),
                  "it is not installed (Debian and Ubuntu: ffmpeg); pictures need --out FILE.png instead of --video");
}

VideoFile::~VideoFile() {
  ffmpeg_.reset();
  std::error_code ignored;
  std::filesystem::remove(part_, ignored);
}

void VideoFile::add(const sensors::ColorImage& picture) { ffmpeg_->write(std::as_bytes(picture.pixels())); }

void VideoFile::finish() {
  ffmpeg_->finish();
  std::error_code error;
  std::filesystem::rename(part_, file_, error);
  if (error) throw SetupError(fmt::format("cannot write '{}': {}", file_.string(), error.message()));
}

}  // namespace murosimf::io
