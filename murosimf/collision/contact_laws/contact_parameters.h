/// contact_parameters.h - stiffness and damping of contact points from what rests on them and the pair of materials.
///
///     k = F / (n_c delta_s),   F = max(m_w g0, p A),   d = 2 sqrt(k m_p)     laws that are implicit
///     k = m_l g0 / (n_c max(delta_s, 0.4 mm)),         d = sqrt(k m_p)       explicit laws
///     kt = k,   ct = d / 2
///
/// delta_s is the static deflection of the pair of materials: how far the weight on Earth, g0 = 9.80665 m/s^2, presses the points in.
/// A body without joints of area A, the mean face of the box about it, carries at least p = 0.5 kPa (the project's choice; kid21's soles have 1.6 kPa): else a light crate would give way
/// under whatever stands on it.
/// n_c points share the weight; m_p = m / (n_c / 2) is the mass at each, since what lands meets the ground with half of
/// its points. With the ground m = m_w = m_l is the mass of the entity. Between two bodies m = m_a m_b / (m_a + m_b), m_w is the
/// heavier one, which may rest upon the other, and m_l the lighter one. Two that both have joints are as under
/// explicit laws: what moves at a point is a limb, and its mass is not known here. So are those on the ground whose
/// joints move as told (ground_contact.h).
///
/// Nothing of that depends on the step: shorter steps approach the motion of one model. A contact oscillates with sqrt(g0 / (2
/// delta_s)), 221 rad/s at 0.1 mm whatever the weight, critically damped; longer steps than that resolves are dead and stable.
/// A stack of N cubes of edge h stands on springs as long as N^3 < 7.837 h / (4 delta_s), about: 11 cubes of 10 cm at 0.1 mm, and of 12,
/// which are at the limit, none that has been touched (scene_file/unsteady_stacks.h; Greenhill,
/// "Determination of the greatest height consistent with stability", Proc. Cambridge Phil. Soc. 4, 1881).
/// 0.4 mm under explicit laws: the project's prototype stood and walked with it on a robot of 4.3 kg (k = 13 kN/m, d = 120 N
/// s/m) at 1 ms.
///
/// Round bodies bounce with the restitution e of the pair: by an impulse under implicit laws (bounce.h), on a spring and damper
/// that cannot pull under explicit ones (first zero of its force):
///
///     e = exp(-(z/w) (pi - atan2(2 z w, w^2 - z^2))),   w = sqrt(1 - z^2),  z = d / (2 sqrt(k m))
///
/// Source: Schwager and Poeschel, "Coefficient of restitution and linear-dashpot model revisited", Granular Matter 9
/// (2007), eq. for the force-zero condition. Steps must resolve such a bounce, so there k <= 0.15 m / dt^2: it lasts for eight
/// steps and more. Semi-implicit Euler gets another decay and frequency than the spring has; k and d are therefore those
/// with which the trace and the determinant of its step, 2 - dt^2 k/m - dt d/m and 1 - dt d/m, are those of the exact
/// flow, 2 E cos(w dt) and E^2 with E = exp(-zeta omega dt) (pole matching; Franklin, Powell, Workman, "Digital Control of
/// Dynamic Systems", 3rd ed., chapter 6). What is left is where in a step the bounce begins: e scatters by 5 % at dt^2
/// k/m = 0.15 and e = 0.8. theta is 0 for such a spring, 1 for all else.
#pragma once

#include "murosimf/collision/contact.h"
#include "murosimf/model/material.h"
#include "murosimf/model/model.h"

namespace murosimf::collision {

/// Restitution of a damped spring with damping ratio z in [0, 1).
[[nodiscard]] double restitution(double z);
/// Damping ratio in [0, 1) with restitution `e`; restitutions below 0.15 give the largest ratio, 0.95.
[[nodiscard]] double damping_ratio(double e);

/// What the constants follow from besides models and surfaces.
struct ContactConditions {
  double dt = 1e-3;          ///< [s] of the motion step: only bounces under explicit laws depend on it
  bool implicit_law = true;  ///< the law is implicit in the velocity after the step
};

/// Constants for contacts of `model` with the ground or what stands on it for good.
[[nodiscard]] ContactParameters contact_parameters(const Model& model, const PairSurface& pair,
                                                   const ContactConditions& conditions);
/// Constants for contacts of two models that move. One without mass can only be moved kinematically and does not count.
[[nodiscard]] ContactParameters contact_parameters(const Model& a, const Model& b, const PairSurface& pair,
                                                   const ContactConditions& conditions);

/// The same contact for a step of `dt` [s] that is explicit: its spring as soft as such a step bears.
[[nodiscard]] ContactParameters for_explicit_step(const ContactParameters& parameters, double dt);

}  // namespace murosimf::collision
