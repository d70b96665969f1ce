/// walk_options.h - the numbers of a walk that a user may give: in [walk] of the TOML file beside a robot, or as options of the
/// controller `walk`. The others are derived from the robot (gait_seed.h).
#pragma once

#include <vector>

#include "murosimf/locomotion/gait.h"
#include "murosimf/model/option.h"

namespace murosimf::locomotion {

/// Names, units, meanings and bounds; none has a default of its own.
[[nodiscard]] const std::vector<OptionInfo>& walk_options();

/// Writes the given values into the parameters. Throws SetupError for a name that is none of walk_options, a value of another type, or
/// one that is out of its bounds.
void apply_walk_options(const OptionValues& given, WalkParameters& parameters);

/// The values of all options, as numbers of WalkParameters.
[[nodiscard]] OptionValues walk_option_values(const WalkParameters& parameters);

}  // namespace murosimf::locomotion
