/// islands.h - which entities touch each other, directly or through others, and so must be solved together.
#pragma once

#include <vector>

#include "murosimf/collision/moving_entity.h"

namespace murosimf::collision {

/// Numbers the islands: entities that can be pushed and are joined by contacts have the same number; those that are not
/// solved by an island have -1. A law may want an island even for an entity that touches no other.
class Islands {
 public:
  void find(const std::vector<MovingEntity>& moving_entities, const PairSet& set);

  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] int of(int moving_entity) const { return number_[moving_entity]; }
  /// Of a contact: that of its side that can be pushed.
  [[nodiscard]] int of(const PairContact& c) const { return number_[c.a] >= 0 ? number_[c.a] : number_[c.b]; }

 private:
  [[nodiscard]] int root(int moving_entity);

  std::vector<int> parent_;
  std::vector<int> number_;
  std::vector<bool> wanted_;
  int count_ = 0;
};

}  // namespace murosimf::collision
