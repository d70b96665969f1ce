#include "murosimf/collision/islands.h"

#include <algorithm>
#include <numeric>

#include "murosimf/collision/contact_law.h"

namespace murosimf::collision {

int Islands::root(int mover) {
  while (parent_[mover] != mover) mover = parent_[mover] = parent_[parent_[mover]];
  return mover;
}

void Islands::find(const std::vector<Mover>& movers, const PairSet& set) {
  const auto size = movers.size();
  parent_.resize(size);
  std::iota(parent_.begin(), parent_.end(), 0);
  wanted_.assign(size, false);
  const auto solvable = [&](int i) { return movers[i].can_be_pushed() && movers[i].contacts.response != nullptr; };
  for (const PairContact& c : set.points) {
    for (const int side : {c.a, c.b}) wanted_[side] = wanted_[side] || solvable(side);
    // the smaller number becomes the root, so the order of contacts does not matter
    if (solvable(c.a) && solvable(c.b)) {
      const auto [low, high] = std::minmax({root(c.a), root(c.b)});
      parent_[high] = low;
    }
  }
  for (int i = 0; i < static_cast<int>(size); ++i) {
    const ContactLaw* law = movers[i].contacts.law;
    if (law && law->island_use() == IslandUse::always && solvable(i) && !movers[i].entity->frozen()) wanted_[i] = true;
  }
  number_.assign(size, -1);
  count_ = 0;
  for (int i = 0; i < static_cast<int>(size); ++i) {
    if (!wanted_[i]) continue;
    int& number = number_[root(i)];
    if (number < 0) number = count_++;
    number_[i] = number;
  }
}

}  // namespace murosimf::collision
