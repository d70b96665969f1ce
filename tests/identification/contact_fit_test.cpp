// Rolls, slides and drops of known numbers, with and without noise.
#include "murosimf/identification/contact_fit.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "murosimf/math/random.h"
#include "murosimf/model/error.h"
#include "tests/law.h"

namespace murosimf::identification {
namespace {

constexpr double g = 9.81;

/// Noise [m] of sample i.
double noise(double deviation, std::uint64_t seed, std::uint64_t i) {
  return deviation == 0 ? 0 : deviation * RandomStream(seed, "noise").normal(i);
}

/// A body of v [m/s] in the direction `heading` [rad] that loses a + k v^2 [m/s^2] in steps of 10 us, seen `hz` times per second for
/// `seconds`.
Track braking_track(double v, double a, double k, double heading, double hz, double seconds, double deviation = 0,
                    std::uint64_t seed = 1) {
  constexpr double h = 1e-5;
  Track track{"track", {}, {}};
  double s = 0;
  const int every = static_cast<int>(std::lround(1 / (hz * h)));
  for (int i = 0; i * h <= seconds; ++i) {
    if (i % every == 0) {
      const std::uint64_t n = track.times.size();
      track.times.push_back(3 + i * h);
      track.places.push_back(Vec3d{1 + s * std::cos(heading) + noise(deviation, seed, 2 * n),
                                   2 + s * std::sin(heading) + noise(deviation, seed, 2 * n + 1), 0.05});
    }
    const double next = std::max(0.0, v - h * (a + k * v * v));
    s += h * (v + next) / 2;
    v = next;
  }
  return track;
}

TEST(FitBraking, FindsTheRateOfBodiesThatStopAndThatDoNot) {
  law::Worst error;
  for (const double k : {0.0, 0.02, 0.2}) {
    for (const double seconds : {1.5, 20.0}) {  // it stops after 4 s and more
      for (const double heading : {0.0, 2.0, -1.2}) {
        const Braking found = fit_braking(braking_track(2, 0.4, k, heading, 50, seconds), k);
        error.see(std::abs(found.value - 0.4), k, seconds, heading);
        EXPECT_NEAR(found.direction.x, std::cos(heading), 1e-6);
        EXPECT_NEAR(found.speed, 2, 1e-3);
      }
    }
  }
  law::expect_below({.law = "fit of a roll without noise, with and without air and stop: deviation of 0.4 m/s^2",
                     .level = "fit-contact",
                     .source = "integrated in steps of 10 us"},
                    error, 1e-4, "m/s^2");
}

// Without the drag of the air the result is too large.
TEST(FitBraking, AirIsNotFriction) { EXPECT_GT(fit_braking(braking_track(2, 0.4, 0.05, 0, 50, 20), 0).value, 0.42); }

/// Of `runs` with noise: error of the mean in its own standard errors, and the mean of squared deviations over squared errors.
struct Noisy {
  double worst = 0, ratio = 0;
};

template <class Fit>
Noisy with_noise(int runs, double truth, const Fit& fit) {
  Noisy noisy;
  for (int i = 1; i <= runs; ++i) {
    const Estimate found = fit(static_cast<std::uint64_t>(i));
    noisy.worst = std::max(noisy.worst, std::abs(found.value - truth) / truth);
    noisy.ratio += std::pow((found.value - truth) / found.error, 2) / runs;
  }
  return noisy;
}

TEST(FitBraking, KnowsItsErrorWithNoise) {
  const Noisy noisy = with_noise(200, 0.4, [](std::uint64_t seed) {
    return fit_braking(braking_track(2, 0.4, 0, 1, 50, 8, 0.003, seed), 0);
  });
  law::expect_below({.law = "fit of 200 rolls seen with 3 mm of noise at 50 Hz: largest deviation, as a part",
                     .level = "fit-contact",
                     .source = "the number that they were made with"},
                    noisy.worst, 0.003, "");
  // chi squared of 200: +-20 % is two standard deviations
  law::expect_between({.law = "fit of 200 rolls with noise: mean of (deviation / standard error)^2",
                       .level = "fit-contact",
                       .source = "chi squared: 1"},
                      noisy.ratio, 0.7, 1.3, "");
}

TEST(FitBraking, RefusesWhatIsNoRun) {
  Track track = braking_track(2, 0.4, 0, 0, 50, 1);
  EXPECT_THROW((void)fit_braking(braking_track(2, -0.4, 0, 0, 50, 1), 0), SetupError) << "it gets faster";
  track.places.resize(5);
  track.times.resize(5);
  EXPECT_THROW((void)fit_braking(track, 0), SetupError) << "too short";
  for (Vec3d& place : track.places) place = {};
  EXPECT_THROW((void)fit_braking(track, 0), SetupError) << "it does not move";
}

/// A ball that is released at 1 s, `height` above its lowest place, and bounces with e; recorded for 4 s.
Track dropped(double height, double e, double hz, double deviation = 0, std::uint64_t seed = 1, double k = 0) {
  constexpr double h = 1e-5;
  Track track{"drop", {}, {}};
  double z = height, v = 0;
  const int every = static_cast<int>(std::lround(1 / (hz * h)));
  for (int i = 0; i * h <= 4; ++i) {
    if (i % every == 0) {
      const std::uint64_t n = track.times.size();
      track.times.push_back(i * h);
      track.places.push_back({0, 0, 0.11 + z + noise(deviation, seed, n)});
    }
    if (i * h < 1) continue;
    const double next = v - h * (g + k * v * std::abs(v));
    z += h * (v + next) / 2;
    v = next;
    if (z < 0 && v < 0) v = -e * v;
  }
  return track;
}

TEST(FitBounces, FindsTheRestitutionWhateverTheFloor) {
  law::Worst error;
  for (const double e : {0.3, 0.6, 0.85}) {
    for (const double k : {0.0, 0.03}) {
      const Bouncing found = fit_bounces(dropped(1.5, e, 60, 0, 1, k), g, k);
      error.see(std::abs(found.value - e), e, k);
      EXPECT_GE(found.bounces, e > 0.5 ? 3 : 1);
    }
  }
  law::expect_below(
      {.law =
           "fit of a ball that falls 1.5 m and bounces, seen at 60 Hz, with and without air: deviation of 0.3 to 0.85",
       .level = "fit-contact",
       .source = "integrated in steps of 10 us"},
      error, 2e-3, "");
}

TEST(FitBounces, KnowsItsErrorWithNoise) {
  const Noisy noisy =
      with_noise(100, 0.6, [](std::uint64_t seed) { return fit_bounces(dropped(1.5, 0.6, 60, 0.003, seed), g, 0); });
  law::expect_below({.law = "fit of 100 drops seen with 3 mm of noise at 60 Hz: largest deviation, as a part",
                     .level = "fit-contact",
                     .source = "the number that they were made with"},
                    noisy.worst, 0.01, "");
  EXPECT_LT(noisy.ratio, 2) << "it promises too much";
}

TEST(FitBounces, RefusesWhatDoesNotBounce) {
  EXPECT_THROW((void)fit_bounces(dropped(1.5, 0, 60), g, 0), SetupError);
  EXPECT_THROW((void)fit_bounces({"empty", {}, {}}, g, 0), SetupError);
  EXPECT_THROW((void)fit_bounces(dropped(1.5, 0.6, 8), g, 0), SetupError) << "too few samples in a flight";
  EXPECT_THROW((void)fit_bounces(dropped(0.5, 1.2, 60), g, 0), SetupError) << "it wins energy";
}

// Two runs with larger own errors than scatter, and two with more scatter than own errors.
TEST(MeanOf, TakesTheLargerOfScatterAndErrors) {
  const std::vector<Estimate> close{{0.30, 0.02, 0}, {0.30, 0.02, 0}}, apart{{0.2, 0.01, 3e-3}, {0.4, 0.01, 4e-3}};
  EXPECT_NEAR(mean_of(close).error, 0.02 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(mean_of(apart).value, 0.3, 1e-12);
  EXPECT_NEAR(mean_of(apart).error, 0.1, 1e-12);
  EXPECT_NEAR(mean_of(apart).residual, std::sqrt(12.5) * 1e-3, 1e-12);
}

TEST(FitLean, FindsWhereThePileLeans) {
  std::vector<Braking> slides;
  for (const double heading : {0.3, 1.9, 3.6, 5.2}) {
    Braking slide;
    slide.direction = {std::cos(heading), std::sin(heading), 0};
    slide.value = 0.5 * (1 - 0.2 * std::cos(heading - 0.7));
    slides.push_back(slide);
  }
  const auto lean = fit_lean(slides);
  ASSERT_TRUE(lean);
  EXPECT_NEAR(lean->mean, 0.5, 1e-12);
  EXPECT_NEAR(lean->anisotropy, 0.2, 1e-12);
  EXPECT_NEAR(lean->direction.y, std::sin(0.7), 1e-12);
  slides.resize(2);
  EXPECT_FALSE(fit_lean(slides)) << "two directions";
}

}  // namespace
}  // namespace murosimf::identification
