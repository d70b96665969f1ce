/// paper_law.h - the contact law of the paper, eq. (4) and (5): `paper` at one point per body and ground, as there, and
/// `paper_multipoint` at every point.
///
///     f_n    = s_c depth n          approaching
///            = s_b s_c depth n      separating
///     f_fric = -s_mu |f_n| v_t      n_fric = -s_nu |f_n| w
///
/// Source:  paper 5.3. s_mu, s_nu and s_b are numbers of the pair of materials, s_c is its stiffness.
/// Differs: the paper leaves open the signs (friction must oppose the motion), which velocity rubs (only the
///          tangential part; the whole would damp the normal direction too), and which point stands for the pair
///          (the deepest). One point is no support polygon: a box rocks on it.
///          With `bounded`, our addition, v_t and w are those that the step ends with: friction can stop what it rubs, not turn
///          it back. By the letter (`bounded` off) they are those at its beginning: with an effective mass m at the point,
///          velocities grow from step to step where dt s_mu |f_n| / m exceeds 2, as under any hard impact of a light limb.
/// Limits:  friction is viscous, so on a slope of angle a everything creeps with tan(a)/s_mu: a property of the law.
#pragma once

#include <optional>

#include "murosimf/collision/contact_laws/contact_law.h"

namespace murosimf::collision {

/// Empty: of the pair of materials.
struct PaperLawOptions {
  std::optional<double> rebound;        ///< [1] s_b
  std::optional<double> friction;       ///< [s/m] s_mu
  std::optional<double> spin_friction;  ///< [m s] s_nu
  bool bounded = true;                  ///< friction by the velocity after the step
  bool one_point_per_body = true;
};

/// Normal force and dampers of one contact.
struct PaperForce {
  double normal = 0;  ///< [N] |f_n|
  double rub = 0;     ///< [N s/m] s_mu |f_n|
  double spin = 0;    ///< [N m s] s_nu |f_n|
};

/// Of a contact at the depth of `contact`, by its velocity, in a step of dt [s]; bounded where the contact began deep (depenetration.h).
[[nodiscard]] PaperForce paper_force(const ContactPoint& contact, const ContactParameters& parameters, double dt,
                                     const PaperLawOptions& options) noexcept;

class PaperLaw final : public ContactLaw {
 public:
  explicit PaperLaw(const PaperLawOptions& options = {}) : options_(options) {}

  void prepare(std::vector<ContactPoint>& points, const ContactTerms& terms) const noexcept override;
  [[nodiscard]] bool accept(std::span<ContactPoint>, const ContactTerms&,
                            std::span<const Vec3d>) const noexcept override {
    return true;
  }
  void commit(std::span<ContactPoint> points, const ContactTerms& terms,
              std::span<const Vec3d> next_velocity) const noexcept override;

 private:
  PaperLawOptions options_;
};

}  // namespace murosimf::collision
