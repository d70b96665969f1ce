/// signal.h - from the true value to what a part reports: errors, noise, filter, saturation, A/D conversion.
///
/// With h the time between two executions of the sensor, T that between two samples, and u, n, m, k independent numbers
/// of the standard normal distribution, drawn from streams of their own (seed, robot, sensor, number):
///
///     x1 = (1 + scale_error u) x + misalignment * (the other two axes, each with its own u) + b    in every execution
///          b = mean + bias u, or with bias_mean, mean +- (bias_mean + bias u), either sign with probability 1/2
///     x2 = low-pass of x1, first order, bilinear with |H(low_pass)| = 1/sqrt(2)
///     x3 = x2 + w_j + b_j + noise k_j                               at the instants of samples j only, as all that follows
///          w_j+1 = a w_j + (1 - a) noise_density / sqrt(T) n_j      a = exp(-2 pi low_pass T); 0 without low-pass
///          b_j+1 = b_j + bias_random_walk sqrt(T) m_j           or, with the correlation time t,
///          b_j+1 = p b_j + bias_random_walk sqrt(t/2 (1 - p^2)) m_j, p = exp(-T/t): a Gauss-Markov process
///     x4 = x3 in whole steps of the converter, between lowest and highest
///
/// So noise goes through the filter too, but is worked out for samples only: a first-order process of the same corner
/// frequency and of the density noise_density at low frequencies.
///
/// What is no finite number stays as it is (NaN: nothing seen; infinite: out of range), and a filter begins anew after
/// it.
///
/// Allan deviation after averaging over t: noise_density / sqrt(t) of the noise, bias_random_walk sqrt(t/3) of the walk,
/// whatever h and T are. So the density is two-sided, the N of IEEE Std 952-1997 (annex C); the effective noise within a
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
#include "murosimf/world/state_archive.h"

namespace murosimf::sensors {

struct SignalPeriods {
  double execution = 0.001;  ///< [s] h
  double sample = 0.001;     ///< [s] T
};

/// One output of a sensor.
class Signal {
 public:
  /// `names`: of its numbers; with `seed` they tell the streams of noise apart. Throws SetupError if the spec is
  /// impossible (check).
  Signal(const SignalSpec& spec, std::uint64_t seed, const std::vector<std::string>& names,
         const SignalPeriods& periods);
  /// The same with a spec for each number.
  Signal(std::uint64_t seed, const std::vector<SignalSpec>& specs, const std::vector<std::string>& names,
         const SignalPeriods& periods);

  /// Constant errors and noise of another seed.
  void reseed(std::uint64_t seed) noexcept;
  /// Back to the instant 0.
  void start() noexcept;
  /// To be called in every execution that has a true value: constant errors and filter, in place.
  void disturb(std::span<double> values) noexcept;
  /// At the instant of a sample: noise, saturation, conversion.
  void convert(std::span<double> values) noexcept;
  void state(StateArchive& archive);

 private:
  /// What a spec says, worked out.
  struct Law {
    Law(const SignalSpec& spec, const SignalPeriods& periods);

    SignalSpec spec;
    double memory = 0;           // [1] a
    double white = 0, walk = 0;  // [unit] deviations in one sample
    double keep = 1;             // [1] p
    double filter = 0;           // [1] tan(pi fc h); 0: no filter
    double step = 0;             // [unit] of the converter; 0: none
    double highest = 0;          // [unit] largest code
  };
  struct Number {
    RandomStream constants, noise, sample;
    double scale = 1, bias = 0;                  // [1], [unit]
    double cross_one = 0, cross_two = 0;         // [1] of the next axis and the one after it
    double first_wander = 0;                     // [unit] w_0, of the deviation that w has in the long run
    double wander = 0, drift = 0;                // [unit] w_j, b_j
    double filter_input = 0, filter_output = 0;  // [unit] of the step before
  };
  static void draw_constants(const Law& law, Number& number) noexcept;
  void misalign(std::span<double, 3> values) const noexcept;
  [[nodiscard]] double filtered(const Law& law, Number& number, double value) const noexcept;
  [[nodiscard]] double next_noise(const Law& law, Number& number) const noexcept;

  std::vector<Law> laws_;  // of each number
  std::vector<Number> numbers_;
  bool misaligned_ = false, filters_ = false;
  std::uint64_t executions_ = 0, samples_ = 0;
};

}  // namespace murosimf::sensors
