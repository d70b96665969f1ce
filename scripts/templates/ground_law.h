/// new_name.h - contact law: a damped spring that cannot pull, without friction; explicit.
///
/// With depth delta, unit normal n (out of the ground) and the point's velocity v at the beginning of the step:
///
///     f = max(0, k delta - d n . v) n
///
/// This place is for the equations of the law, their source, and the steps at which it is stable.
#pragma once

#include "murosimf/collision/contact_laws/contact_law.h"

namespace murosimf::collision {

class NewName final : public ContactLaw {
 public:
  void prepare(std::vector<ContactPoint>& points, const ContactTerms& terms) const noexcept override;
  /// The force does not depend on the velocity after the step: every trial is right.
  [[nodiscard]] bool accept(std::span<ContactPoint>, const ContactTerms&,
                            std::span<const Vec3d>) const noexcept override {
    return true;
  }
  /// It has no state. A law with a state writes it to the points (ContactPoint::stretch), never to members.
  void commit(std::span<ContactPoint>, const ContactTerms&, std::span<const Vec3d>) const noexcept override {}
};

}  // namespace murosimf::collision
