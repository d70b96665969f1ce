/// collision_probe.h - algorithm: counts and times what collision detection does for the present poses of a scene.
///
/// It finds all contacts once more, with trees and working memory of its own, and changes nothing.
#pragma once

#include <cstdint>
#include <vector>

#include "murosimf/collision/ground_finder.h"
#include "murosimf/collision/pair_finder.h"
#include "murosimf/world/algorithm.h"

namespace murosimf::app {

class CollisionProbe final : public Algorithm {
 public:
  struct Sample {
    std::int64_t volumes = 0, objects = 0;  ///< tests
    std::int64_t volumes_anew = 0;          ///< the same if nothing were remembered of the step before
    std::size_t contacts = 0;
    double pairs_us = 0, ground_us = 0;  ///< all transforms and tests: among moving entities; with goals and ground
  };

  /// `setup` is that of the environment.
  CollisionProbe(Setup& setup, const std::vector<Entity*>& moving_entities, const MaterialTable& materials);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::observe; }
  void step(const Instant& instant) noexcept override;

  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }
  /// Tests without any bounding volumes: every shape against every one of others, of the environment, and planes.
  [[nodiscard]] std::int64_t naive_tests() const { return naive_; }

 private:
  [[nodiscard]] collision::TestCounts find_on_ground() noexcept;

  std::vector<collision::MovingEntity> moving_entities_;
  std::vector<collision::GroundFinder> ground_finders_;
  collision::PairFinder pair_finder_;
  collision::PairSet pairs_;
  std::vector<collision::ContactPoint> points_;
  std::int64_t naive_ = 0;
  std::vector<Sample> samples_;
};

}  // namespace murosimf::app
