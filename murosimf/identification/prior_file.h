/// prior_file.h - priors of servos: the files `servos/priors/<type>.toml`.
///
///     [torque_constant]       # a parameter of identification/parameter.h
///     value = 0.37            # in its unit
///     relative_width = 0.1    # or width = ..., in its unit
#pragma once

#include <string>
#include <string_view>

#include "murosimf/identification/prior.h"

namespace murosimf::identification {

/// The prior of a servo type, or in a file of that path; "none" is empty. Throws SetupError: with the nearest name if
/// there is none, with file:line:column if something is wrong in it.
[[nodiscard]] identification::Prior read_prior(std::string_view name);

/// `type` if it has a prior, else "none".
[[nodiscard]] std::string prior_of_type(std::string_view type);

}  // namespace murosimf::identification
