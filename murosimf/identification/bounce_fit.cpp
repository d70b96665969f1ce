// The drops of contact_fit.h.
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "murosimf/identification/contact_fit.h"
#include "murosimf/identification/least_squares.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::identification {
namespace {

constexpr double least_swing = 0.03;         // [1] of the whole height: lower bounces are ignored
constexpr double lowest_used = 0.25;         // [1] of a flight's height: below, the ball may touch the ground
constexpr double highest_used = 0.85;        // [1] of the first fall: above, a hand may hold the ball
constexpr std::size_t fewest_in_flight = 4;  // in a flight
constexpr int corrections = 4;               // of the drag by the speeds that the flight before gave
constexpr int newton_steps = 20;

/// A flight: z = height + speed s - g s^2 / 2 + (drag's share), s from `middle` on.
struct Flight {
  double middle = 0;              // [s]
  double height = 0, speed = 0;   // [m], [m/s] there
  double gravity = 0, drag = 0;   // [m/s^2], [1/m]
  double variance_per_speed = 0;  // [1/s^2] variance of the speed per variance of a place
  double squares = 0;             // [m^2] sum of squared residuals
  std::size_t samples = 0;

  /// [m] Displacement by the drag -k w |w|, w = speed - g s: integrated twice.
  [[nodiscard]] double shift(double s) const {
    MUROSIMF_ASSERT(gravity > 0);
    const double w = speed - gravity * s, cubed = std::abs(w * w * w), cubed_before = std::abs(speed * speed * speed);
    return drag / (3 * gravity) * ((speed * cubed_before - w * cubed) / (4 * gravity) - cubed_before * s);
  }
  [[nodiscard]] double z(double t) const {
    const double s = t - middle;
    return height + (speed - 0.5 * gravity * s) * s + shift(s);
  }
  [[nodiscard]] double velocity(double t) const {
    const double w = speed - gravity * (t - middle);
    return w + drag / (3 * gravity) * (std::abs(w * w * w) - std::abs(speed * speed * speed));
  }
};

/// Numbers of the samples at the lowest points.
std::vector<std::size_t> lowest_samples(const std::vector<double>& z) {
  MUROSIMF_ASSERT(!z.empty());
  const auto [low, high] = std::ranges::minmax_element(z);
  const double swing = least_swing * (*high - *low);
  std::vector<std::size_t> found;
  std::size_t extreme = 0;
  bool falls = true;
  for (std::size_t i = 1; i < z.size(); ++i) {
    // A turn counts when the height has left its extreme by the least swing: noise makes no bounces.
    if (falls ? z[i] <= z[extreme] : z[i] >= z[extreme]) {
      extreme = i;
    } else if (std::abs(z[i] - z[extreme]) > swing) {
      if (falls && extreme > 0) found.push_back(extreme);
      falls = !falls;
      extreme = i;
    }
  }
  return found;
}

struct Samples {
  const std::vector<double>&t, &z;
};

/// Fits a flight by least squares over samples first to last - 1.
Flight fit_flight(const Samples& samples, std::size_t first, std::size_t last, double gravity, double drag) {
  MUROSIMF_ASSERT(first < last && last <= samples.t.size());
  Flight flight{.gravity = gravity, .drag = drag};
  const double n = static_cast<double>(last - first);
  for (std::size_t i = first; i < last; ++i) flight.middle += samples.t[i] / n;
  // The drag depends on the speeds that are sought: it is corrected by those of the last pass.
  for (int pass = 0; pass < (drag > 0 ? corrections : 1); ++pass) {
    const Flight before = flight;
    NormalEquations sums;
    double spread = 0;
    for (std::size_t i = first; i < last; ++i) {
      const double s = samples.t[i] - flight.middle;
      sums.add({1, s, 0}, samples.z[i] + 0.5 * gravity * s * s - before.shift(s));
      spread += s * s;
    }
    const Vec3d found = sums.solution();
    flight.height = found.x;
    flight.speed = found.y;
    flight.variance_per_speed = 1 / spread;
  }
  for (std::size_t i = first; i < last; ++i) {
    const double left = samples.z[i] - flight.z(samples.t[i]);
    flight.squares += left * left;
  }
  flight.samples = last - first;
  return flight;
}

/// Fits the samples from `begin` to before `end` that certainly fly, above a floor. The first fall has no sample near its top.
std::optional<Flight> flight_in(const Samples& samples, std::size_t begin, std::size_t end, double floor,
                                bool first_fall, double gravity, double drag) {
  MUROSIMF_ASSERT(begin < end && end <= samples.z.size());
  const auto highest = std::max_element(samples.z.begin() + static_cast<std::ptrdiff_t>(begin),
                                        samples.z.begin() + static_cast<std::ptrdiff_t>(end));
  const double height = *highest - floor;
  std::size_t first = begin, last = end;
  if (first_fall) {
    for (std::size_t i = begin; i < end; ++i) {
      if (samples.z[i] - floor > highest_used * height) first = i + 1;
    }
  } else {
    while (first < end && samples.z[first] - floor < lowest_used * height) ++first;
  }
  last = first;
  while (last < end && samples.z[last] - floor >= lowest_used * height) ++last;
  if (last - first < fewest_in_flight) return {};
  return fit_flight(samples, first, last, gravity, drag);
}

/// [s] Time at which the body leaves one flight and begins the next, by Newton's method from `guess`.
double meeting(const Flight& before, const Flight& after, double guess) {
  double t = guess;
  for (int i = 0; i < newton_steps; ++i) {
    const double slope = before.velocity(t) - after.velocity(t);
    if (slope == 0) break;
    t -= (before.z(t) - after.z(t)) / slope;
  }
  return t;
}

/// Sums over all bounces for e = after / before.
struct BounceSums {
  double products = 0, squares = 0, afters = 0, unknown = 0;
  int count = 0;
  void add(double before, double after, double variance) {
    products += before * after;
    squares += before * before;
    afters += after * after;
    unknown += before * before * variance;
    ++count;
  }
};

std::vector<Flight> flights_of(const Samples& samples, const std::vector<std::size_t>& lows, double gravity,
                               double drag) {
  std::vector<Flight> flights;
  for (std::size_t k = 0; k <= lows.size(); ++k) {
    const std::size_t begin = k == 0 ? 0 : lows[k - 1] + 1, end = k < lows.size() ? lows[k] : samples.z.size();
    const double floor = samples.z[k == 0 ? lows[0] : lows[k - 1]];
    if (begin >= end) break;
    const auto flight = flight_in(samples, begin, end, floor, k == 0, gravity, drag);
    if (!flight) break;
    flights.push_back(*flight);
  }
  return flights;
}

}  // namespace

