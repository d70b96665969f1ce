/// signal_spec.h - what a real part makes of the true value, in this order (signal.h has the equations).
#pragma once

#include <limits>

#include "murosimf/model/option.h"

namespace murosimf::sensors {

/// All errors are of each number of an output, independent of each other; "unit" is the output's. Nothing said: the
/// true value. Constant errors are drawn once at the start of a run, from a normal distribution of the given deviation.
struct SignalSpec {
  double scale_error = 0;   ///< [1] deviation of the factor from 1
  double misalignment = 0;  ///< [rad] deviation of each axis towards each other one; outputs with three axes only
  double mean = 0;          ///< [unit] of the errors: a constant offset that is the same in every run
  double bias = 0;          ///< [unit] deviation of the constant offset
  double bias_mean = 0;     ///< [unit] what that offset is spread around, to one side or the other: the side is drawn
  double bias_random_walk = 0;       ///< [unit/s/sqrt(Hz)] of the offset that grows with the root of time
  double bias_correlation_time = 0;  ///< [s] in which that walk forgets where it was; 0: never
  double noise_density = 0;          ///< [unit/sqrt(Hz)] white noise, as an Allan plot shows it at 1 s (signal.h)
  double noise = 0;                  ///< [unit] deviation of every sample, whatever the rate
  double low_pass = 0;               ///< [Hz] -3 dB frequency of a first-order filter; 0: none
  double lowest = -std::numeric_limits<double>::infinity();  ///< [unit] saturation
  double highest = std::numeric_limits<double>::infinity();  ///< [unit]
  double resolution = 0;  ///< [unit] of one step of the A/D converter; 0: none, or as `bits` says
  int bits = 0;           ///< [1] of a converter from lowest to highest; 0: none

  bool operator==(const SignalSpec&) const = default;
};

/// The members that are keys of files; `range` is another of theirs (component_files/sensor_keys.h).
[[nodiscard]] const OptionTable<SignalSpec>& signal_options();

/// Throws SetupError that names the key: a negative or infinite number, bits without a range, an empty range.
void check(const SignalSpec& spec);

}  // namespace murosimf::sensors
