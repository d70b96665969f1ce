/// contact_parameters.h - stiffness and damping of contact points from the masses that meet, their weight and the step.
///
///     k = max(m_w g / (n_c * 0.4 mm), c m_p / dt^2)  laws that are implicit in the velocity after the step
///     k = m_l g / (n_c * 0.4 mm)                     explicit laws
///     d = 2 zeta sqrt(k m_p),  kt = k,  ct = d / 2
///
/// n_c points share the weight; m_p = m / (n_c / 2) is the mass at each, since what lands meets the ground with half of its
/// points. With the ground m = m_w = m_l is the mass of the entity. Between two bodies m = m_a m_b / (m_a + m_b), m_w is the
/// heavier one, which may rest upon the other, and m_l the lighter one. Two that both have joints are as under
/// explicit laws: what moves at a point is a limb, and its mass is not known here. So are those on the ground whose
/// joints move as told (ground_contact.h).
///
/// First term: points sink 0.4 mm under the weight. Source: the project's prototype, which stood and walked with it on a robot
/// of 4.3 kg (k = 13 kN/m, d = 120 N s/m), also explicitly at 1 ms.
/// Second term: omega dt = sqrt(c), so that steps resolve an oscillation of the contact, and the compliance 1 / (dt
/// b_n) of a point (island_solver.h) is of the order of its 1 / m_p, so that sweeps still converge. c = 1/4 with the
/// ground: kid21 then climbs as with ever stiffer ground. c = 1 between bodies: softer contact buckles columns. A
/// stack of N cubes of mass m and edge h stands on springs as long as N^3 < 7.837 K / (m g h), K = k n_c (h/2)^2
/// (Greenhill, "Determination of the greatest height consistent with stability", Proc. Cambridge Phil. Soc. 4, 1881):
/// 7 with the first term alone, 27 at 1 ms with the second.
///
/// zeta = 0.5. For a round body zeta follows from the restitution e of the pair, from the closed form of a damped spring
/// that cannot pull (first zero of its force):
///
///     e = exp(-(z/w) (pi - atan2(2 z w, w^2 - z^2))),   w = sqrt(1 - z^2)
///
/// Source: Schwager and Poeschel, "Coefficient of restitution and linear-dashpot model revisited", Granular Matter 9
/// (2007), eq. for the force-zero condition. A bounce must be resolved by steps, so round bodies have the spring of explicit
/// laws under every law, and k <= 0.15 m / dt^2: a bounce lasts for eight steps and more. Semi-implicit Euler gets
/// another decay and frequency than the spring has; k and d are therefore those with which the trace and the
/// determinant of its step, 2 - dt^2 k/m - dt d/m and 1 - dt d/m, are those of the exact flow, 2 E cos(w dt) and E^2
/// with E = exp(-zeta omega dt) (pole matching; Franklin, Powell, Workman, "Digital Control of Dynamic Systems", 3rd
/// ed., chapter 6). What is left is where in a step the bounce begins: e scatters by 5 % at dt^2 k/m = 0.15 and e =
/// 0.8. theta is 0 for what bounces, 1 for all else.
#pragma once

#include "murosimf/collision/contact.h"
#include "murosimf/model/material.h"
#include "murosimf/model/model.h"

namespace murosimf::collision {

/// Restitution of a damped spring with damping ratio z in [0, 1).
[[nodiscard]] double restitution(double z);
/// Damping ratio in [0, 1) with restitution `e`; restitutions below 0.15 give the largest ratio, 0.95.
[[nodiscard]] double damping_ratio(double e);

/// Whether steps of dt [s] are short enough for a bounce of `mass` [kg] on `stiffness` [N/m]; it is dead if not.
[[nodiscard]] bool resolves_bounce(double stiffness, double mass, double dt);

/// What the constants follow from besides models and surfaces.
struct ContactConditions {
  double gravity = 9.81;     ///< [m/s^2] magnitude
  double dt = 1e-3;          ///< [s] of the motion step
  bool implicit_law = true;  ///< the law is implicit in the velocity after the step
};

/// Constants for contacts of `model` with the ground or what stands on it for good.
[[nodiscard]] ContactParameters contact_parameters(const Model& model, const PairSurface& pair,
                                                   const ContactConditions& conditions);
/// Constants for contacts of two models that move. One without mass can only be moved kinematically and does not count.
[[nodiscard]] ContactParameters contact_parameters(const Model& a, const Model& b, const PairSurface& pair,
                                                   const ContactConditions& conditions);

/// The same contact for a step of `dt` [s] that is explicit: its spring as soft as such a step bears, unless it bounces.
[[nodiscard]] ContactParameters for_explicit_step(const ContactParameters& parameters, double dt);

}  // namespace murosimf::collision
