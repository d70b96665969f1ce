/// step_table.h - the steady walk as the robot's own sensors measure it: six signals over the phase of a step.
///
/// Signals are seen from the foot that stands and mirrored for the right one: xi_x, xi_y [m], y outward; pitch [rad] forward, roll
/// [rad] towards the foot that swings (while the left one stands: to the right, about +x); rates of roll and pitch [rad/s]. In each of the bins of a step, s_k = a + b_x v_x + b_y v_y + b_z w_z, with the walking
/// velocity, mirrored too. Between the middles of the bins it is linear.
///
/// Servos that follow their targets at once make another walk than servos that lag, so there are two tables: rigid and
/// compliant; `compliance`, 0 to 1, interpolates between them.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string_view>

#include "murosimf/math/vec3.h"

namespace murosimf::locomotion {

struct StepSignals {
  double forward = 0, outward = 0;       ///< [m] xi
  double pitch = 0, roll = 0;            ///< [rad]
  double roll_rate = 0, pitch_rate = 0;  ///< [rad/s]

  [[nodiscard]] std::array<double, 6> numbers() const { return {forward, outward, pitch, roll, roll_rate, pitch_rate}; }
};

inline constexpr std::size_t step_bins = 24, step_signals = 6, step_terms = 4;

/// [bin][signal][term]
using StepCourse = std::array<std::array<std::array<double, step_terms>, step_signals>, step_bins>;

struct StepTable {
  StepCourse rigid{}, compliant{};
};
using StepTablePtr = std::shared_ptr<const StepTable>;

inline constexpr std::array<std::string_view, step_signals> signal_names{"forward", "outward",   "pitch",
                                                                         "roll",    "roll_rate", "pitch_rate"};

/// `share` [1] of the step so far; `velocity` [m/s, m/s, rad/s] of the walk, y and z mirrored while the right foot stands.
[[nodiscard]] StepSignals steady_signals(const StepTable& table, double compliance, double share,
                                         const Vec3d& velocity) noexcept;

/// One instant of a walk, as above.
struct StepSample {
  double share = 0;
  Vec3d velocity;
  StepSignals signals;
};
/// The course with the least squares of errors; bins without samples are those of their neighbours.
[[nodiscard]] StepCourse fit_course(std::span<const StepSample> samples);

}  // namespace murosimf::locomotion
