/// localize.h - algorithm: walks a round on the field and estimates its pose from its camera (paper 7.1).
///
/// Between two pictures particles move by dead_reckoning.h, with a picture they are weighed by line_points.h as
/// described in particle_filter.h. The robot walks by its own estimate. The camera's pose is that of camera_pose.h at the time of the
/// picture's arrival: the latency of the camera must be negligible.
///
/// `pose_estimate` and `pose_spread` are columns like all others. The particles are not part of the state hash, like the
/// frames that they come from: they are derived from readings, and drawn for observers.
/// The start must be known roughly (ParticleFilterOptions::prior): a field looks the same from both of its halves.
#pragma once

#include <vector>

#include "murosimf/model/properties.h"
#include "murosimf/soccer/camera_pose.h"
#include "murosimf/soccer/line_points.h"
#include "murosimf/soccer/particle_filter.h"
#include "murosimf/world/algorithm.h"

namespace murosimf::soccer {

/// Output of `localize` besides numbers.
struct Particles {
  std::vector<soccer::Particle> all;
  std::vector<soccer::LinePoint> points;  ///< of the last picture, those that were used
  double heading = 0;                     ///< [rad] of the inertial sensor in the last step; NaN: none yet
  std::uint64_t frame = 0;                ///< number of the last picture
};
void append_hash(Hasher& hasher, const Particles& particles);
inline void state(StateArchive& archive, Particles& p) { archive(p.all, p.points, p.heading, p.frame); }

inline constexpr Property<Particles> possible_poses{
    {"possible_poses", "-", "field", "poses that a robot that localizes itself takes for possible", Scope::sensor}};

struct LocalizeOptions {
  Markings markings;       ///< of the field
  Vec3d start;             ///< [m, m, rad] given start pose
  std::vector<Vec3d> way;  ///< [m] of its round, on the field; none: it stands
  double speed = 0.2;      ///< [m/s]
  std::string camera = "camera";
  std::uint64_t seed = 1;
  soccer::LineScan scan{};
  std::size_t most_points = 80;  ///< of a picture
  soccer::ParticleFilterOptions filter{};
};

class Localize final : public Algorithm {
 public:
  /// Throws SetupError if the robot has no such camera, or not the sensors that camera_pose.h needs.
  Localize(Setup& setup, const LocalizeOptions& options);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override;
  void reseed(std::uint64_t seed) override { filter_.reseed(seed); }
  void step(const Instant& instant) noexcept override;

  static constexpr double rate_hz = 20;

 private:
  void look(std::uint64_t number) noexcept;
  void walk() noexcept;

  LocalizeOptions options_;
  const sensors::CameraFrame& frame_;
  soccer::CameraPoseEstimator body_;
  soccer::LineDistanceField lines_;
  soccer::ParticleFilter filter_;
  std::vector<soccer::LinePoint> seen_;
  const Vec3d& velocity_;  // [m/s, m/s, rad/s] of the gait
  Vec3d& command_;         // [m/s, m/s, rad/s]
  Vec3d &estimate_, &spread_;
  double& waypoint_;
  Particles& particles_;
};

}  // namespace murosimf::soccer
