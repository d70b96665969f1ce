/// gait_seed.h - derives the numbers of a walk from a robot: from its legs, its masses and its servos.
///
/// From the legs, those of kid21 scaled by the leg's length (lengths by l, times by sqrt(l)); of a model, steps are 0.7 times as long in
/// time and the sway does not lead. From the masses, at rest between two steps:
///     setback    such that the common center of mass is over the middle between the soles, but from the ankles no farther than
///                0.2 tau/(m g), tau the largest torque of an ankle's pitch joint
///     sway       of the hips, such that the center of mass sways by b (1 - 1/cosh(w T/4)), w = sqrt(g / z_c): the periodic orbit of
///                the linear inverted pendulum; b half the distance of the soles, z_c the center of mass above them
/// and with m the mass, k the position gain of a hip's roll joint, l thigh and shin:
///     droop d = m g b / k     hip_roll = d, at most 0.06 rad     lift = 0.045 l + 2 b d, at most 0.19 l: the swinging foot hangs by 2 b d
/// Source: Kajita et al., "The 3D Linear Inverted Pendulum Mode", IROS 2001, for the orbit; docs/robots.md, "What walking needs", for
/// what was measured.
#pragma once

#include "murosimf/locomotion/gait.h"
#include "murosimf/model/option.h"

namespace murosimf::locomotion {

/// From the legs alone, for a robot without masses: z_c is 1.072 times the height of the hips, b half their distance. Strides are
/// limited to the legs' reach (gait_limits.h).
[[nodiscard]] WalkParameters seeded_parameters(const std::array<Leg, 2>& legs);

/// Of a model: `given` (walk_options.h) precedes the file's own numbers (given_walk), these precede derived ones. Then strides are
/// limited by the reach of legs and the rates of joints (gait_limits.h). Throws SetupError if the model has no legs to walk with or an
/// option is wrong.
[[nodiscard]] WalkParameters walk_parameters(const Model& model, const OptionValues& given);

/// The same with nothing given. The model keeps them for all robots of a team.
[[nodiscard]] WalkParameters seeded_parameters(const Model& model);

/// [rad] Angle by which the swinging side sinks, d from above, where the robot walks with these numbers; 0: its servos do not yield.
[[nodiscard]] double hip_droop(const Model& model);

}  // namespace murosimf::locomotion
