/// contact_law.h - how hard a contact pushes: the exchangeable part between detection and motion.
///
/// Per step: `prepare` linearizes every point at the present velocities; motion makes a trial step; `accept` looks at
/// the velocities after it and either agrees or changes its mind about points (open, stick, slip) and asks for
/// another trial; `commit` updates the memory. Laws have no state of their own: memory is in the points, constants in the
/// terms; both are handed in.
#pragma once

#include <span>
#include <vector>

#include "murosimf/collision/contact_point.h"

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
  /// Whether it bears the stiffest contacts that a step resolves (contact_parameters.h).
  [[nodiscard]] virtual bool implicit() const noexcept { return false; }

  /// May drop points (a law with one per body).
  virtual void prepare(std::vector<ContactPoint>& points, const ContactTerms& terms) const noexcept = 0;
  /// `next_velocity` [m/s]: of every point after the trial step, as many as points. True if all points agree with it;
  /// false if some changed and the step must be repeated.
  [[nodiscard]] virtual bool accept(std::span<ContactPoint> points, const ContactTerms& terms,
                                    std::span<const Vec3d> next_velocity) const noexcept = 0;
  /// Updates the memory, and `force` of every point to what acted in the step that ends with `next_velocity` [m/s].
  virtual void commit(std::span<ContactPoint> points, const ContactTerms& terms,
                      std::span<const Vec3d> next_velocity) const noexcept = 0;
};

/// Trial steps per step at most; the last one counts even if the law does not agree (dynamics: six suffice).
inline constexpr int max_passes = 6;

}  // namespace murosimf::collision
