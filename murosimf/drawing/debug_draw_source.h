/// debug_draw_source.h - source of drawings by programs that are not software of a robot: live (roboviz_server.h), or
/// recorded.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/world/drawing.h"

namespace murosimf::drawing {

/// Groups in the order of their names, and a text for each robot that has one.
struct ExternalDrawings {
  struct Note {
    int team = 0;    ///< 0 left, 1 right
    int number = 0;  ///< in its team, from 0
    Color color;
    std::string text;
  };
  std::vector<DrawnGroup> groups;
  std::vector<Note> notes;
  std::uint64_t changes = 0;
};

class DebugDrawSource {
 public:
  DebugDrawSource() = default;
  virtual ~DebugDrawSource() = default;
  DebugDrawSource(const DebugDrawSource&) = delete;
  DebugDrawSource& operator=(const DebugDrawSource&) = delete;
  /// The present drawings, from any thread; never null.
  [[nodiscard]] virtual std::shared_ptr<const ExternalDrawings> shown() const = 0;
};

/// Provides drawings that are set from any thread.
class DebugDrawBuffer final : public DebugDrawSource {
 public:
  /// Replaces the drawings; `changes` are counted here.
  void pin(ExternalDrawings drawn) {
    const std::lock_guard lock(mutex_);
    drawn.changes = shown_->changes + 1;
    shown_ = std::make_shared<const ExternalDrawings>(std::move(drawn));
  }
  [[nodiscard]] std::shared_ptr<const ExternalDrawings> shown() const override {
    const std::lock_guard lock(mutex_);
    return shown_;
  }

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const ExternalDrawings> shown_ = std::make_shared<const ExternalDrawings>();
};

}  // namespace murosimf::drawing
