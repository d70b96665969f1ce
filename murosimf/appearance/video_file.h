/// video_file.h - pictures, one after the other, as a video: an ffmpeg process writes it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

#include "murosimf/files/child_process.h"
#include "murosimf/files/output_file.h"
#include "murosimf/imaging/image.h"

namespace murosimf::appearance {

/// The extension decides about the kind of video: .mp4, .webm, .gif, .mkv, .mov or .avi. Throws SetupError if it is none
/// of these, if the file could not be written now, or if there is no ffmpeg: found out before a long run, not after it.
void check_video(const std::filesystem::path& file);
/// The same for a video of numbers, which only .mkv keeps (FFV1, without loss).
void check_number_video(const std::filesystem::path& file);

class VideoFile {
 public:
  enum class Pixels { colors, numbers };

  /// Nothing is at `file` before finish(). Throws SetupError as check_video, or check_number_video.
  VideoFile(std::filesystem::path file, Pixels pixels, int width, int height, double frames_per_second);
  ~VideoFile();
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  /// A picture of the size and kind above. Throws SetupError with ffmpeg's words if it gives up.
  void add(const imaging::ColorImage& picture) { add(std::as_bytes(picture.pixels())); }
  void add(const imaging::NumberImage& picture) { add(std::as_bytes(picture.pixels())); }
  /// The video is whole, and takes the place of what had its name. Throws as add(), also if ffmpeg is content with a video that lacks
  /// pictures or its index, as it is when the disk is full.
  void finish();

 private:
  void add(std::span<const std::byte> picture);
  void check_whole() const;

  std::filesystem::path file_;
  files::PartFile part_;
  std::int64_t pictures_ = 0;
  std::optional<files::ChildPipe> ffmpeg_;  // goes first
};

}  // namespace murosimf::appearance
