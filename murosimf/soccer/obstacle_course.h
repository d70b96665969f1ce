/// obstacle_course.h - algorithm: crosses the field without touching the obstacles that its camera sees (paper Fig. 8).
///
/// Blobs of the obstacles' color become obstacles on the ground (obstacle_map.h) in the frame of the field, where the
/// robot localizes itself by dead_reckoning.h alone, from the start pose of the scene's file. With every picture the
/// shortest clear way is planned anew (tangent_path.h); the robot walks to the point on it that is `look_ahead` away. If there
/// is no way it tries with less clearance, and stands still if there is none either.
/// The place where it crosses the goal line is free; it stops a little behind it.
/// Source: pursuit of a point on the way: Coulter, "Implementation of the pure pursuit path tracking algorithm",
///         CMU-RI-TR-92-01 (1992).
#pragma once

#include <string>
#include <vector>

#include "murosimf/model/properties.h"
#include "murosimf/soccer/camera_pose.h"
#include "murosimf/soccer/obstacle_map.h"
#include "murosimf/soccer/tangent_path.h"
#include "murosimf/world/algorithm.h"

namespace murosimf::soccer {

/// Output of `obstacle_course` besides numbers; like the frames that it comes from it is not part of the state hash.
struct Course {
  soccer::ObstacleMap obstacles;  ///< on the field, by the robot's own pose estimate
  std::vector<Vec3d> way;         ///< [m] on the field, from the robot to its goal
  double heading = 0;             ///< [rad] of the inertial sensor in the last step; NaN: none yet
  std::uint64_t frame = 0;        ///< number of the last picture
};
void append_hash(Hasher& hasher, const Course& course);
inline void state(StateArchive& archive, Course& course) {
  archive(course.obstacles, course.way, course.heading, course.frame);
}

inline constexpr Property<Course> planned_course{
    {"planned_course", "-", "field", "obstacles that a robot has seen, and its way between them", Scope::sensor}};

struct ObstacleCourseOptions {
  Vec3d start;                   ///< [m, m, rad] given start pose
  double goal_x = 3;             ///< [m] of the line to cross
  double half_width = 2;         ///< [m] of the field
  double speed = 0.15;           ///< [m/s]
  double obstacle_radius = 0.1;  ///< [m] by the rules or a measurement
  double robot_radius = 0.15;    ///< [m] of the circle around it, swaying included
  double clearance = 0.15;       ///< [m] besides
  double farthest = 2.5;         ///< [m] of obstacles that are used
  double look_ahead = 0.3;       ///< [m]
  int fewest_sightings = 2;      ///< of an obstacle that counts
  soccer::ColorClass color{.hue = 320, .hue_reach = 25, .least_saturation = 0.5, .least_value = 0.2};  ///< magenta
  std::string camera = "camera";
};

class ObstacleCourse final : public Algorithm {
 public:
  /// Throws SetupError if the robot has no such camera, or not the sensors that camera_pose.h needs.
  ObstacleCourse(Setup& setup, const ObstacleCourseOptions& options);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;

  static constexpr double rate_hz = 20;

 private:
  void look() noexcept;
  void plan() noexcept;
  void plan(double clearance) noexcept;
  void walk() noexcept;

  ObstacleCourseOptions options_;
  const sensors::CameraFrame& frame_;
  soccer::CameraPoseEstimator body_;
  soccer::BlobFinder blobs_;
  WayAround around_;
  std::vector<Disk> disks_;
  const Vec3d& velocity_;  // [m/s, m/s, rad/s] of the gait
  Vec3d& command_;         // [m/s, m/s, rad/s]
  Vec3d& pose_;            // [m, m, rad]
  Course& course_;
};

}  // namespace murosimf::soccer
