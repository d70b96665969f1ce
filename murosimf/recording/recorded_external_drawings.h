/// recorded_external_drawings.h - what programs draw that are no software of a robot (drawing/debug_draw_source.h): on its way into a recording, and
/// as it was then.
///
/// They send it when they like: it is recorded with the simulated time at which it was seen, and nothing hangs on it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/drawing/drawn.h"
#include "murosimf/model/world.h"
#include "murosimf/recording/recorded_frame.h"

namespace murosimf::recording {

/// Looks for what is new.
class OthersWatch {
 public:
  /// Who is there, between two steps: before the first take(), and when others have come.
  void meet(const World& world, const std::vector<RecordedEntity>& entities);
  /// In any thread.
  void take(const drawing::ExternalDrawings& others, RecordedFrame& frame);
  /// The next take() takes all of it, also what is there no more.
  void say_again();

 private:
  std::vector<std::string> teams_;           // of entities of the world
  std::vector<std::string> names_, frames_;  // likewise; empty: without poses
  std::optional<std::uint64_t> changes_;     // that were taken
  bool again_ = false;
  std::map<std::string, std::vector<DrawnGroup>> drawn_;  // by robot
};

/// What was drawn then, put together again.
class RecordedExternalDrawings {
 public:
  /// `world`: in which robots have their numbers.
  explicit RecordedExternalDrawings(const World& world);
  /// News of a DrawingReader; whether something of them is by others.
  bool take(const std::map<DrawingTopic, std::vector<DrawnGroup>>& news);
  [[nodiscard]] drawing::ExternalDrawings shown() const;

 private:
  std::map<std::string, drawing::TeamPlace> places_;  // by robot
  std::map<std::string, std::vector<DrawnGroup>> drawn_;
};

}  // namespace murosimf::recording
