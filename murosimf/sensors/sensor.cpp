#include "murosimf/sensors/sensor.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::sensors {
namespace {

Rate sample_rate(const SensorSpec& spec, Duration execution) {
  return {spec.rate > 0 ? spec.rate : 1 / seconds(execution), spec.phase};
}

void check_signal_names(const SensorSpec& spec, const std::vector<Output>& outputs) {
  std::vector<std::string_view> names;
  for (const Output& output : outputs) names.push_back(output.name);
  for (const auto& [name, signal] : spec.signals) {
    const bool known = std::ranges::any_of(outputs, [&, &wanted = name](const Output& output) {
      return output.name == wanted || std::ranges::any_of(output.labels, [&](const std::string& label) {
               return wanted == output.name + "." + label;
             });
    });
    if (name.empty() || known || spec.part_outputs.contains(name)) continue;
    throw SetupError(unknown_name("output", name, names));
  }
}

/// Calls call(i, numbers) for each output with its part of the values.
template <class Call>
void for_outputs(const SensorInfo& info, std::span<double> values, const Call& call) noexcept {
  for (std::size_t i = 0; i < info.outputs.size(); ++i) {
    const std::size_t size = info.outputs[i].size();
    MUROSIMF_ASSERT(size <= values.size());
    call(i, values.first(size));
    values = values.subspan(size);
  }
}

}  // namespace

Sensor::Sensor(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings,
               std::vector<Output> outputs, Watch watch)
    : reading_(write_reading(setup, {spec.name, spec.type, spec.frame, sample_rate(spec, setup.period()).period(),
                                     std::move(outputs), spec.orientation, spec.position})),
      watch_(watch),
      rate_(sample_rate(spec, setup.period())),
      execution_(setup.period()),
      delay_(from_seconds(spec.delay)) {
  const Duration period = rate_.period();
  if (period < execution_) {
    throw SetupError(fmt::format("sensor '{}' with {} Hz is executed at {:.6g} Hz only", spec.name, spec.rate,
                                 1 / seconds(execution_)));
  }
  // after the outputs are known: messages list them
  check_signal_names(spec, reading_.info->outputs);
  make_signals(spec, surroundings.seed, setup.entity().name(), {seconds(execution_), seconds(period)});
  values_.resize(reading_.values.size());
  // enough for all samples that the delay keeps under way, and one that is being taken
  on_the_way_.assign(static_cast<std::size_t>((delay_ + execution_) / period) + 2, {Duration{}, values_});
}

void Sensor::make_signals(const SensorSpec& spec, std::uint64_t seed, const std::string& robot,
                          const SignalPeriods& periods) {
  for (const Output& output : reading_.info->outputs) {
    const std::string stream = fmt::format("{}/{}/{}", robot, spec.name, output.name);
    std::vector<std::string> names;
    std::vector<SignalSpec> signals;
    for (const std::string& label : output.labels) {
      names.push_back(fmt::format("{}.{}", stream, label));
      signals.push_back(spec.signal(fmt::format("{}.{}", output.name, label)));
    }
    if (names.empty()) {
      names.push_back(stream);
      signals.push_back(spec.signal(output.name));
    }
    filters_ = filters_ || std::ranges::any_of(signals, [](const SignalSpec& signal) { return signal.low_pass > 0; });
    signals_.push_back(with_context(output.name, [&] { return Signal(seed, signals, names, periods); }));
  }
}

std::string Sensor::diagnostic(const LevelTraits&) const { return {}; }

void Sensor::initialize() {
  reading_.time = Duration{};
  reading_.samples = taken_ = delivered_ = 0;
  std::fill(reading_.values.begin(), reading_.values.end(), 0.0);
  for (Signal& signal : signals_) signal.start();
  start();
}

void Sensor::step(const Instant& instant) noexcept {
  const bool due = rate_.falls_on(instant.now, execution_);
  if (due || filters_ || watch_ == Watch::always) {
    measure(values_);
    for_outputs(*reading_.info, values_,
                [&](std::size_t i, std::span<double> numbers) { signals_[i].disturb(numbers); });
  }
  if (due) ready() ? take_sample(instant) : show_what_is_expected();
  deliver(instant);
}

void Sensor::state(StateArchive& archive) {
  archive.elements(std::span(signals_));
  archive.elements(std::span(values_));
  archive.elements(std::span(on_the_way_));
  archive(taken_, delivered_);
  memory(archive);
}

void Sensor::reseed(std::uint64_t seed) {
  for (Signal& signal : signals_) signal.reseed(seed);
  draw_anew(seed);
}

/// From values with their errors to what a user sees.
void Sensor::show(std::span<double> values) noexcept {
  for_outputs(*reading_.info, values, [&](std::size_t i, std::span<double> numbers) { signals_[i].convert(numbers); });
  present(values);
}

void Sensor::take_sample(const Instant& instant) noexcept {
  Sample& sample = on_the_way_[taken_ % on_the_way_.size()];
  sample.time = instant.now;
  std::copy(values_.begin(), values_.end(), sample.values.begin());
  show(sample.values);
  taken(taken_);
  ++taken_;
}

void Sensor::show_what_is_expected() noexcept {
  std::copy(values_.begin(), values_.end(), reading_.values.begin());
  expect(reading_.values);
  show(reading_.values);
}

void Sensor::deliver(const Instant& instant) noexcept {
  for (; delivered_ < taken_; ++delivered_) {
    const Sample& sample = on_the_way_[delivered_ % on_the_way_.size()];
    if (sample.time + delay_ > instant.now) return;
    reading_.time = sample.time;
    reading_.samples = delivered_ + 1;
    std::copy(sample.values.begin(), sample.values.end(), reading_.values.begin());
    arrived(delivered_);
  }
}

Rate task_rate(const SensorSpec& spec, Watch watch, double step_rate) {
  const auto filters = [](const auto& signal) { return signal.second.low_pass > 0; };
  const bool every_step = spec.rate == 0 || spec.delay > 0 || watch == Watch::always ||
                          std::any_of(spec.signals.begin(), spec.signals.end(), filters);
  return every_step ? Rate(step_rate) : Rate(spec.rate, spec.phase);
}

void check_rate(const SensorSpec& spec, double step_rate) {
  if (spec.rate == 0) return;
  if (!(spec.rate >= slowest_rate) || !std::isfinite(spec.rate)) {
    throw SetupError(fmt::format("the rate of sensor '{}' is {} Hz; it must be {} Hz or more, or 0 for every step",
                                 spec.name, spec.rate, slowest_rate));
  }
  if (spec.rate > step_rate * (1 + 1e-9)) {
    throw SetupError(fmt::format("sensor '{}' with {} Hz is faster than the simulation's {} steps per second",
                                 spec.name, spec.rate, step_rate));
  }
}

}  // namespace murosimf::sensors
