/// frame_reader.h - reads the frames of a recording, from any instant on, as written by FrameWriter (frame_writer.h).
///
///     FrameReader frames(file, entities);
///     for (std::optional<Duration> time = frames.begin(); time; time = frames.after(*time)) show(frames.at(*time));
///
/// Only the chunks near an instant are read, and a few of them are cached.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "murosimf/recording/mcap/mcap_reader.h"
#include "murosimf/recording/recorded_frame.h"

namespace murosimf::recording {

class FrameReader {
 public:
  /// Both must outlive it. Throws SetupError: there are no poses in the file, or it is damaged.
  FrameReader(const McapReader& file, const std::vector<RecordedEntity>& entities);

  /// Times of the first and of the last frame.
  [[nodiscard]] Duration begin() const { return begin_; }
  [[nodiscard]] Duration end() const { return end_; }

  /// The last frame until then, or else the first one: poses, and, as far as recorded, joints and contacts. Joints without
  /// a record are NaN; poses of absent entities are undefined. Valid until the next call. Throws SetupError: the file is damaged.
  const RecordedFrame& at(Duration time);
  /// Time of the next frame after that.
  [[nodiscard]] std::optional<Duration> after(Duration time);

 private:
  struct Messages {
    std::string transforms, joints, targets, contacts;
  };
  struct Chunk {
    std::size_t index = 0;  // in chunks_
    std::map<Duration, Messages> frames;
  };
  [[noreturn]] void refuse_index() const;
  const Chunk& read(std::size_t index);
  void take_transforms(std::string_view data);
  void take_joints(std::string_view data, bool targets);
  void take_contacts(std::string_view data);

  const McapReader& file_;
  const std::vector<RecordedEntity>& entities_;
  std::map<std::uint16_t, std::string> channels_;
  std::vector<std::size_t> chunks_;  // of the file, with poses, by time
  std::list<Chunk> kept_;            // most recently used first
  struct Place {
    std::size_t entity = 0, index = 0;  // of a link in RecordedFrame::poses, of a joint in `joints`
  };
  std::unordered_map<std::string, Place> links_, joints_;
  Duration begin_{}, end_{};
  RecordedFrame frame_;
};

}  // namespace murosimf::recording
