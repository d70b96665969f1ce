/// video_file.h - pictures, one after the other, as a video: an ffmpeg process writes it.
#pragma once

#include <filesystem>
#include <optional>

#include "murosimf/io/child_pipe.h"
#include "murosimf/sensors/image.h"

namespace murosimf::io {

class VideoFile {
 public:
  /// The extension decides about the kind of video: .mp4, .webm, .gif. Nothing is at `file` before finish(). Throws
  /// SetupError: the file cannot be written, or there is no ffmpeg.
  VideoFile(std::filesystem::path file, int width, int height, double frames_per_second);
  ~VideoFile();
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  /// A picture of the size above. Throws SetupError with ffmpeg's words if it gives up.
  void add(const sensors::ColorImage& picture);
  /// The video is whole now. Throws as add().
  void finish();

 private:
  std::filesystem::path file_, part_;
  std::optional<ChildPipe> ffmpeg_;
};

}  // namespace murosimf::io
