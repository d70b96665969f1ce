/// signal.h - from the true value to what a part reports: errors, noise, filter, saturation, A/D conversion.
///
/// With h the time between two executions of the sensor and u, n, m independent numbers of the standard normal
/// distribution, drawn from streams of their own (seed, robot, sensor, number):
///
///     x1 = (1 + scale_error u) x + misalignment * (the other two axes, each with its own u)      constant factors
///     x2 = x1 + bias u + b_k + noise_density / sqrt(h) n_k       b_k+1 = b_k + bias_random_walk sqrt(h) m_k
///     x3 = low-pass of x2, first order, bilinear with |H(low_pass)| = 1/sqrt(2)
///     x4 = x3 + noise n_j                                        at the instants of samples j only, as all that follows
///     x5 = x4 in whole steps of the converter, between lowest and highest
///
/// Allan deviation after averaging over T: noise_density / sqrt(T) of the white noise, bias_random_walk sqrt(T/3) of the
/// walk, whatever h is. So the density is two-sided, the N of IEEE Std 952-1997 (annex C); the effective noise within a
/// bandwidth B is N sqrt(2 B). A data sheet whose rms is density * sqrt(B) quotes it one-sided: divide by sqrt(2).
/// A converter of n bits has the codes 0 to 2^n - 1 with lowest + code * (highest - lowest) / 2^n.
/// Source: IEEE Std 952-1997, annex C; bilinear transformation with prewarping: Oppenheim, Schafer, Discrete-Time
/// Signal Processing, sec. 7.1.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "murosimf/math/random.h"
#include "murosimf/sensors/signal_spec.h"

namespace murosimf::sensors {

/// One output of a sensor.
class Signal {
 public:
  /// `names`: of its numbers; with `seed` they tell the streams of noise apart. `period` [s] between two executions.
  /// Throws SetupError if the spec is impossible (check).
  Signal(const SignalSpec& spec, std::uint64_t seed, const std::vector<std::string>& names, double period);

  /// Back to the instant 0.
  void start() noexcept;
  /// To be called in every execution that has a true value: errors, noise and filter, in place.
  void disturb(std::span<double> values) noexcept;
  /// At the instant of a sample: noise of the sample, saturation, conversion.
  void convert(std::span<double> values) noexcept;

 private:
  struct Number {
    RandomStream noise, sample;
    double scale = 1, bias = 0;                  // [1], [unit]
    double cross_one = 0, cross_two = 0;         // [1] of the next axis and the one after it
    double drift = 0;                            // [unit] b_k
    double filter_input = 0, filter_output = 0;  // [unit] of the step before
  };
  [[nodiscard]] double filtered(Number& number, double value) const noexcept;

  SignalSpec spec_;
  std::vector<Number> numbers_;
  double white_ = 0, walk_ = 0;  // [unit] deviations in one step
  double filter_ = 0;            // [1] tan(pi fc h); 0: no filter
  double step_ = 0;              // [unit] of the converter; 0: none
  double highest_ = 0;           // [unit] largest code
  std::uint64_t executions_ = 0, samples_ = 0;
};

}  // namespace murosimf::sensors
