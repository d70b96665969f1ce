/// lane_group.h - algorithms of one kind that step together, each in its own lane of packs (math/pack.h).
///
/// Eight equal robots cost little more than one if one kernel steps them all. The scheduler joins algorithms that may run at the
/// same time, have the same rate, and say that they go together (Algorithm::goes_with).
#pragma once

#include <span>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/math/lanes.h"
#include "murosimf/world/algorithm.h"

namespace murosimf {

/// The same, as what they are.
template <class A>
[[nodiscard]] std::vector<A*> members_of(std::span<Algorithm* const> members) {
  std::vector<A*> result;
  for (Algorithm* member : members) {
    MUROSIMF_ASSERT(dynamic_cast<A*>(member));
    result.push_back(static_cast<A*>(member));
  }
  return result;
}

class LaneGroup {
 public:
  virtual ~LaneGroup() = default;
  /// Executes one step of the members in `due`, by their numbers; bit for bit the result of Algorithm::step() of each. The others are
  /// not changed.
  virtual void step(LaneMask due, const Instant& instant) noexcept = 0;

  /// In the next steps the members begin at these simulated times, by lane, instead of at that of the instant: they belong to several
  /// simulations. Null: to one.
  void begin_at(const Duration* times) noexcept { times_ = times; }

 protected:
  /// As one member has it.
  [[nodiscard]] Instant of_lane(int lane, const Instant& instant) const noexcept {
    return {times_ ? times_[lane] : instant.now, instant.period, instant.parallel_for};
  }

 private:
  const Duration* times_ = nullptr;
};

}  // namespace murosimf
