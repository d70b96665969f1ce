/// kelvin_voigt_law.h - the textbook law: spring and damper, with a tangential spring that sticks; explicit.
///
/// With depth delta, unit normal n (out of the ground), point velocity v and spring displacement s at the beginning of
/// the step, and v+ after it:
///
///     f_n = max(0, k delta - d v_n)
///     f_t = -kt s - ct v_t                                  stick, while |f_t| <= mu f_n
///     f_t = mu f_n times the unit vector of that            slip
///     after the step: s = -(f_t + ct v_t) / kt (slip: return to the cone), then s += dt v_t+ (both)
///
/// A round body also feels a rolling resistance (contact_law_parts.h). external_damping stays zero.
/// Source:  Kelvin-Voigt element with the frictional spring of Cundall and Strack, "A discrete numerical model for
///          granular assemblies", Geotechnique 29(1), 1979.
/// Differs: s is a displacement that is carried along, not the distance from an anchor: that would make a rolling ball
///          drift.
/// Limits:  an explicit spring is stable only while dt^2 k / m and dt d / m are small; docs/scenes.md has the steps.
#pragma once

#include "murosimf/collision/contact_laws/contact_law.h"

namespace murosimf::collision {

class KelvinVoigt final : public ContactLaw {
 public:
  void prepare(std::vector<ContactPoint>& points, const ContactTerms& terms) const noexcept override;
  [[nodiscard]] bool accept(std::span<ContactPoint>, const ContactTerms&,
                            std::span<const Vec3d>) const noexcept override {
    return true;
  }
  void commit(std::span<ContactPoint> points, const ContactTerms& terms,
              std::span<const Vec3d> next_velocity) const noexcept override;
};

}  // namespace murosimf::collision
