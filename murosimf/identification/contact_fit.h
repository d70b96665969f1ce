/// contact_fit.h - numbers of a pair of materials from recorded runs of a body: rolls, slides and drops.
///
/// A roll or slide loses speed at a constant rate a, and to the air by k v^2 (murosimf/air), until it stops. From dv/dt = -a - k v^2,
///
///     s(t) = v0 t - a t^2 / 2        with air: s(t) = ln(cos(p - b t) / cos p) / k,  b = sqrt(a k),  p = atan(v0 sqrt(k / a))
///
/// up to t = v0 / a, with air p / b, and stays. Least squares give s(0), v0 and a: without air and stop this is a parabola. A
/// roll has a = g c / (1 + J / (m r^2)) with the rolling coefficient c and the moment of inertia J of the ball, a slide a = g mu.
///
/// A drop bounces with its restitution e: from bounce to bounce its height is a parabola of curvature -g, of which least squares
/// find the other two numbers. Where two parabolas meet is a bounce, whatever the height of the floor; e is the ratio of their speeds
/// there, in least squares over all bounces, as sqrt(h_n+1 / h_n) of heights h_n is. Air bends the parabolas by its drag, to first order in k.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "murosimf/math/vec3.h"

namespace murosimf::identification {

/// A recorded run of one body.
struct Track {
  std::string name;           ///< for messages
  std::vector<double> times;  ///< [s] ascending
  std::vector<Vec3d> places;  ///< [m] at these times; z upwards
};

/// A fitted number.
struct Estimate {
  double value = 0;
  double error = 0;     ///< one standard deviation
  double residual = 0;  ///< [m] root mean square of the residuals of the places
};

/// Deceleration of a body on level ground: `value` is a [m/s^2].
struct Braking : Estimate {
  double speed = 0;  ///< [m/s] at the first sample
  Vec3d direction;   ///< [1] of its way, in x and y
};

/// `drag` k [1/m] of the air. Throws SetupError if the track is too short, or does not slow down.
[[nodiscard]] Braking fit_braking(const Track& track, double drag);

/// The restitution of a body that falls along z and bounces.
struct Bouncing : Estimate {
  int bounces = 0;
};

/// `gravity` g [m/s^2], `drag` k [1/m] of the air. Throws SetupError if it does not bounce, has too few samples in a flight, or
/// gains energy.
[[nodiscard]] Bouncing fit_bounces(const Track& track, double gravity, double drag);

/// The mean of one number from several runs. Its error is the scatter of the runs, or that which follows from their own errors,
/// whichever is larger.
[[nodiscard]] Estimate mean_of(std::span<const Estimate> runs);
/// Error of that mean from the errors of the single runs alone.
[[nodiscard]] double known_error(std::span<const Estimate> runs);

/// Friction or rolling by direction: c (1 - g cos a), a from the lean of the pile to the way; g is friction_anisotropy
/// or rolling_anisotropy (docs/scenes.md).
struct Lean {
  double mean = 0;        ///< c [1]
  double anisotropy = 0;  ///< g [1]
  Vec3d direction;        ///< [1] in which the pile leans, in x and y
};

/// Fits the values of runs in several directions. Nothing if their directions do not separate c from g: at least three that do not lie
/// within half a turn.
[[nodiscard]] std::optional<Lean> fit_lean(std::span<const Braking> runs);

}  // namespace murosimf::identification
