/// gait_feedback.h - how a walk responds to deviations from the steady walk: numbers, and where they come from.
///
/// Signals (step_table.h) are those of the divergent component of motion xi = c + v/omega, c the center of mass from the ankle that
/// stands. e is the deviation of xi from its steady course, less a dead zone; y counts outward, away from the other foot.
///
///     swinging foot   k e exp(omega T), T what is left of the step: where xi would be at its end      (capture point)
///     phase           1 - ky e_y + kx |e_x|, within its limits; the quickest where e_y is above hurry_at (step timing)
///     standing ankle  pitch: p d_pitch + d d_gyro_y + a e_x, roll likewise                             (center of pressure)
///     swinging sole   turned and moved back by a share of the tilt's deviation
///     standing hip    a share of the measured lag of its roll joint is added to its target             (droop)
///     strides         v + t instead of the velocity v; over each period of a mean velocity w by odometry, t += k (v - w) T (trim)
///     both feet       on a plane of the pitch s [rad, above 0 downhill], z -= x tan s and soles turned by s: the mean pitch of the
///                     standing sole, by attitude and encoders, less a dead zone, which is larger the less the servos yield (slope)
/// Source: Pratt et al., "Capture Point", Humanoids 2006; Takenaka et al., IROS 2009, and Englsberger et al., "Three-dimensional
/// bipedal walking control based on divergent component of motion", IROS 2013, for xi; Khadiv et al., "Walking control based on step
/// timing adaptation", IEEE T-RO 36 (2020), for timing, linear here. Numbers: found for kid21 by CMA-ES over gait and feedback at once.
#pragma once

#include <vector>

#include "murosimf/locomotion/gait_seed.h"
#include "murosimf/model/model.h"
#include "murosimf/model/option.h"

namespace murosimf::locomotion {

/// Defaults are those of kid21, with thigh and shin of 0.24 m.
struct GaitFeedback {
  // the gait itself at a speed
  double stride_gain = 0.96327;        ///< [1] of the strides
  double lean_per_speed = -0.20808;    ///< [rad s/m] of the pelvis, forward
  double setback_per_speed = 0.04198;  ///< [s] of the feet
  double sag = 0.20653;                ///< [1] of the lag of the standing hip's roll
  // feedback
  double foot_level = 0.43885;         ///< [1] of the tilt that the swinging foot undoes
  double ankle_pitch = 0.52203;        ///< [1] of the deviation of the pitch
  double ankle_pitch_rate = 0.040905;  ///< [s]
  double ankle_roll = 0.1721;          ///< [1]
  double ankle_roll_rate = 0.0082881;  ///< [s]
  double ankle_forward = 1.3991;       ///< [rad/m] of e_x
  double ankle_sideways = 2.0698;      ///< [rad/m] of e_y
  double step_forward = 0.79326;       ///< [1]
  double step_sideways = 0.34193;      ///< [1]
  double step_decay = 0.053458;        ///< [s] in which the offset of a foot that stands goes back
  double timing_forward = 1.3604;      ///< [1/m] of |e_x|
  double timing_sideways = 8.2033;     ///< [1/m] of e_y
  double hurry_at = 0.04;         ///< [m] of e_y: beyond, it falls over the standing foot, and only the next step helps
  double slowest = 0.80712;       ///< [1] of the phase
  double quickest = 1.9618;       ///< [1]
  double dead_zone = 0.0061561;   ///< [m] of e
  double rigid_dead_zone = 0.02;  ///< [m] more where joints follow their targets at once: steps jar such a robot
  double most_forward = 0.12477;  ///< [m] of a foot's offset
  double most_sideways = 0.11787;  ///< [m]
  double most_inward = 0.02;       ///< [m] the same, towards the foot that stands
  double offset_speed = 0.60624;   ///< [m/s] of an offset
  double smoothing = 0.0091649;    ///< [s] of the rate of the center of mass, from encoders
  double omega = 7.3899;           ///< [1/s] of the pendulum
  double most_deviation = 0.3;     ///< [m] of e: what is larger counts as this
  double compliant_lag = 0.03;     ///< [rad] mean lag of the legs' joints at which their servos count as compliant
  double slope = 1;                ///< [1] of the ground's slope that the feet follow, so that the robot stays upright
  double trim = 0;                 ///< [1/s] k: strides make up for what the velocity by odometry lacks of the command
  // standing
  double step_at = 0.035;    ///< [m] of e while it stands: it steps
  double still_rate = 0.05;  ///< [rad/s] of a robot that stands still
};

/// Names, units, meanings and bounds; none has a default of its own.
[[nodiscard]] const std::vector<OptionInfo>& feedback_options();

/// The values of all of them, by name.
[[nodiscard]] OptionValues feedback_values(const GaitFeedback& numbers);

/// Those and the numbers of the walk (walk_options.h): the contents of [balance] of a robot's file and options of the controller `motions`.
[[nodiscard]] const std::vector<OptionInfo>& balanced_walk_options();

/// Scaled from kid21 by the length of the legs (lengths by l, times by sqrt(l)), the lag of soft servos by hip_droop (gait_seed.h). The
/// model's own numbers (given_balance) replace these, and `given` replaces both. Throws SetupError if an option is wrong or the model has
/// no legs to walk with.
[[nodiscard]] GaitFeedback gait_feedback(const Model& model, const OptionValues& given);
/// The walk itself: walk_parameters with those of the model's own numbers (given_balance) and of `given` that belong to the walk.
[[nodiscard]] WalkParameters balanced_walk(const Model& model, const OptionValues& given);

}  // namespace murosimf::locomotion
