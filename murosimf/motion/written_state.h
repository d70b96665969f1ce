/// written_state.h - what a level has left in its columns, so that it notices what others have written there since.
///
/// Levels keep working memory that follows from their columns. Whoever changes these between two steps, by name, through a span
/// or a view, does not have to say so: the level compares. Equal bits are no change.
#pragma once

#include <vector>

#include "murosimf/motion/pose_columns.h"

namespace murosimf::motion {

class WrittenState {
 public:
  explicit WrittenState(const PoseColumns& columns);

  /// The base's pose and velocity, joint positions and rates as they are now.
  void remember(const PoseColumns& columns) noexcept;
  /// Whether any of them is another one than remembered.
  [[nodiscard]] bool differs(const PoseColumns& columns) const noexcept;
  /// Nothing is like what was remembered.
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

}  // namespace murosimf::motion