Bouncing fit_bounces(const Track& track, double gravity, double drag) {
  std::vector<double> z;
  for (const Vec3d& place : track.places) z.push_back(place.z);
  const Samples samples{track.times, z};
  const std::vector<std::size_t> lows = z.empty() ? std::vector<std::size_t>{} : lowest_samples(z);
  if (lows.empty()) throw SetupError(fmt::format("{}: it does not bounce", track.name));
  const std::vector<Flight> flights = flights_of(samples, lows, gravity, drag);
  if (flights.size() < 2) {
    throw SetupError(fmt::format("{}: fewer than {} samples in the flight before or after its first bounce", track.name,
                                 fewest_in_flight));
  }
  double left = 0, used = 0;
  for (const Flight& flight : flights) {
    left += flight.squares;
    used += static_cast<double>(flight.samples);
  }
  const double variance = left / std::max(1.0, used - 2 * static_cast<double>(flights.size()));  // [m^2] of a place
  BounceSums sums;
  // Least squares through the origin: fast bounces are measured best, and weigh most.
  for (std::size_t k = 0; k + 1 < flights.size(); ++k) {
    const double t = meeting(flights[k], flights[k + 1], track.times[lows[k]]);
    const double before = -flights[k].velocity(t), after = flights[k + 1].velocity(t);
    const double e = after / before;
    sums.add(before, after, variance * (flights[k + 1].variance_per_speed + e * e * flights[k].variance_per_speed));
  }
  const double e = sums.products / sums.squares;
  if (!(e > 0 && e <= 1)) throw SetupError(fmt::format("{}: it leaves the ground faster than it came", track.name));
  const double known = sums.unknown / (sums.squares * sums.squares);
  const double scatter =
      sums.count > 1 ? std::max(0.0, sums.afters - e * sums.products) / ((sums.count - 1) * sums.squares) : 0;
  return {{e, std::sqrt(std::max(known, scatter)), std::sqrt(left / used)}, sums.count};
}

}  // namespace murosimf::identification
