/// path_recorder.h - algorithm: remembers where entities have been, for pictures and plots.
#pragma once

#include <span>
#include <vector>

#include "murosimf/model/algorithm.h"
#include "murosimf/model/setup.h"

namespace murosimf {

class PathRecorder final : public Algorithm {
 public:
  /// Records every entity in `entities`; `setup` may be any entity's.
  PathRecorder(Setup& setup, const std::vector<Entity*>& entities);

  void initialize() override;
  void step(const Instant& instant) noexcept override;

  struct Path {
    Entity* entity = nullptr;
    std::vector<Vec3d> points;  ///< [m] of the base, world frame, one per call, the start first
  };
  [[nodiscard]] const std::vector<Path>& paths() const { return paths_; }

  static constexpr double rate_hz = 20;

 private:
  void record() noexcept;

  std::vector<Path> paths_;
  std::vector<std::span<const Vec3d>> positions_;
};

}  // namespace murosimf
