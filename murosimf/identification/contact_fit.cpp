#include "murosimf/identification/contact_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/identification/least_squares.h"
#include "murosimf/math/assert.h"
#include "murosimf/math/scalar.h"
#include "murosimf/model/error.h"

namespace murosimf::identification {
namespace {

constexpr std::size_t fewest_in_run = 8;
constexpr double most_without_stop = 0.98;  // [1] of the way that the start of the search uses as unbroken motion
constexpr double least_rate = 1e-9;         // [m/s^2]

[[noreturn]] void refuse(const Track& track, const std::string& why) {
  throw SetupError(fmt::format("{}: {}", track.name, why));
}

/// Start, speed and rate of a body that slows down.
struct Brake {
  double start = 0, speed = 0, rate = 0;  // [m], [m/s], [m/s^2]

  [[nodiscard]] double at(double t, double drag) const {
    MUROSIMF_ASSERT(t >= 0);
    const double a = std::max(rate, least_rate);
    if (drag == 0) {
      const double until = std::clamp(speed / a, 0.0, t);
      return start + (speed - 0.5 * a * until) * until;
    }
    const double b = std::sqrt(a * drag), phase = std::atan(speed * std::sqrt(drag / a));
    const double until = std::clamp(phase / b, 0.0, t);
    return start + std::log(std::cos(phase - b * until) / std::cos(phase)) / drag;
  }
};

/// Times from the first sample on, and distances along the line from the first place to the last.
struct Way {
  std::vector<double> times, ways;
  Vec3d direction;
};

Way way_of(const Track& track) {
  if (track.times.size() < fewest_in_run) {
    refuse(track, fmt::format("{} samples; a run needs {}", track.times.size(), fewest_in_run));
  }
  Vec3d chord = track.places.back() - track.places.front();
  chord.z = 0;
  if (!(norm(chord) > 0)) refuse(track, "its last place is its first one");
  Way way{.times = {}, .ways = {}, .direction = (1 / norm(chord)) * chord};
  for (std::size_t i = 0; i < track.times.size(); ++i) {
    way.times.push_back(track.times[i] - track.times.front());
    way.ways.push_back(dot(way.direction, track.places[i] - track.places.front()));
  }
  return way;
}

/// Fits a parabola to the samples before the end of the way.
Brake parabola_of(const Track& track, const Way& way) {
  MUROSIMF_ASSERT(way.times.size() == way.ways.size());
  NormalEquations sums;
  std::size_t used = 0;
  for (std::size_t i = 0; i < way.times.size(); ++i) {
    if (way.ways[i] > most_without_stop * way.ways.back()) break;
    const double t = way.times[i];
    sums.add({1, t, -0.5 * t * t}, way.ways[i]);
    ++used;
  }
  if (used < fewest_in_run)
    refuse(track, fmt::format("{} samples before it stops; {} are needed", used, fewest_in_run));
  const Vec3d found = sums.solution();
  // Without curvature the search would have no gradient: a little is assumed.
  return {found.x, found.y, std::max(found.z, 1e-3 * found.y * found.y / way.ways.back())};
}

}  // namespace

Braking fit_braking(const Track& track, double drag) {
  const Way way = way_of(track);
  const Brake first = parabola_of(track, way);
  const auto model = [&](const Vec3d& p, double t) { return Brake{p.x, p.y, p.z}.at(t, drag); };
  const LeastSquares fit = fit_curve(model, {first.start, first.speed, first.rate}, way.times, way.ways);
  const double rate = fit.parameters.z, error = std::sqrt(fit.covariance.zz);
  if (!(rate > 10 * least_rate)) refuse(track, "it does not slow down");
  if (!std::isfinite(rate + error)) refuse(track, "its places fit no run that slows down");
  return {{rate, error, fit.residual}, fit.parameters.y, way.direction};
}

double known_error(std::span<const Estimate> runs) {
  MUROSIMF_ASSERT(!runs.empty());
  double squares = 0;
  for (const Estimate& run : runs) squares += run.error * run.error;
  return std::sqrt(squares) / static_cast<double>(runs.size());
}

Estimate mean_of(std::span<const Estimate> runs) {
  MUROSIMF_ASSERT(!runs.empty());
  const double n = static_cast<double>(runs.size());
  Estimate mean;
  double scatter = 0, squares = 0;
  for (const Estimate& run : runs) {
    mean.value += run.value / n;
    squares += run.residual * run.residual / n;
  }
  for (const Estimate& run : runs) scatter += (run.value - mean.value) * (run.value - mean.value);
  const double scattered = runs.size() > 1 ? std::sqrt(scatter / (n * (n - 1))) : 0;
  mean.error = std::max(known_error(runs), scattered);
  mean.residual = std::sqrt(squares);
  return mean;
}

std::optional<Lean> fit_lean(std::span<const Braking> runs) {
  std::vector<double> headings;
  NormalEquations sums;
  for (const Braking& run : runs) {
    headings.push_back(std::atan2(run.direction.y, run.direction.x));
    sums.add({1, -run.direction.x, -run.direction.y}, run.value);
  }
  // Directions must surround the origin: otherwise mean and lean cannot be separated.
  std::ranges::sort(headings);
  double widest_gap = headings.empty() ? 2 * pi : headings.front() + 2 * pi - headings.back();
  for (std::size_t i = 1; i < headings.size(); ++i) widest_gap = std::max(widest_gap, headings[i] - headings[i - 1]);
  if (headings.size() < 3 || widest_gap > pi) return {};
  const Vec3d found = sums.solution();
  const Vec3d lean{found.y, found.z, 0};
  const double size = norm(lean);
  return Lean{found.x, size / found.x, size > 0 ? (1 / size) * lean : Vec3d{1, 0, 0}};
}

}  // namespace murosimf::identification
