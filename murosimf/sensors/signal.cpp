#include "murosimf/sensors/signal.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/math/scalar.h"
#include "murosimf/model/error.h"

namespace murosimf::sensors {

const OptionTable<SignalSpec>& signal_options() {
  using Spec = SignalSpec;
  static const OptionTable<Spec> table{
      {"scale_error", &Spec::scale_error, "1", "deviation of the factor, drawn once per run", 0},
      {"misalignment", &Spec::misalignment, "rad", "deviation of each axis towards each other, drawn once per run", 0},
      {"mean", &Spec::mean, "unit", "of the errors: a constant offset, the same in every run"},
      {"bias", &Spec::bias, "unit", "deviation of the constant offset, drawn once per run", 0},
      {"bias_mean", &Spec::bias_mean, "unit", "of the size of that offset, whose sign is drawn, too"},
      {"bias_random_walk", &Spec::bias_random_walk, "unit/s/sqrt(Hz)", "of the offset, with the root of time", 0},
      {"bias_correlation_time", &Spec::bias_correlation_time, "s", "after which that walk has forgotten; 0: never", 0},
      {"noise_density", &Spec::noise_density, "unit/sqrt(Hz)", "of white noise; right at any rate", 0},
      {"noise", &Spec::noise, "unit", "deviation of every sample, whatever the rate", 0},
      {"low_pass", &Spec::low_pass, "Hz", "-3 dB frequency of a first-order filter; 0: none", 0},
      {"lowest", &Spec::lowest, "unit", "saturation"},
      {"highest", &Spec::highest, "unit", "saturation"},
      {"resolution", &Spec::resolution, "unit", "of a step of the converter; 0: none, or as bits say", 0},
      {"bits", &Spec::bits, "1", "of a converter from lowest to highest; 0: none", 0, 32},
  };
  return table;
}

void check(const SignalSpec& spec) {
  const std::vector<OptionInfo>& options = signal_options().infos();
  const std::vector<OptionValue> values = signal_options().values(spec);
  for (std::size_t i = 0; i < options.size(); ++i) check_option(options[i], values[i]);
  if (!(spec.lowest < spec.highest)) {
    throw SetupError(fmt::format("the range from {} to {} is empty", spec.lowest, spec.highest));
  }
  // bits divide the range, so they exclude a resolution and need a range
  if (spec.bits == 0) return;
  if (spec.resolution > 0)
    throw SetupError("bits and resolution both say how long a step of the converter is; keep one");
  if (!std::isfinite(spec.highest - spec.lowest)) throw SetupError("bits needs a range: range, or lowest and highest");
}

Signal::Law::Law(const SignalSpec& of, const SignalPeriods& periods)
    : spec(of),
      memory(of.low_pass > 0 ? std::exp(-2 * pi * of.low_pass * periods.sample) : 0),
      white((1 - memory) * of.noise_density / std::sqrt(periods.sample)),
      walk(of.bias_random_walk * std::sqrt(periods.sample)) {
  MUROSIMF_ASSERT(periods.sample > 0 && periods.execution > 0);
  check(spec);
  // exact discretization of a Gauss-Markov process: right at any rate
  if (const double time = spec.bias_correlation_time; time > 0) {
    keep = std::exp(-periods.sample / time);
    walk = spec.bias_random_walk * std::sqrt(-0.5 * time * std::expm1(-2 * periods.sample / time));
  }
  // above the highest frequency that steps of this length can show, a filter changes nothing
  const double turns = spec.low_pass * periods.execution;
  if (turns > 0 && turns < 0.5) filter = std::tan(pi * turns);
  step = spec.bits > 0 ? std::ldexp(spec.highest - spec.lowest, -spec.bits) : spec.resolution;
  highest = spec.bits > 0 ? spec.highest - step : spec.highest;
}

Signal::Signal(const SignalSpec& spec, std::uint64_t seed, const std::vector<std::string>& names,
               const SignalPeriods& periods)
    : Signal(seed, std::vector<SignalSpec>(names.size(), spec), names, periods) {}

Signal::Signal(std::uint64_t seed, const std::vector<SignalSpec>& specs, const std::vector<std::string>& names,
               const SignalPeriods& periods) {
  MUROSIMF_ASSERT(specs.size() == names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& name = names[i];
    const Law& law = laws_.emplace_back(specs[i], periods);
    misaligned_ = misaligned_ || law.spec.misalignment > 0;
    filters_ = filters_ || law.filter > 0;
    numbers_.push_back({{seed, name + "/constants"}, {seed, name + "/noise"}, {seed, name + "/sample"}});
    draw_constants(law, numbers_.back());
  }
  if (misaligned_ && names.size() != 3) {
    throw SetupError(fmt::format("misalignment is of three axes; '{}' is one of {} numbers", names[0], names.size()));
  }
}

void Signal::draw_constants(const Law& law, Number& number) noexcept {
  const SignalSpec& spec = law.spec;
  number.scale = 1 + spec.scale_error * number.constants.normal(0);
  const double bias = spec.bias * number.constants.normal(1);
  const bool other_side = spec.bias_mean != 0 && number.constants.normal(5) < 0;
  // the sign of the mean bias is drawn: its size is typical, its direction is not
  number.bias = spec.mean + (other_side ? -(spec.bias_mean + bias) : spec.bias_mean + bias);
  number.cross_one = spec.misalignment * number.constants.normal(2);
  number.cross_two = spec.misalignment * number.constants.normal(3);
  // in the stationary state of the filter from the first sample on
  number.first_wander = law.white / std::sqrt(1 - law.memory * law.memory) * number.constants.normal(4);
}

void Signal::reseed(std::uint64_t seed) noexcept {
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    Number& number = numbers_[i];
    for (RandomStream* stream : {&number.constants, &number.noise, &number.sample}) stream->reseed(seed);
    draw_constants(laws_[i], number);
  }
}

