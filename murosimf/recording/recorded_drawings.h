/// recorded_drawings.h - debug drawings of control software and other programs (world/drawing.h), as shown by Foxglove, and read back.
///
/// The topic `/drawings/ROBOT` has a foxglove.SceneUpdate after every change, and every 5 s: everything on the topic is deleted,
/// and all present groups are drawn, each as an entity of its name in the frame of the robot's base or the world. The entity's
/// metadata have each shape as JSON, with all digits, which is used for reading back. Drawings of other programs (recorded_external_drawings.h) are on
/// `/drawings/roboviz`, those at a robot on `/drawings/roboviz/ROBOT`; the channel's metadata distinguish them from a robot of that name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/recording/mcap/mcap_reader.h"
#include "murosimf/recording/mcap/message_sink.h"
#include "murosimf/recording/recorded_frame.h"
#include "murosimf/world/drawing.h"

namespace murosimf::recording {

class FrameWriter;

/// In the simulation's thread: detects changes.
class SketchWatch {
 public:
  /// `clears`: the first call also reports empty drawings, for viewers that still show older ones.
  explicit SketchWatch(bool clears = false) : clears_(clears) {}

  /// After take_numbers(), which looks up the columns.
  void take(const std::vector<RecordedEntity>& entities, RecordedFrame& frame);

 private:
  bool clears_;
  std::map<std::size_t, std::uint64_t> seen_;  // changes and 1, by entity; 0: absent
};

/// In the thread that writes: topics are created at the first drawing.
class DrawingWriter {
 public:
  DrawingWriter(MessageSink& file, FrameWriter& frames) : file_(file), frames_(frames) {}
  void write(const RecordedFrame& frame);

 private:
  struct Sheet {
    std::uint16_t channel = 0;
    FrameDrawings drawn;
    Duration written{};
  };
  MessageSink& file_;
  FrameWriter& frames_;
  std::map<DrawingTopic, Sheet> sheets_;
};

/// Encodes one message.
[[nodiscard]] std::string drawing_message(Duration time, const FrameDrawings& drawn);
/// Decodes it. Throws SetupError.
[[nodiscard]] std::vector<DrawnGroup> read_drawing_message(std::string_view bytes, const DrawingTopic& topic);

/// Drawings of a recording, at any time and in any order.
class DrawingReader {
 public:
  /// The file must outlive it.
  explicit DrawingReader(const McapReader& file);
  /// Robots with drawings of their software.
  [[nodiscard]] std::set<std::string> robots() const;
  /// Drawings at a time, of topics that differ from those of the last call. Throws SetupError: the file is damaged there.
  [[nodiscard]] std::map<DrawingTopic, std::vector<DrawnGroup>> news(Duration time);

 private:
  struct Sketch {
    Duration time{};
    DrawingTopic topic;
    std::string bytes;
  };
  struct Chunk {
    std::size_t index = 0;  // in chunks_
    std::vector<Sketch> sketches;
  };
  const Chunk& read(std::size_t index);
  [[nodiscard]] std::map<DrawingTopic, std::string> messages_at(Duration time);

  const McapReader& file_;
  std::map<std::uint16_t, DrawingTopic> topics_;  // by channel
  std::vector<std::size_t> chunks_;               // of the file, with drawings, by time
  std::list<Chunk> kept_;                         // most recently used first
  std::map<DrawingTopic, std::string> shown_;     // messages
};

}  // namespace murosimf::recording
