/// islands.h - groups of entities that touch each other, directly or through others, and so must be solved together.
#pragma once

#include <span>
#include <vector>

#include "murosimf/collision/moving_entity.h"
#include "murosimf/math/assert.h"

namespace murosimf::collision {

/// Numbers the islands: entities that can be pushed and are joined by contacts have the same number; those that are not
/// solved by an island have -1. A law may request an island even for an entity that touches no other.
class Islands {
 public:
  void find(const std::vector<MovingEntity>& moving_entities, const PairSet& set);

  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] int of(int moving_entity) const { return number_[moving_entity]; }
  /// Of a contact: that of its side that can be pushed.
  [[nodiscard]] int of(const PairContact& c) const { return number_[c.a] >= 0 ? number_[c.a] : number_[c.b]; }
  /// Its moving entities, rising.
  [[nodiscard]] std::span<const int> members(int island) const { return members_.row(island); }
  /// Its contacts, as indices of set.points, rising.
  [[nodiscard]] std::span<const int> contacts(int island) const { return contacts_.row(island); }

 private:
  /// Elements of the islands, one row for each island.
  class Rows {
   public:
    /// Element i belongs to island island_of(i) of `islands`; to none, if that is below 0.
    template <class IslandOf>
    void sort(int things, int islands, const IslandOf& island_of);
    [[nodiscard]] std::span<const int> row(int island) const {
      MUROSIMF_ASSERT(island >= 0 && static_cast<std::size_t>(island) + 1 < end_.size());
      return {things_.data() + end_[island], things_.data() + end_[island + 1]};
    }

   private:
    std::vector<int> things_;
    std::vector<int> end_;  // of the row before
  };
  [[nodiscard]] int root(int moving_entity);

  std::vector<int> parent_;
  std::vector<int> number_;
  std::vector<bool> wanted_;
  int count_ = 0;
  Rows members_, contacts_;
};

}  // namespace murosimf::collision
