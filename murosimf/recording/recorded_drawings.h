/// recorded_drawings.h - what control software draws (model/drawing.h), as Foxglove shows it, and read back.
///
/// On the topic `/drawings/ROBOT` stands a foxglove.SceneUpdate whenever something is new, and every 5 s: everything on the topic is deleted,
/// and all groups that are there are drawn, each an entity of its name in the frame of the robot's base or the world. The entity's
/// metadata have each shape as JSON, with all digits; that is what is read back.
#pragma once

#include <map>
#include <optional>
#include <string>
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
  void take(const std::vector<RecordedEntity>& entities, RecordedFrame& frame);

 private:
  std::map<std::size_t, std::uint64_t> seen_;  // changes, by entity
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

/// What is drawn at a time, by robot: for who shows a recording. Throws SetupError if the file is damaged there.
[[nodiscard]] std::map<std::string, std::vector<DrawnGroup>> recorded_drawings(const McapReader& file, Duration time);

}  // namespace murosimf::recording
