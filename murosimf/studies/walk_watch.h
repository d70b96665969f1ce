/// walk_watch.h - samples the motion of a robot that walks, and computes the cost of its walk (walk_tuning.h has the equation).
#pragma once

#include <cmath>

#include "murosimf/world/entity.h"

namespace murosimf::studies {

struct WalkOutcome {
  bool fell = false;
  double cost = 0;
};

/// How far a robot comes in its own frame.
class WalkWatch {
 public:
  /// `command` [m/s, m/s, rad/s]; `duration` [s] of the walk; `robot` lives as long.
  WalkWatch(Entity& robot, const Vec3d& command, double duration);

  /// `now` [s] since it began.
  void look(double now);
  [[nodiscard]] WalkOutcome outcome() const;

 private:
  Entity& robot_;
  Vec3d command_;
  double duration_, from_;
  Vec3d place_, way_;
  double heading_ = 0, turned_ = 0, fell_at_ = HUGE_VAL;
};

}  // namespace murosimf::studies
