#include "murosimf/sensors/signal.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/scalar.h"
#include "murosimf/model/error.h"

namespace murosimf::sensors {

void check(const SignalSpec& spec) {
  const std::array<std::pair<const char*, double>, 8> numbers{{{"scale_error", spec.scale_error},
                                                               {"misalignment", spec.misalignment},
                                                               {"bias", spec.bias},
                                                               {"bias_random_walk", spec.bias_random_walk},
                                                               {"noise_density", spec.noise_density},
                                                               {"noise", spec.noise},
                                                               {"low_pass", spec.low_pass},
                                                               {"resolution", spec.resolution}}};
  for (const auto& [key, number] : numbers) {
    if (number >= 0 && std::isfinite(number)) continue;
    throw SetupError(fmt::format("{} is {}; it must be a number from 0 on", key, number));
  }
  if (!(spec.lowest < spec.highest)) {
    throw SetupError(fmt::format("the range from {} to {} is empty", spec.lowest, spec.highest));
  }
  if (spec.bits < 0 || spec.bits > 32) throw SetupError(fmt::format("bits is {}; it must be from 0 to 32", spec.bits));
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
  const std::size_t count = numbers_.size();
  std::array<double, 3> other{};
  if (spec_.misalignment > 0) std::copy_n(values.begin(), 3, other.begin());
  for (std::size_t i = 0; i < count; ++i) {
    Number& number = numbers_[i];
    double x = number.scale * values[i];
    if (spec_.misalignment > 0) x += number.cross_one * other[(i + 1) % 3] + number.cross_two * other[(i + 2) % 3];
    x += number.bias;
    values[i] = filter_ > 0 ? filtered(number, x) : x;
  }
  ++executions_;
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
