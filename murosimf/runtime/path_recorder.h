/// path_recorder.h - algorithm: remembers where entities have been, for pictures and plots.
///
/// It keeps at most `most_points` per entity, however long a run is: when they are full, every second one is forgotten, and
/// from then on half as many are noted. So there is a point in every period of 1/20 s for 204 s, in every 1/10 s for 409 s, ...
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf {

class PathRecorder final : public Algorithm {
 public:
  /// Records every entity in `entities`, and those that are added later.
  PathRecorder(Setup& setup, const std::vector<Entity*>& entities);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::observe; }
  void initialize() override;
  void entity_added(Setup& setup) override;
  void entity_taken_back(const Entity& entity) noexcept override;
  void entity_entered(const Entity& entity) override;
  void step(const Instant& instant) noexcept override;
  void state(StateArchive& archive) override;

  struct Path {
    Entity* entity = nullptr;
    std::vector<Vec3d>
        points;  ///< [m] of the base, world frame, in equal periods, the start first; where it will start before
  };
  [[nodiscard]] const std::vector<Path>& paths() const { return paths_; }

  static constexpr double rate_hz = 20;
  static constexpr std::size_t most_points = 4096;

 private:
  void add(Setup& setup);
  void record() noexcept;
  void thin_out() noexcept;

  std::vector<Path> paths_;
  std::vector<std::span<const Vec3d>> positions_;
  std::uint64_t calls_ = 0, every_ = 1;  // one call of so many is noted
};

}  // namespace murosimf
