/// inner_pairs.h - the shapes of one entity that may touch each other (paper 5: inner collisions, off by default).
#pragma once

#include <span>
#include <vector>

#include "murosimf/collision/colliding_shapes.h"
#include "murosimf/math/assert.h"

namespace murosimf::collision {

class InnerPairs {
 public:
  /// None: inner collisions are off.
  InnerPairs() = default;
  /// All pairs but those of one link, of a link and its parent, of shapes that overlap while all joints are at zero, that
  /// are not to touch by their kinds (model/shape.h), and `excluded` ones, here and in the model (excluded_pairs). An
  /// object without shapes stands for everything that is fixed to the same link. After all that, the model's
  /// allowed_pairs may touch. Throws SetupError, with the nearest name, if an object or shape does not exist.
  InnerPairs(const Model& model, std::span<const CollidingShape> shapes, const ExcludedPairs& excluded);

  /// Shapes by their numbers in colliding_shapes().
  [[nodiscard]] bool may_touch(int a, int b) const {
    MUROSIMF_ASSERT(static_cast<std::size_t>(a) < count_ && static_cast<std::size_t>(b) < count_);
    return may_touch_[static_cast<std::size_t>(a) * count_ + b];
  }
  [[nodiscard]] bool off() const { return count_ == 0; }

 private:
  void set(int a, int b, bool may) {
    MUROSIMF_ASSERT(static_cast<std::size_t>(a) < count_ && static_cast<std::size_t>(b) < count_);
    may_touch_[a * count_ + b] = may_touch_[b * count_ + a] = may;
  }
  void exclude_near(const Model& model, std::span<const CollidingShape> shapes);
  void exclude(const Model& model, std::span<const CollidingShape> shapes, const ExcludedPairs& pairs);
  void allow(const Model& model, std::span<const CollidingShape> shapes, const AllowedPairs& pairs);

  std::size_t count_ = 0;
  std::vector<bool> may_touch_;  // of shapes a and b at a * count + b
};

}  // namespace murosimf::collision
