// A sensor at rest for an hour: its Allan deviation must give the densities back that its noise was made of.
#include <cmath>
#include <vector>

#include "murosimf/sensors/inertial.h"
#include "tests/law.h"
#include "tests/sensors/puppet.h"

namespace murosimf::sensors {
namespace {

/// Samples of one axis of a gyroscope at rest.
std::vector<double> at_rest_for(double duration, const SensorSpec& spec) {
  test::SensorRig<Gyroscope> rig(test::at_rest, spec, spec.rate);
  std::vector<double> samples;
  const auto count = static_cast<std::size_t>(duration * spec.rate);
  samples.reserve(count);
  while (samples.size() < count) {
    rig.simulation.step();
    samples.push_back(rig.reading().values[2]);
  }
  return samples;
}

/// Allan variance at an averaging time of `m` samples, from all overlapping clusters (IEEE Std 952-1997, annex C).
double allan_variance(const std::vector<double>& samples, std::size_t m) {
  std::vector<double> sums{0};
  for (const double sample : samples) sums.push_back(sums.back() + sample);
  double squares = 0;
  const std::size_t clusters = samples.size() - 2 * m + 1;
  for (std::size_t k = 0; k < clusters; ++k) {
    const double difference = (sums[k + 2 * m] - sums[k + m]) - (sums[k + m] - sums[k]);
    squares += difference * difference;
  }
  const double mm = static_cast<double>(m * m);
  return squares / (2 * mm * static_cast<double>(clusters));
}

TEST(Allan, AStaticHourGivesTheDensitiesBack) {
  const double noise = 1e-3, walk = 1e-3;  // [rad/s/sqrt(Hz)], [rad/s^2/sqrt(Hz)]
  for (const double rate : {50.0, 200.0}) {
    const SensorSpec spec{.name = "gyro",
                          .rate = rate,
                          .signals = {{"", {.bias = 0.1, .bias_random_walk = walk, .noise_density = noise}}}};
    const auto samples = at_rest_for(3600, spec);
    // variance T = N^2 + K^2 T^2/3 at a short and a long averaging time: two equations for N^2 and K^2
    const double brief = 0.1, lengthy = 4;
    const double a = brief * allan_variance(samples, static_cast<std::size_t>(brief * rate));
    const double b = lengthy * allan_variance(samples, static_cast<std::size_t>(lengthy * rate));
    const double K2 = 3 * (b - a) / (lengthy * lengthy - brief * brief);
    const double N2 = a - K2 * brief * brief / 3;
    const std::string level = fmt::format("gyroscope at {} Hz", rate);
    law::expect_near({.law = "static hour: noise density by Allan deviation, of that asked for",
                      .level = level,
                      .source = "IEEE Std 952-1997: N/sqrt(T)"},
                     std::sqrt(N2) / noise, 1, 0.05, "1");
    law::expect_near({.law = "static hour: bias random walk by Allan deviation, of that asked for",
                      .level = level,
                      .source = "IEEE Std 952-1997: K sqrt(T/3)"},
                     std::sqrt(K2) / walk, 1, 0.05, "1");
  }
}

// The filter takes away fast noise only: what is left over long times is the density that was asked for.
TEST(Allan, ALowPassKeepsTheDensityOfSlowNoise) {
  const double noise = 2e-3;
  const SensorSpec spec{.name = "gyro", .rate = 200, .signals = {{"", {.noise_density = noise, .low_pass = 20}}}};
  const auto samples = at_rest_for(1800, spec);
  const double deviation = std::sqrt(allan_variance(samples, 200));
  law::expect_near({.law = "low-pass of 20 Hz: Allan deviation at 1 s, of the density asked for",
                    .level = "gyroscope at 200 Hz",
                    .source = "a low-pass lets slow noise through"},
                   deviation / noise, 1, 0.05, "1");
  double squares = 0;
  for (const double sample : samples) squares += sample * sample;
  const double a = std::exp(-2 * pi * 20 / 200);  // of one sample in the next
  law::expect_near({.law = "low-pass of 20 Hz: rms of white noise, of that expected",
                    .level = "gyroscope at 200 Hz",
                    .source = "first-order process: N^2/T (1 - a)/(1 + a)"},
                   std::sqrt(squares / static_cast<double>(samples.size())) /
                       (noise * std::sqrt(200 * (1 - a) / (1 + a))),
                   1, 0.02, "1");
}

}  // namespace
}  // namespace murosimf::sensors
