/// islands.h - which entities touch each other, directly or through others, and so must be solved together.
#pragma once

#include <vector>

#include "murosimf/collision/mover.h"

namespace murosimf::collision {

/// Numbers the islands: entities that can be pushed and are joined by contacts have the same number; those that are not
/// solved by an island have -1. A law may want an island even for an entity that touches no other.
class Islands {
 public:
  void find(const std::vector<Mover>& movers, const PairSet& set);

  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] int of(int mover) const { return number_[mover]; }
  /// Of a contact: that of its side that can be pushed.
  [[nodiscard]] int of(const PairContact& c) const { return number_[c.a] >= 0 ? number_[c.a] : number_[c.b]; }

 private:
  [[nodiscard]] int root(int mover);

  std::vector<int> parent_;
  std::vector<int> number_;
  std::vector<bool> wanted_;
  int count_ = 0;
};

}  // namespace murosimf::collision
