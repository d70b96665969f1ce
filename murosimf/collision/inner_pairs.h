/// inner_pairs.h - which shapes of one entity may touch each other (paper 5: inner collisions, off by default).
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/collision/colliding_shapes.h"

namespace murosimf::collision {

/// Two objects of a model, by name, that shall never touch.
using ExcludedPair = std::pair<std::string, std::string>;

class InnerPairs {
 public:
  /// None: inner collisions are off.
  InnerPairs() = default;
  /// All pairs but those of one link, of a link and its parent, of shapes that overlap while all joints are at zero, and
  /// `excluded` ones. An object without shapes stands for everything that is fixed to the same link. Throws SetupError
  /// with the nearest name if an excluded object does not exist.
  InnerPairs(const Model& model, std::span<const CollidingShape> shapes, const std::vector<ExcludedPair>& excluded);

  /// Shapes by their numbers in colliding_shapes().
  [[nodiscard]] bool may_touch(int a, int b) const { return may_touch_[static_cast<std::size_t>(a) * count_ + b]; }
  [[nodiscard]] bool off() const { return count_ == 0; }

 private:
  void exclude(int a, int b) { may_touch_[a * count_ + b] = may_touch_[b * count_ + a] = false; }

  std::size_t count_ = 0;
  std::vector<bool> may_touch_;  // of shapes a and b at a * count + b
};

}  // namespace murosimf::collision
