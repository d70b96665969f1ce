/// written_state.h - the state that a level has left in its columns, so that it notices later changes by others.
///
/// Levels keep working memory that follows from their columns. Changes of columns between two steps, by name, through a span
/// or a view, need no notification: the level compares. Equal bits are no change.
#pragma once

#include <vector>

#include "murosimf/dynamics/pose_columns.h"

namespace murosimf::dynamics {

class WrittenState {
 public:
  explicit WrittenState(const PoseColumns& columns);

  /// Stores the base's pose and velocity, joint positions and rates.
  void remember(const PoseColumns& columns) noexcept;
  /// Whether any of them differs from those that were stored.
  [[nodiscard]] bool differs(const PoseColumns& columns) const noexcept;
  /// Removes what was stored: differs() returns true.
  void forget() noexcept;

 private:
  struct Base {
    Vec3d r, v, w;
    Quaterniond Q;
  };
  [[nodiscard]] static Base base_of(const PoseColumns& columns) noexcept;

  Base base_;
  std::vector<double> q_, qd_;
};

}  // namespace murosimf::dynamics
