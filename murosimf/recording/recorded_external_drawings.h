/// recorded_external_drawings.h - drawings of programs other than a robot's software (drawing/debug_draw_source.h): for a recording, and
/// read back.
///
/// They arrive at any time: they are recorded with the simulated time at which they were received, and have no effect on the run.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/drawing/drawn.h"
#include "murosimf/recording/recorded_frame.h"
#include "murosimf/world/world.h"

namespace murosimf::recording {

/// Detects changes.
class OthersWatch {
 public:
  /// Sets the entities, between two steps: before the first take(), and after additions.
  void meet(const World& world, const std::vector<RecordedEntity>& entities);
  /// From any thread.
  void take(const drawing::ExternalDrawings& others, RecordedFrame& frame);
  /// The next take() reports everything, including removed drawings.
  void say_again();

 private:
  std::vector<std::string> teams_;           // of entities of the world
  std::vector<std::string> names_, frames_;  // likewise; empty: without poses
  std::optional<std::uint64_t> changes_;     // processed so far
  bool again_ = false;
  std::map<std::string, std::vector<DrawnGroup>> drawn_;  // by robot
};

/// The recorded drawings, assembled again.
class RecordedExternalDrawings {
 public:
  /// `world`: defines the numbers of robots.
  explicit RecordedExternalDrawings(const World& world);
  /// Takes changes of a DrawingReader; returns whether any are of other programs.
  bool take(const std::map<DrawingTopic, std::vector<DrawnGroup>>& news);
  [[nodiscard]] drawing::ExternalDrawings shown() const;

 private:
  std::map<std::string, drawing::TeamPlace> places_;  // by robot
  std::map<std::string, std::vector<DrawnGroup>> drawn_;
};

}  // namespace murosimf::recording
