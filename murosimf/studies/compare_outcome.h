/// compare_outcome.h - how far the outcome of a run is from the reference's: what the robot has touched, moved and thrown over.
#pragma once

#include <string>
#include <vector>

#include "murosimf/dynamics/motion_recorder.h"
#include "murosimf/studies/compare_metrics.h"
#include "murosimf/studies/outcome_recorder.h"

namespace murosimf::studies {

/// [m/s] Differences of slower speeds are given as shares of this one: half of what a gentle kick gives a ball. On carpet a ball of that
/// speed rolls about as far as shortest_way.
inline constexpr double slowest_speed = 0.5;

/// Measures of one other entity.
struct OtherMeasures {
  double way = 0;         ///< [m] along the ground; of what has joints without its swaying
  double peak_speed = 0;  ///< [m/s] of its base, of all samples
  Vec3d end;              ///< [m] where it was last
  int falls = 0;
};

[[nodiscard]] OtherMeasures measures_of(const OtherRecord& record);

/// Up to `until` [s].
[[nodiscard]] OtherMeasures measures_of(const OtherRecord& record, double until);

/// When it fell and got up.
[[nodiscard]] std::vector<PostureEvent> postures_of(const OtherRecord& record);

/// Fills in the deviations of others: of each quantity the one that is off by most. Both runs have the same entities. `fall` [s] is
/// when one of the robots begins to fall first. What the robot had touched before, and has not touched since, shows what was
/// done before the fall: it counts to its end; all others count up to the fall.
void compare_outcome(const OutcomeRecord& mine, const OutcomeRecord& reference, double fall, Deviations& deviations);

/// "touches ball, the reference does not": for every entity that only one of the runs has touched.
[[nodiscard]] std::vector<std::string> different_touches(const OutcomeRecord& mine, const OutcomeRecord& reference);

/// "red1: falls once, the reference does not": of every other entity that can fall; `tolerance` [s] between falls of both.
[[nodiscard]] std::vector<std::string> different_falls_of_others(const OutcomeRecord& mine,
                                                                 const OutcomeRecord& reference, double tolerance);

/// [1] Of the time within 50 ms of a touch, the share in which some servo asked for all that it has; 0 without touches.
[[nodiscard]] double duty_while_touching(const dynamics::MotionRecord& robot, const OutcomeRecord& outcome);

/// Names of all that the robot has touched.
[[nodiscard]] std::vector<std::string> touched(const OutcomeRecord& outcome);

}  // namespace murosimf::studies
