/// sensor.h - what all sensors share: when they sample, what becomes of the true values, when a sample arrives.
///
/// A new sensor derives from Sensor and says in `measure` how properties become numbers; errors, noise, filter,
/// saturation, A/D conversion (signal.h), rate and delay are its for nothing (paper 6.1).
///
/// A sensor is executed at the rate at which it is attached and samples in the execution nearest to each instant of its own
/// rate (rate.h). Its filter works in every execution, so one with a low-pass, or that looks at how things change
/// (Watch::always), is attached at the rate of the simulation's steps; task_rate says which.
/// Sensors are attached first (docs/add_an_algorithm.md): a sample shows the state at the beginning of the step, and
/// its time is that instant. A delayed sample is shown by the first execution at or after that time plus the delay.
#pragma once

#include <string>

#include "murosimf/sensors/reading.h"
#include "murosimf/sensors/sensor_spec.h"
#include "murosimf/sensors/signal.h"
#include "murosimf/world/motion_level.h"
#include "murosimf/world/rate.h"
#include "murosimf/world/state_archive.h"

namespace murosimf::sensors {

/// When true values are worked out.
enum class Watch {
  samples,  ///< at the instants of samples; in every execution if there is a filter
  always,   ///< in every execution
};

class Sensor : public Algorithm {
 public:
  [[nodiscard]] Phase phase() const noexcept final { return Phase::sense; }
  void initialize() final;
  void step(const Instant& instant) noexcept final;
  void state(StateArchive& archive) final;
  void reseed(std::uint64_t seed) final;

  /// What it reports at a level of detail that has nothing for it, and why: one sentence about "it"; empty if all is there.
  [[nodiscard]] virtual std::string diagnostic(const LevelTraits& level) const;
  [[nodiscard]] const Reading& reading() const { return reading_; }

 protected:
  /// Throws SetupError: the rate is more than that of execution, two sensors have one name, a signal is impossible or
  /// of an output that there is none of.
  Sensor(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings, std::vector<Output> outputs,
         Watch watch = Watch::samples);

  /// The true values of all outputs, one after the other. NaN: nothing is there to be seen.
  virtual void measure(std::span<double> values) noexcept = 0;
  /// What is shown of a sample whose values have got their errors; changes nothing if there is nothing to add.
  virtual void present(std::span<double>) noexcept {}
  /// Whether there is anything to be sampled yet; false: no sample is taken at this instant, and the reading shows the
  /// values that measure() has left, changed by expect(), for readers that cannot wait.
  [[nodiscard]] virtual bool ready() const noexcept { return true; }
  virtual void expect(std::span<double>) const noexcept {}
  /// Forgets what was before the instant 0. May throw SetupError: nothing has been executed yet.
  virtual void start() {}
  /// How many samples were taken before this one.
  [[nodiscard]] std::uint64_t samples_taken() const { return taken_; }

  /// Random numbers of another seed, besides those of the signals.
  virtual void draw_anew(std::uint64_t /*seed*/) {}
  /// Saves or loads what it remembers besides what all sensors do.
  virtual void memory(StateArchive&) {}

  // For sensors whose samples are more than numbers: sample number `sample` (from 0) was taken just now; it arrives.
  virtual void taken(std::uint64_t /*sample*/) noexcept {}
  virtual void arrived(std::uint64_t /*sample*/) noexcept {}
  /// How many samples are on the way at most.
  [[nodiscard]] std::size_t most_on_the_way() const { return on_the_way_.size(); }

 private:
  struct Sample {
    Duration time{};
    std::vector<double> values;
    void state(StateArchive& archive) { archive(time, values); }
  };
  void make_signals(const SensorSpec& spec, std::uint64_t seed, const std::string& robot, const SignalPeriods& periods);
  void take_sample(const Instant& instant) noexcept;
  void show_what_is_expected() noexcept;
  void show(std::span<double> values) noexcept;
  void deliver(const Instant& instant) noexcept;

  Reading& reading_;
  Watch watch_;
  Rate rate_;  // of samples
  Duration execution_, delay_;
  std::vector<Signal> signals_;  // by output
  bool filters_ = false;
  std::vector<double> values_;      // of this execution
  std::vector<Sample> on_the_way_;  // a ring: of this many samples the last ones are not delivered yet
  std::uint64_t taken_ = 0, delivered_ = 0;
};

/// At which a sensor is to be attached in a simulation with `step_rate` [Hz] steps per second.
[[nodiscard]] Rate task_rate(const SensorSpec& spec, Watch watch, double step_rate);

/// Throws SetupError if `spec` asks for samples that are faster than steps, or too rare.
void check_rate(const SensorSpec& spec, double step_rate);

}  // namespace murosimf::sensors
