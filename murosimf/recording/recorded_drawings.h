/// recorded_drawings.h - what control software draws (model/drawing.h), as Foxglove shows it, and read back.
///
/// On the topic `/drawings/ROBOT` stands a foxglove.SceneUpdate whenever something is new, and every 5 s: everything on the topic is deleted,
/// and all groups that are there are drawn, each an entity of its name in the frame of the robot's base or the world. The entity's
/// metadata have each shape as JSON, with all digits; that is what is read back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/model/drawing.h"
#include "murosimf/recording/mcap_reader.h"
#include "murosimf/recording/message_sink.h"
#include "murosimf/recording/recorded_frame.h"

namespace murosimf::recording {

class FrameWriter;

/// In the simulation's thread: looks for what is new.
class SketchWatch {
 public:
  /// `clears`: at first it also says where nothing is drawn, for who has shown something there.
  explicit SketchWatch(bool clears = false) : clears_(clears) {}

  /// After take_numbers(), which finds the columns.
  void take(const std::vector<RecordedEntity>& entities, RecordedFrame& frame);

 private:
  bool clears_;
  std::map<std::size_t, std::uint64_t> seen_;  // changes and 1, by entity; 0: it is absent
};

/// In the thread that writes: topics are there as soon as somebody draws.
class DrawingWriter {
 public:
  DrawingWriter(MessageSink& file, FrameWriter& frames, const std::vector<RecordedEntity>& entities)
      : file_(file), frames_(frames), entities_(entities) {}
  void write(const RecordedFrame& frame);

 private:
  struct Sheet {
    std::uint16_t channel = 0;
    std::vector<DrawnGroup> groups;
    Duration written{};
  };
  MessageSink& file_;
  FrameWriter& frames_;
  const std::vector<RecordedEntity>& entities_;
  std::map<std::size_t, Sheet> sheets_;  // by entity
};

/// One message.
[[nodiscard]] std::string drawing_message(Duration time, const RecordedEntity& robot,
                                          const std::vector<DrawnGroup>& groups);
/// What it says; `robot`: its name. Throws SetupError.
[[nodiscard]] std::vector<DrawnGroup> read_drawing_message(std::string_view bytes, const std::string& robot);

/// For who shows a recording, at any time and in any order.
class DrawingReader {
 public:
  /// The file must outlive it.
  explicit DrawingReader(const McapReader& file);
  /// Who draws.
  [[nodiscard]] std::set<std::string> robots() const;
  /// What robots draw at a time, of those whose drawings are not as after the last call. Throws SetupError: the file is damaged there.
  [[nodiscard]] std::map<std::string, std::vector<DrawnGroup>> news(Duration time);

 private:
  struct Sketch {
    Duration time{};
    std::string robot, bytes;
  };
  struct Chunk {
    std::size_t index = 0;  // in chunks_
    std::vector<Sketch> sketches;
  };
  const Chunk& read(std::size_t index);
  [[nodiscard]] std::map<std::string, std::string> messages_at(Duration time);

  const McapReader& file_;
  std::map<std::uint16_t, std::string> robots_;  // by channel
  std::vector<std::size_t> chunks_;              // of the file, with drawings, by time
  std::list<Chunk> kept_;                        // the last one that was asked for first
  std::map<std::string, std::string> shown_;     // messages, by robot
};

}  // namespace murosimf::recording
