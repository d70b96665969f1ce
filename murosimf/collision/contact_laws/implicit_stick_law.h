/// implicit_stick_law.h - the default law: compliant contact, implicit in the velocity after the step, with a
/// tangential spring that sticks without creep.
///
/// With depth delta, unit normal n (out of the ground), point velocity v, spring displacement s and v+ after the step:
///
///     f_n = k (delta - theta dt v_n+) - d v_n+               pushes only: open if it would pull
///     f_t = -kt (s + dt v_t+) - ct v_t+                      stick, while |f_t| <= mu f_n
///     f_t = -mu f_n v_t+ / |v_t+|                            slip (linearized; normal force of the pass before)
///     after the step: s += dt v_t+ (stick);  s = -(f_t + ct v_t+) / kt (slip: return to the cone)
///
/// so that f = f0 - B a with b_n = d + theta dt k, b_t = ct + dt kt. A robot on a slope does not creep, and steps up
/// to 10 ms are stable. A point that was open and closes while it moves along the surface begins sliding: a trial of sticking
/// would disturb the decisions about its neighbors, and with corners that open and close six passes then end
/// with friction beyond its cone. mu may depend on the direction of sliding, and a round body has a rolling
/// resistance as well (contact_law_parts.h).
/// Source: measured with the project's prototype; elastoplastic friction as in Dupont, Hayward, Armstrong,
/// Altpeter, IEEE Trans. Automatic Control 47(5), 2002, with a rigid-plastic cone.
/// theta = 1 for all but springs that bounce (contact_parameters.h); round bodies bounce by an impulse instead (bounce.h).
#pragma once

#include "murosimf/collision/contact_laws/contact_law.h"

namespace murosimf::collision {

class ImplicitStick : public ContactLaw {
 public:
  [[nodiscard]] IslandUse island_use() const noexcept override { return IslandUse::when_touching; }
  [[nodiscard]] bool implicit() const noexcept override { return true; }
  void prepare(std::vector<ContactPoint>& points, const ContactTerms& terms) const noexcept override;
  [[nodiscard]] bool accept(std::span<ContactPoint> points, const ContactTerms& terms,
                            std::span<const Vec3d> next_velocity) const noexcept override;
  void commit(std::span<ContactPoint> points, const ContactTerms& terms,
              std::span<const Vec3d> next_velocity) const noexcept override;
};

/// The same force and memory, but always settled by the island solver (body_contact.h), whether the entity touches others or not.
class IslandGaussSeidel final : public ImplicitStick {
 public:
  [[nodiscard]] IslandUse island_use() const noexcept override { return IslandUse::always; }
};

}  // namespace murosimf::collision
