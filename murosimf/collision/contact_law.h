/// contact_law.h - how hard a contact pushes: the exchangeable part between detection and motion.
///
/// Per step: `prepare` linearizes every point at the present velocities; motion makes a trial step; `accept` looks at
/// the velocities after it and either agrees or changes its mind about points (open, stick, slip) and asks for
/// another trial; `commit` updates the memory. Laws have no state of their own: memory is in the points.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "murosimf/collision/contact.h"

namespace murosimf::collision {

/// Whether an island solver may take the points of a law as its own (body_contact.h).
enum class IslandUse {
  never,          ///< another force or memory
  when_touching,  ///< while the entity touches another one that moves
  always,
};

class ContactLaw {
 public:
  virtual ~ContactLaw() = default;

  [[nodiscard]] virtual IslandUse island_use() const noexcept { return IslandUse::never; }

  /// May drop points (a law that wants one per body).
  virtual void prepare(ContactSet& set) const noexcept = 0;
  /// True if all points agree with `set.next_velocity`; false if some changed and the step must be repeated.
  [[nodiscard]] virtual bool accept(ContactSet& set) const noexcept = 0;
  /// Updates the memory, and `force` of every point to what acted in the step.
  virtual void commit(ContactSet& set) const noexcept = 0;
};

/// Trial steps per step at most; the last one counts even if the law does not agree (dynamics: six suffice).
inline constexpr int max_passes = 6;

}  // namespace murosimf::collision
