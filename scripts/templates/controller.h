/// new_name.h - algorithm: walks straight on with one velocity.
///
/// Writes `walk_command` [m/s, m/s, rad/s], in the robot's frame, x forward; the walk engine (locomotion/walk_engine.h), which
/// is attached after it, turns that into joint targets.
///
/// This place is for the rules of a controller, their inputs, and their source.
#pragma once

#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::soccer {

struct NewNameOptions {
  Vec3d velocity{0.1, 0, 0};  ///< [m/s, m/s, rad/s] half of what kid21 can walk forward
};

class NewName final : public Algorithm {
 public:
  explicit NewName(Setup& setup, const NewNameOptions& options = {});

  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;

  static constexpr double rate_hz = 20;

 private:
  NewNameOptions options_;
  Vec3d& command_;  // [m/s, m/s, rad/s]
};

}  // namespace murosimf::soccer
