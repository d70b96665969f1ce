/// step_checks.h - debug builds: what algorithms do to columns while waves run is compared with what they have declared.
///
/// A span that was taken from a column without a Setup, or a pointer into one, escapes every declaration. So now and then
/// the columns are compared before and after a wave: those that have changed must be written by an algorithm of the wave.
/// And after every tick numbers of state that were finite must be finite still, or their entity frozen (algorithm.h).
/// Whatever is wrong ends the program with a message: it is an error of ours, not of users.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "murosimf/world/access.h"
#include "murosimf/world/world.h"

namespace murosimf {

class StepChecks {
 public:
  /// Begins anew: the columns of `world` are as they should be, and `access` is what all its algorithms have declared.
  void restart(const World& world, const std::vector<const AccessSet*>& access);

  /// To be called for every wave of tick number `tick`. Looks at the first two ticks and at every 128th.
  void before_wave(const World& world, std::int64_t tick);
  /// `access`: of the algorithms of that wave.
  void after_wave(const std::vector<const AccessSet*>& access) const;

  void after_tick();

 private:
  struct Seen {
    const Entity* entity;
    const ColumnBase* column;
    std::uint64_t hash;
  };
  struct Numbers {
    const Entity* entity;
    const ColumnBase* column;
    std::size_t not_finite;
  };

  std::vector<Seen> before_;      // of the present wave; empty: not looked at
  std::vector<Numbers> numbers_;  // of state that some algorithm writes
};

}  // namespace murosimf
