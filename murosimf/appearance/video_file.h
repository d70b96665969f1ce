/// video_file.h - pictures, one after the other, as a video: an ffmpeg process writes it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "murosimf/files/child_process.h"
#include "murosimf/files/output_file.h"
#include "murosimf/imaging/image.h"

namespace murosimf::appearance {

/// The extension decides about the kind of video: .mp4, .webm, .gif, .mkv, .mov or .avi. Throws SetupError if it is none
/// of these, if the file could not be written now, or if there is no ffmpeg: found out before a long run, not after it.
void check_video(const std::filesystem::path& file);

class VideoFile {
 public:
  /// Nothing is at `file` before finish(). Throws SetupError as check_video.
  VideoFile(std::filesystem::path file, int width, int height, double frames_per_second);
  ~VideoFile();
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  /// A picture of the size above. Throws SetupError with ffmpeg's words if it gives up.
  void add(const imaging::ColorImage& picture);
  /// The video is whole, and takes the place of what had its name. Throws as add(), also if ffmpeg is content with a video that lacks
  /// pictures or its index, as it is when the disk is full.
  void finish();

 private:
  void check_whole() const;

  std::filesystem::path file_;
  files::PartFile part_;
  std::int64_t pictures_ = 0;
  std::optional<files::ChildPipe> ffmpeg_;  // goes first
};

}  // namespace murosimf::appearance