void Signal::start() noexcept {
  executions_ = samples_ = 0;
  for (Number& number : numbers_) {
    number.wander = number.first_wander;
    number.drift = number.filter_input = number.filter_output = 0;
  }
}

double Signal::filtered(const Law& law, Number& number, double value) const noexcept {
  // bilinear transform: the -3 dB frequency is exact at any step
  const bool begins = executions_ == 0 || !std::isfinite(number.filter_output);
  if (begins || !std::isfinite(value)) return number.filter_input = number.filter_output = value;
  number.filter_output =
      (law.filter * (value + number.filter_input) + (1 - law.filter) * number.filter_output) / (1 + law.filter);
  number.filter_input = value;
  return number.filter_output;
}

/// Constant errors are no state: they follow from the seed.
void Signal::state(StateArchive& archive) {
  for (Number& number : numbers_) archive(number.wander, number.drift, number.filter_input, number.filter_output);
  archive(executions_, samples_);
}

void Signal::disturb(std::span<double> values) noexcept {
  MUROSIMF_ASSERT(values.size() >= numbers_.size());
  if (misaligned_) {
    misalign(values.first<3>());
  } else {
    for (std::size_t i = 0; i < numbers_.size(); ++i) values[i] = numbers_[i].scale * values[i] + numbers_[i].bias;
  }
  if (filters_) {
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      if (laws_[i].filter > 0) values[i] = filtered(laws_[i], numbers_[i], values[i]);
    }
  }
  ++executions_;
}

/// Applies the constant errors of three axes, including cross-axis sensitivity.
void Signal::misalign(std::span<double, 3> values) const noexcept {
  MUROSIMF_ASSERT(numbers_.size() == 3);
  const double x = values[0], y = values[1], z = values[2];
  const auto axis = [](const Number& n, double own, double next, double last) {
    return n.scale * own + (n.cross_one * next + n.cross_two * last) + n.bias;
  };
  values[0] = axis(numbers_[0], x, y, z);
  values[1] = axis(numbers_[1], y, z, x);
  values[2] = axis(numbers_[2], z, x, y);
}

double Signal::next_noise(const Law& law, Number& number) const noexcept {
  const double noise = number.wander + number.drift;
  const auto [white, walk] = number.noise.normals(samples_);
  number.wander = law.memory * number.wander + law.white * white;
  // a walk without correlation time keeps the bits of a plain sum
  if (law.keep < 1) number.drift *= law.keep;
  number.drift += law.walk * walk;
  return noise;
}

void Signal::convert(std::span<double> values) noexcept {
  MUROSIMF_ASSERT(values.size() >= numbers_.size() && laws_.size() == numbers_.size());
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    const Law& law = laws_[i];
    const double noise = law.white > 0 || law.walk > 0 ? next_noise(law, numbers_[i]) : 0;
    if (!std::isfinite(values[i])) continue;  // the random numbers are drawn nevertheless: the sequence stays the same
    double x = values[i] + noise;
    if (law.spec.noise > 0) x += law.spec.noise * numbers_[i].sample.normal(samples_);
    if (law.step > 0) {
      const double zero = law.spec.bits > 0 ? law.spec.lowest : 0;
      x = zero + law.step * std::round((x - zero) / law.step);
    }
    values[i] = x < law.spec.lowest ? law.spec.lowest : x > law.highest ? law.highest : x;
  }
  ++samples_;
}

}  // namespace murosimf::sensors
