/// trot.h - algorithm: a four-legged robot trots with a walking velocity; joint targets for each control cycle.
///
/// Diagonal pairs of feet step together: with the phase ph in [0, 2 pi), front left and hind right stand during (0, pi).
/// A foot with n as its place at rest, seen from the middle of the feet, follows the ground along its stride (stride.h):
///
///     foot = n + xi Ts (v + w x n) + lift hz z         Ts = T (pi + 2 d)/(2 pi)
///
/// in the frame of the base, which stays level. At rest all feet stand straight below their hips, shifted such that the
/// center of mass is above their middle. Legs bend by leg.h; three hinges place a foot, and its orientation is free.
///
/// Reads `walk_command`; keeps its state in gait_phase, gait_amplitude and gait_velocity; writes `joint_target` of all
/// joints (others are held at `rest_position`).
/// Source:  the pattern is that of animals (Hildebrand, "Symmetrical gaits of horses", Science 150, 1965); own numbers.
/// Limits:  no feedback; the center of mass is taken at rest.
#pragma once

#include <vector>

#include "murosimf/locomotion/gait_clock.h"
#include "murosimf/locomotion/leg.h"
#include "murosimf/world/algorithm.h"

namespace murosimf::locomotion {

/// For legs of 0.24 m: tuned on models/quadruped.xml, at all dynamic levels and in all directions; periods of
/// 0.35 s and more lift than necessary keep soft feet and slow servos from scuffing.
struct TrotParameters {
  double period = 0.35;            ///< [s] T, two steps
  double lift = 0.045;             ///< [m] hz, height of the swinging feet
  double hip_height = 0.2106;      ///< [m] hips above the soles: knees bent by 1 rad
  double double_support = 0.25;    ///< [1] share of the period with all feet down
  Vec3d shift;                     ///< [m] of all feet, horizontal
  Vec3d slew{0.5, 0.3, 2};         ///< [m/s^2, m/s^2, rad/s^2] of the walking velocity
  Vec3d fastest{0.35, 0.15, 0.8};  ///< [m/s, m/s, rad/s] commands beyond are clipped
};

/// Parameters for a robot with these legs: lengths scaled by theirs, times and speeds by its root.
[[nodiscard]] TrotParameters seeded_trot(const Model& model, const std::array<Leg, 4>& legs);

/// Joint positions [rad] of the four legs, in the order of find_four_legs and of their joints.
struct TrotPose {
  std::array<std::array<double, most_hinges>, 4> q{};
  bool reachable = true;
};

/// As gait_pose (gait.h).
[[nodiscard]] TrotPose trot_pose(const std::array<Leg, 4>& legs, const TrotParameters& parameters, double phase,
                                 double amplitude, const Vec3d& velocity, const TrotPose& start) noexcept;
[[nodiscard]] TrotPose home_pose(const std::array<Leg, 4>& legs) noexcept;

class Trot final : public Algorithm {
 public:
  /// `command` [m/s, m/s, rad/s]: walk_command until another value is set. Throws SetupError if the model does not have
  /// four legs (leg.h).
  explicit Trot(Setup& setup, const Vec3d& command = {});
  Trot(Setup& setup, const Vec3d& command, const TrotParameters& parameters);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;

  static constexpr double rate_hz = 100;

 private:
  void write_targets(const TrotPose& start) noexcept;

  std::array<Leg, 4> legs_;
  TrotParameters parameters_;
  GaitClock clock_;
  std::vector<double> rest_;  // [rad | m] by object
  std::span<double> target_;  // [rad] by object
};

}  // namespace murosimf::locomotion
