/// video_file.h - writes pictures as a video, by a process of ffmpeg.
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

/// The extension determines the kind of video: .mp4, .webm, .gif, .mkv, .mov or .avi. Throws SetupError if it is another
/// one, if the file could not be written, or if there is no ffmpeg: to be called before a long run.
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

  /// Adds a picture of the size and kind above. Throws SetupError with ffmpeg's message if it fails.
  void add(const imaging::ColorImage& picture) { add(std::as_bytes(picture.pixels())); }
  void add(const imaging::NumberImage& picture) { add(std::as_bytes(picture.pixels())); }
  /// Completes the video, and replaces the previous file of its name. Throws as add(), also if ffmpeg succeeds with a video that lacks
  /// pictures or its index, as on a full disk.
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
