/// contact_parameters.h - stiffness and damping of contact points from the weight that they carry.
///
///     k = m g / (n_c * 0.4 mm)       n_c points share the weight and sink 0.4 mm under it
///     d = 2 zeta sqrt(k m_p)         m_p = m / (n_c / 2): a landing robot meets the ground with half of its points
///     kt = k,  ct = d / 2
///
/// Source of this rule and of 0.4 mm: the project's prototype, which stood and walked with it on a robot of 4.3 kg
/// (k = 13 kN/m, d = 120 N s/m). zeta = 0.5 for robots. For a round body zeta follows from the restitution e of the
/// pair, from the closed form of a damped spring that cannot pull (first zero of its force):
///
///     e = exp(-(z/w) (pi - atan2(2 z w, w^2 - z^2))),   w = sqrt(1 - z^2)
///
/// Source: Schwager and Poeschel, "Coefficient of restitution and linear-dashpot model revisited", Granular Matter 9
/// (2007), eq. for the force-zero condition.
#pragma once

#include "murosimf/collision/contact.h"
#include "murosimf/model/material.h"
#include "murosimf/model/model.h"

namespace murosimf::collision {

/// Restitution of a damped spring with damping ratio z in [0, 1).
[[nodiscard]] double restitution(double z);
/// Damping ratio in [0, 1) with restitution `e`; restitutions below 0.15 give the largest ratio, 0.95.
[[nodiscard]] double damping_ratio(double e);

/// What a model touches: the ground carries it with all points of its soles, another body with four at most.
enum class Partner { ground, body };

/// Constants for contacts of `model` with a surface. `gravity` [m/s^2] magnitude; `dt` [s] of the motion step.
[[nodiscard]] ContactParameters contact_parameters(const Model& model, const PairSurface& pair, double gravity,
                                                   double dt, Partner partner = Partner::ground);

}  // namespace murosimf::collision
