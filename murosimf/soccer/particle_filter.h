/// particle_filter.h - Monte Carlo localization: estimates the pose of a robot on a field from the lines that it sees.
///
/// Each particle is a possible pose. One step: move all by the odometry, each with its own errors; weigh each by
/// how well the points that were seen on lines lie on the field's lines from there; draw the next particles by weight.
///
/// With d_i the distance of point i from the nearest line, seen from the particle, and r_i its distance from the robot,
///
///     log w = c sum_i log(m + (1 - m) exp(-d_i^2 / (2 s_i^2)))         s_i = s_0 + s_2 r_i^2
///
/// s_2 r^2 is the error by a wrong lean of the camera; m limits the effect of points that are no line points. Errors of one
/// picture are correlated, so c counts its points as at most `independent_points`. Particles are drawn by low-variance
/// resampling when the effective number of them, 1 / sum w^2, falls below half.
/// Source: Dellaert, Fox, Burgard, Thrun, "Monte Carlo localization for mobile robots", ICRA 1999; likelihood field, low-
///         variance sampler: Thrun, Burgard, Fox, Probabilistic Robotics (2005), ch. 6.4 and 4.3.4; effective number:
///         Liu, "Metropolized independent sampling", Statistics and Computing 6 (1996).
/// Limits: a field looks the same from its other half: the prior must contain the half. Nothing is injected to find a robot
///         again that was carried away.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "murosimf/math/random.h"
#include "murosimf/soccer/line_distance_field.h"
#include "murosimf/soccer/line_points.h"
#include "murosimf/soccer/planar.h"

namespace murosimf::soccer {

struct Particle {
  Vec3d pose;         ///< [m, m, rad] on the field
  double weight = 0;  ///< [1] their sum is 1
};

struct ParticleFilterOptions {
  int particles = 400;
  Vec3d prior{0.5, 0.5, pi / 6};       ///< [m, m, rad] standard deviations around the start; x and y are the robot's
  double way_noise = 0.06;             ///< [m/sqrt(m)] of the place after a meter
  double turn_noise = 0.05;            ///< [rad/sqrt(rad)] of the heading after a radian
  Vec3d time_noise{0.02, 0.02, 0.02};  ///< [m/sqrt(s), m/sqrt(s), rad/sqrt(s)] independent of the motion
  double point_noise = 0.04;           ///< [m] s_0
  double lean_noise = 0.03;            ///< [1/m] s_2
  double misread = 0.1;                ///< [1] m
  double independent_points = 4;
};

struct PoseEstimate {
  Vec3d pose;    ///< [m, m, rad] mean of the particles near the one that has most weight around it
  Vec3d spread;  ///< [m, m, rad] their standard deviations
};

class ParticleFilter {
 public:
  /// Keeps only the options between steps: particles belong to the caller, of constant number. `seed` and `name` determine
  /// all random numbers; those of a step are addressed by its number, so that each step needs another one.
  ParticleFilter(const ParticleFilterOptions& options, std::uint64_t seed, const std::string& name);

  /// Switches to the random numbers of another seed.
  void reseed(std::uint64_t seed) noexcept;
  /// Returns particles around `start`.
  [[nodiscard]] std::vector<Particle> scatter(const Vec3d& start) const;
  /// Moves the particles. `step_pose`: the robot's motion in its own frame (dead_reckoning.h), in a time `dt` [s].
  void move(std::span<Particle> particles, const Vec3d& step_pose, double dt, std::uint64_t step) const noexcept;
  /// Multiplies the weights by the likelihood of the points, and normalizes them.
  void weigh(std::span<Particle> particles, std::span<const LinePoint> points, const LineDistanceField& lines) noexcept;
  /// Draws particles by weight if few of them count. True if it did.
  bool resample(std::span<Particle> particles, std::uint64_t step) noexcept;

 private:
  [[nodiscard]] double log_likelihood(const Vec3d& pose, std::span<const LinePoint> points,
                                      const LineDistanceField& lines) const noexcept;

  ParticleFilterOptions options_;
  RandomStream scatter_, motion_, draw_;
  std::vector<double> logs_;        // by particle
  std::vector<double> deviations_;  // [m] by point
  std::vector<Particle> drawn_;
};

/// The cluster begins with the heaviest particle and moves to the mean within 0.5 m and 30 degrees around it, three times.
[[nodiscard]] PoseEstimate estimate(std::span<const Particle> particles) noexcept;

}  // namespace murosimf::soccer
