/// paper_law.h - the contact law of the paper, eq. (4) and (5): `paper` at one point per body and ground, as there, and
/// `paper_multipoint` at every point.
///
///     f_n    = s_c depth n          approaching
///            = s_b s_c depth n      separating
///     f_fric = -s_mu |f_n| v_t      n_fric = -s_nu |f_n| w
///
/// Source:  paper 5.3. Explicit: external_damping stays zero.
/// Differs: the paper leaves open the signs (friction must oppose the motion), which velocity rubs (only the
///          tangential part; the whole would damp the normal direction too), and which point stands for the pair
///          (the deepest). One point is no support polygon: a box rocks on it.
/// Limits:  friction is viscous, so on a slope of angle a everything creeps with tan(a)/s_mu; s_mu above about
///          10 s/m is unstable with steps of 1 ms. Both are properties of the law.
#pragma once

#include "murosimf/collision/contact_law.h"

namespace murosimf::collision {

struct PaperLawOptions {
  double rebound = 0.4;         ///< [1] s_b
  double friction = 5.0;        ///< [s/m] s_mu
  double spin_friction = 0.01;  ///< [m s] s_nu
  bool one_point_per_body = true;
};

class PaperLaw final : public ContactLaw {
 public:
  explicit PaperLaw(const PaperLawOptions& options = {}) : options_(options) {}

  void prepare(std::vector<ContactPoint>& points, const ContactTerms& terms) const noexcept override;
  [[nodiscard]] bool accept(std::span<ContactPoint>, const ContactTerms&,
                            std::span<const Vec3d>) const noexcept override {
    return true;
  }
  void commit(std::span<ContactPoint>, const ContactTerms&, std::span<const Vec3d>) const noexcept override {}

 private:
  PaperLawOptions options_;
};

}  // namespace murosimf::collision
