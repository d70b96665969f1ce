/// compare_metrics.h - measures of one run of a robot, and how far they are from a more detailed one (docs/compare.md).
#pragma once

#include <string>
#include <vector>

#include "murosimf/dynamics/motion_recorder.h"
#include "murosimf/studies/posture_events.h"

namespace murosimf::studies {

/// [m] Differences of shorter ways are given as shares of this one. 20 % of it, 5 cm, is what a ball or a robot may end off where it
/// hardly moves: less than the radius of a ball.
inline constexpr double shortest_way = 0.25;
/// [m] A walker sways by less: its way is that of places so far apart.
inline constexpr double swaying = 0.1;

/// [m] Horizontal length of a way: of places that are at least `apart` [m] from the one before, and of the last one.
[[nodiscard]] double length_of_way(const std::vector<Vec3d>& places, double apart);

struct Measures {
  double path_length = 0;  ///< [m] horizontal way of the base, without its swaying
  Vec3d end;               ///< [m] where the base was last
  std::vector<PostureEvent> events;
  int falls = 0;           ///< how often it went down after it had been up
  double slip = 0;         ///< [m] of both soles
  double rate = 0;         ///< [rad/s] rms of the torso's angular rate
  double clearance = 0;    ///< [m] how high a sole came at most
  double peak_torque = 0;  ///< [N m | N] largest mean over a sample; 0 if the level has none
  std::string peak_joint;  ///< where; empty if the level has no torques
};

[[nodiscard]] Measures measures_of(const dynamics::MotionRecord& record);

/// [s] When the torso, before its first fall, leaned over 15 degrees for good: the center of mass of a humanoid robot passes the
/// edge of its soles there. Infinity: it does not fall.
[[nodiscard]] double fall_begins(const dynamics::MotionRecord& record);

/// What was recorded up to `end` [s].
[[nodiscard]] dynamics::MotionRecord part_until(const dynamics::MotionRecord& record, double end);

/// Of all other entities, or of all sensors, the one that is off by most.
struct OfAnother {
  double value = 0;
  std::string name{};  ///< empty: none is off
};

/// How far a run is from the reference, sample by sample until the shorter one ends.
struct Deviations {
  double path_length =
      0;  ///< [1] difference of the lengths, as a share of the reference's (of shortest_way if that is shorter)
  double path = 0;         ///< [m] largest distance from the reference's path, whenever it was there; horizontal
  double center_mean = 0;  ///< [m] distance of the centers of mass at the same time, mean
  double center_max = 0;   ///< [m] the same, largest
  double pitch = 0;        ///< [rad] rms of the difference
  double roll = 0;         ///< [rad] rms of the difference
  double rate = 0;         ///< [rad/s] rms of the length of the difference
  double slip = 0;         ///< [m/s] difference of the mean rates: slip per simulated second
  double clearance = 0;    ///< [m] difference of the largest clearances
  // Of other entities (compare_outcome.h), as shares of what the reference has there:
  OfAnother others_way{};    ///< [1] difference of the lengths of their ways (of shortest_way at least)
  OfAnother others_end{};    ///< [1] distance of their last places, of the same
  OfAnother others_speed{};  ///< [1] difference of their peak speeds (of slowest_speed at least)
  // What inertial sensors show (compare_sensors.h), likewise:
  OfAnother accelerometer{};       ///< [1] difference of the rms of |a| - g
  OfAnother accelerometer_peak{};  ///< [1] of its largest size
  OfAnother gyroscope{};           ///< [1] of the rms of |w|
  double torque = 0;  ///< [1] difference of peak torques as a share of the reference's; NaN if one level knows none
};

[[nodiscard]] Deviations deviations_of(const dynamics::MotionRecord& record, const dynamics::MotionRecord& reference);

}  // namespace murosimf::studies
