#include "murosimf/sensors/signal.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/scalar.h"
#include "murosimf/model/error.h"

namespace murosimf::sensors {

const OptionTable<SignalSpec>& signal_options() {
  using Spec = SignalSpec;
  static const OptionTable<Spec> table{
      {"scale_error", &Spec::scale_error, "1", "deviation of the factor, drawn once per run", 0},
      {"misalignment", &Spec::misalignment, "rad", "deviation of each axis towards each other, drawn once per run", 0},
      {"bias", &Spec::bias, "unit", "deviation of the constant offset, drawn once per run", 0},
      {"bias_random_walk", &Spec::bias_random_walk, "unit/s/sqrt(Hz)", "of the offset, with the root of time", 0},
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
  if (spec.bits == 0) return;
  if (spec.resolution > 0)
    throw SetupError("bits and resolution both say how long a step of the converter is; keep one");
  if (!std::isfinite(spec.highest - spec.lowest)) throw SetupError("bits needs a range: range, or lowest and highest");
}

Signal::Signal(const SignalSpec& spec, std::uint64_t seed, const std::vector<std::string>& names,
               const SignalPeriods& periods)
    : spec_(spec),
      memory_(spec.low_pass > 0 ? std::exp(-2 * pi * spec.low_pass * periods.sample) : 0),
      white_((1 - memory_) * spec.noise_density / std::sqrt(periods.sample)),
      walk_(spec.bias_random_walk * std::sqrt(periods.sample)) {
  check(spec);
  if (spec.misalignment > 0 && names.size() != 3) {
    throw SetupError(fmt::format("misalignment is of three axes; '{}' is one of {} numbers", names[0], names.size()));
  }
  // above the highest frequency that steps of this length can show, a filter changes nothing
  const double turns = spec.low_pass * periods.execution;
  if (turns > 0 && turns < 0.5) filter_ = std::tan(pi * turns);
  step_ = spec.bits > 0 ? std::ldexp(spec.highest - spec.lowest, -spec.bits) : spec.resolution;
  highest_ = spec.bits > 0 ? spec.highest - step_ : spec.highest;
  for (const std::string& name : names) {
    numbers_.push_back({{seed, name + "/constants"}, {seed, name + "/noise"}, {seed, name + "/sample"}});
    draw_constants(numbers_.back());
  }
}

void Signal::draw_constants(Number& number) const noexcept {
  number.scale = 1 + spec_.scale_error * number.constants.normal(0);
  number.bias = spec_.bias * number.constants.normal(1);
  number.cross_one = spec_.misalignment * number.constants.normal(2);
  number.cross_two = spec_.misalignment * number.constants.normal(3);
  number.first_wander = white_ / std::sqrt(1 - memory_ * memory_) * number.constants.normal(4);
}

void Signal::reseed(std::uint64_t seed) noexcept {
  for (Number& number : numbers_) {
    for (RandomStream* stream : {&number.constants, &number.noise, &number.sample}) stream->reseed(seed);
    draw_constants(number);
  }
}

void Signal::start() noexcept {
  executions_ = samples_ = 0;
  for (Number& number : numbers_) {
    number.wander = number.first_wander;
    number.drift = number.filter_input = number.filter_output = 0;
  }
}

double Signal::filtered(Number& number, double value) const noexcept {
  const bool begins = executions_ == 0 || !std::isfinite(number.filter_output);
  if (begins || !std::isfinite(value)) return number.filter_input = number.filter_output = value;
  number.filter_output =
      (filter_ * (value + number.filter_input) + (1 - filter_) * number.filter_output) / (1 + filter_);
  number.filter_input = value;
  return number.filter_output;
}

/// Errors that are constant come out of the seed.
void Signal::state(StateArchive& archive) {
  for (Number& number : numbers_) archive(number.wander, number.drift, number.filter_input, number.filter_output);
  archive(executions_, samples_);
}

void Signal::disturb(std::span<double> values) noexcept {
  if (spec_.misalignment > 0) {
    misalign(values.first<3>());
  } else {
    for (std::size_t i = 0; i < numbers_.size(); ++i) values[i] = numbers_[i].scale * values[i] + numbers_[i].bias;
  }
  if (filter_ > 0) {
    for (std::size_t i = 0; i < numbers_.size(); ++i) values[i] = filtered(numbers_[i], values[i]);
  }
  ++executions_;
}

/// The constant errors of three axes that see a little of each other.
void Signal::misalign(std::span<double, 3> values) const noexcept {
  const double x = values[0], y = values[1], z = values[2];
  const auto axis = [](const Number& n, double own, double next, double last) {
    return n.scale * own + (n.cross_one * next + n.cross_two * last) + n.bias;
  };
  values[0] = axis(numbers_[0], x, y, z);
  values[1] = axis(numbers_[1], y, z, x);
  values[2] = axis(numbers_[2], z, x, y);
}

double Signal::next_noise(Number& number) const noexcept {
  const double noise = number.wander + number.drift;
  const auto [white, walk] = number.noise.normals(samples_);
  number.wander = memory_ * number.wander + white_ * white;
  number.drift += walk_ * walk;
  return noise;
}

void Signal::convert(std::span<double> values) noexcept {
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    const double noise = white_ > 0 || walk_ > 0 ? next_noise(numbers_[i]) : 0;
    if (!std::isfinite(values[i])) continue;
    double x = values[i] + noise;
    if (spec_.noise > 0) x += spec_.noise * numbers_[i].sample.normal(samples_);
    if (step_ > 0) {
      const double zero = spec_.bits > 0 ? spec_.lowest : 0;
      x = zero + step_ * std::round((x - zero) / step_);
    }
    values[i] = x < spec_.lowest ? spec_.lowest : x > highest_ ? highest_ : x;
  }
  ++samples_;
}

}  // namespace murosimf::sensors
