/// moments.h - moments of a recorded run that people want to see: goals, kicks, falls, robots that are up again; and the clips that show
/// them.
///
/// They are found in the recorded poses alone, so in every recording with poses, whatever it was made with.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/recording/recorded_source.h"
#include "murosimf/world/time.h"

namespace murosimf::recording {

struct Moment {
  enum class Kind { goal, kick, fall, get_up };
  Kind kind = Kind::goal;
  Duration time{};
  std::string robot;  ///< empty: goal
  double speed = 0;   ///< [m/s] of the ball, its largest in the 0.2 s after a kick; else 0
  int goal = 0;       ///< goal: which one, as goal_with_ball() (run_watch.h); else 0
};

/// "goal", "kick", "fall", "get_up": the most worth seeing first.
[[nodiscard]] const std::vector<std::string>& moment_kinds();
[[nodiscard]] std::string_view name_of(Moment::Kind kind);
/// For people: "goal", "blue1 kicks the ball (2.3 m/s)", "red2 falls", "red2 gets up".
[[nodiscard]] std::string text_of(const Moment& moment);

/// All moments from the start to the end of a recording, by time; its present instant is then the last one.
/// goal: as RunWatch has it. kick: within 0.1 s the ball's velocity changes by 0.8 m/s, it is faster than that afterwards, and part of a
/// robot is within 0.25 m of its middle; the next one is 0.4 s later at least. fall, get_up: the z axis of the base leans more than 60 degrees,
/// and then less than 30; a robot that lies at the start may get up. Stops early, with what it has, if `stop` says so.
[[nodiscard]] std::vector<Moment> find_moments(RecordedSource& source, const std::function<bool()>& stop);

struct Clip {
  Duration begin{}, end{};
  std::vector<Moment> moments;  ///< by time
};

/// Clips by time, none of which overlaps another, within [first, last]: around the `most` moments of these kinds that are most worth
/// seeing (by kind, then the fastest kicks, then the earliest). Each begins 1.2 s before a moment, 3 s before a goal and 4 s before a robot is up,
/// and ends 1.8 s after it; clips that meet are one.
[[nodiscard]] std::vector<Clip> clips_of(std::vector<Moment> moments, const std::set<std::string>& kinds,
                                         std::size_t most, Duration first, Duration last);

}  // namespace murosimf::recording
