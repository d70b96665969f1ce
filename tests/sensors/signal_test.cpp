// From the true value to what a part reports: exact where it is exact, of the right size where it is random.
#include "murosimf/sensors/signal.h"

#include <cmath>
#include <limits>

#include "tests/fixtures.h"
#include "tests/law.h"

namespace murosimf::sensors {
namespace {

const std::vector<std::string> one{"robot/sensor/value"};
const std::vector<std::string> three{"robot/sensor/x", "robot/sensor/y", "robot/sensor/z"};

double converted(const SignalSpec& spec, double value) {
  Signal signal(spec, 1, one, {});
  signal.convert({&value, 1});
  return value;
}

TEST(Signal, ChangesNothingIfNothingIsSaid) {
  Signal signal({}, 1, three, {});
  std::array<double, 3> values{1.25, -3e7, std::numeric_limits<double>::infinity()};
  const auto before = values;
  signal.disturb(values);
  signal.convert(values);
  EXPECT_EQ(values, before);
}

TEST(Signal, AddsItsMeanAndABiasToOneSideOrTheOther) {
  int positive = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Signal signal({.mean = 2, .bias_mean = 0.3}, seed, one, {});
    double value = 10;
    signal.disturb({&value, 1});
    EXPECT_NEAR(std::abs(value - 12), 0.3, 1e-12);
    positive += value > 12;
  }
  EXPECT_NEAR(positive, 100, 30) << "four deviations of a fair coin";
}

TEST(Signal, HasErrorsOfItsOwnForEachNumber) {
  Signal signal(1, {{.mean = 1}, {}, {.mean = -2, .resolution = 0.5}}, three, {});
  std::array<double, 3> values{0.2, 0.2, 0.2};
  signal.disturb(values);
  signal.convert(values);
  EXPECT_EQ(values, (std::array<double, 3>{1.2, 0.2, -2}));
}

// Gauss-Markov: standard deviation s sqrt(t/2) in the long run. Tolerance: 2000 correlation times, so about 1 / sqrt(2000) = 2 %.
TEST(Signal, ForgetsItsWalkAfterTheCorrelationTime) {
  const double density = 0.4, time = 0.05;
  Signal signal({.bias_random_walk = density, .bias_correlation_time = time}, 1, one, {});
  double sum = 0;
  const int count = 100000;
  for (int i = 0; i < count; ++i) {
    double value = 0;
    signal.convert({&value, 1});
    sum += value * value;
  }
  const double expected = density * std::sqrt(time / 2);
  law::expect_near({.law = "bias that wanders and forgets: deviation in the long run",
                    .level = "signal",
                    .source = "Gauss-Markov process, s sqrt(t / 2)"},
                   std::sqrt(sum / count), expected, 0.1 * expected, "unit");
}

TEST(Signal, SaturatesExactly) {
  const SignalSpec spec{.lowest = -2, .highest = 3};
  EXPECT_EQ(converted(spec, -2.0001), -2);
  EXPECT_EQ(converted(spec, 3.5), 3);
  EXPECT_EQ(converted(spec, 2.9), 2.9);
  EXPECT_TRUE(std::isnan(converted(spec, std::nan(""))));
}

TEST(Signal, CountsInStepsOfItsResolution) {
  const double step = 2 * pi / 4096;
  EXPECT_EQ(converted({.resolution = step}, 0.49 * step), 0);
  EXPECT_EQ(converted({.resolution = step}, 0.51 * step), step);
  EXPECT_EQ(converted({.resolution = step}, -1.4 * step), -step);
}

// 4 bits from -8 to 8: codes 0 to 15, so -8 to 7.
TEST(Signal, ConvertsToTheCodesOfItsBits) {
  const SignalSpec spec{.lowest = -8, .highest = 8, .bits = 4};
  EXPECT_EQ(converted(spec, 0.4), 0);
  EXPECT_EQ(converted(spec, 0.6), 1);
  EXPECT_EQ(converted(spec, 7.8), 7);
  EXPECT_EQ(converted(spec, 100), 7);
  EXPECT_EQ(converted(spec, -100), -8);
  EXPECT_EQ(converted({.lowest = -8, .highest = 8, .bits = 1}, 100), 0) << "one bit: -8 or 0";
}

// A sine through the filter: the amplitude of a first-order low-pass, 1/sqrt(2) at its frequency.
TEST(Signal, LetsThroughWhatALowPassLetsThrough) {
  const double corner = 20, period = 0.001;
  for (const double frequency : {5.0, 20.0, 100.0}) {
    Signal signal({.low_pass = corner}, 1, one, {period, period});
    double squares = 0;
    for (int i = 0; i < 4000; ++i) {
      double value = std::sin(2 * pi * frequency * i * period);
      signal.disturb({&value, 1});
      if (i >= 2000) squares += value * value;
    }
    // bilinear: both frequencies are warped by the same map
    const double ratio = std::tan(pi * frequency * period) / std::tan(pi * corner * period);
    law::expect_near({.law = "low-pass of 20 Hz: amplitude of a sine",
                      .level = fmt::format("{} Hz", frequency),
                      .source = "first-order low-pass: 1/sqrt(1 + (f/fc)^2)"},
                     std::sqrt(squares / 1000), 1 / std::sqrt(1 + ratio * ratio), 1e-6, "1");
  }
}

/// Deviation of a constant error over many sensors.
double spread(const SignalSpec& spec, double value, int numbers) {
  double squares = 0;
  for (int i = 0; i < numbers; ++i) {
    Signal signal(spec, 1, {fmt::format("robot/sensor/{}", i)}, {});
    double shown = value;
    signal.disturb({&shown, 1});
    squares += (shown - value) * (shown - value);
  }
  return std::sqrt(squares / numbers);
}

TEST(Signal, DrawsConstantErrorsOnce) {
  EXPECT_NEAR(spread({.bias = 0.2}, 5, 4000), 0.2, 0.01);
  EXPECT_NEAR(spread({.scale_error = 0.03}, 5, 4000), 0.15, 0.01);
  Signal signal({.scale_error = 0.1, .bias = 0.2}, 1, one, {});
  double first = 1, second = 1;
  signal.disturb({&first, 1});
  signal.disturb({&second, 1});
  EXPECT_EQ(first, second);
  EXPECT_NE(first, 1);
}

TEST(Signal, MisalignmentMixesAxesOnly) {
  Signal signal({.misalignment = 0.02}, 1, three, {});
  std::array<double, 3> values{1, 0, 0};
  signal.disturb(values);
  EXPECT_EQ(values[0], 1);
  EXPECT_NE(values[1], 0);
  EXPECT_NE(values[2], 0);
  EXPECT_LT(std::abs(values[1]), 0.1);
}

TEST(Signal, NamesAndSeedsTellStreamsApart) {
  const auto first = [](std::uint64_t seed, const std::string& name) {
    Signal signal({.noise = 1}, seed, {name}, {});
    double value = 0;
    signal.convert({&value, 1});
    return value;
  };
  EXPECT_EQ(first(1, "a"), first(1, "a"));
  EXPECT_NE(first(1, "a"), first(1, "b"));
  EXPECT_NE(first(1, "a"), first(2, "a"));
}

TEST(Signal, NamesWhatIsImpossible) {
  const auto error = [](const SignalSpec& spec) { return fixtures::error_of([&] { Signal(spec, 1, one, {}); }); };
  EXPECT_EQ(error({.noise_density = -1}), "'noise_density' is -1; it must be in the range from 0 unit/sqrt(Hz)");
  EXPECT_EQ(error({.bias = std::nan("")}), "'bias' is nan; it must be in the range from 0 unit");
  EXPECT_EQ(error({.lowest = 2, .highest = 1}), "the range from 2 to 1 is empty");
  EXPECT_EQ(error({.bits = 12}), "bits needs a range: range, or lowest and highest");
  EXPECT_EQ(error({.lowest = 0, .highest = 1, .bits = 40}),
            "'bits' is 40; it must be a whole number in the range 0 to 32");
  EXPECT_EQ(error({.lowest = 0, .highest = 1, .resolution = 1, .bits = 4}),
            "bits and resolution both say how long a step of the converter is; keep one");
  EXPECT_EQ(error({.misalignment = 0.1}), "misalignment is of three axes; 'robot/sensor/value' is one of 1 numbers");
}

}  // namespace
}  // namespace murosimf::sensors
