#include "murosimf/collision/contact_laws/islands.h"

#include <algorithm>
#include <numeric>

#include "murosimf/collision/contact_laws/contact_law.h"
#include "murosimf/math/assert.h"

namespace murosimf::collision {

template <class IslandOf>
void Islands::Rows::sort(int things, int islands, const IslandOf& island_of) {
  if (islands == 0) return;  // no row can be requested
  end_.assign(static_cast<std::size_t>(islands) + 2, 0);
  // counting sort: stable, so members and contacts rise within an island
  for (int i = 0; i < things; ++i) {
    if (island_of(i) >= 0) ++end_[island_of(i) + 2];
  }
  std::partial_sum(end_.begin(), end_.end(), end_.begin());
  things_.resize(static_cast<std::size_t>(end_.back()));
  for (int i = 0; i < things; ++i) {
    if (island_of(i) >= 0) things_[end_[island_of(i) + 1]++] = i;
  }
}

int Islands::root(int moving_entity) {
  MUROSIMF_ASSERT(static_cast<std::size_t>(moving_entity) < parent_.size());
  while (parent_[moving_entity] != moving_entity)
    moving_entity = parent_[moving_entity] = parent_[parent_[moving_entity]];
  return moving_entity;
}

void Islands::find(const std::vector<MovingEntity>& moving_entities, const PairSet& set) {
  const auto size = moving_entities.size();
  parent_.resize(size);
  std::iota(parent_.begin(), parent_.end(), 0);
  wanted_.assign(size, false);
  const auto solvable = [&](int i) {
    return moving_entities[i].can_be_pushed() && moving_entities[i].interface.response != nullptr;
  };
  for (const PairContact& c : set.points) {
    MUROSIMF_ASSERT(static_cast<std::size_t>(c.a) < size && static_cast<std::size_t>(c.b) < size);
    for (const int side : {c.a, c.b}) wanted_[side] = wanted_[side] || solvable(side);
    // the smaller number becomes the root, so the order of contacts does not matter
    if (solvable(c.a) && solvable(c.b)) {
      const auto [low, high] = std::minmax({root(c.a), root(c.b)});
      parent_[high] = low;
    }
  }
  for (int i = 0; i < static_cast<int>(size); ++i) {
    const ContactLaw* law = moving_entities[i].interface.law;
    if (law && law->island_use() == IslandUse::always && solvable(i) && !moving_entities[i].apart()) wanted_[i] = true;
  }
  number_.assign(size, -1);
  count_ = 0;
  for (int i = 0; i < static_cast<int>(size); ++i) {
    if (!wanted_[i]) continue;
    int& number = number_[root(i)];
    if (number < 0) number = count_++;
    number_[i] = number;
  }
  members_.sort(static_cast<int>(size), count_, [&](int i) { return number_[i]; });
  contacts_.sort(static_cast<int>(set.points.size()), count_, [&](int i) { return of(set.points[i]); });
}

}  // namespace murosimf::collision
