#include "murosimf/identification/least_squares.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::identification {
namespace {

constexpr int most_steps = 100, most_halvings = 30;
constexpr double small_change = 1e-6;  // [1] of a parameter, for differences
constexpr double no_gain = 1e-12;      // [1] of the sum of squares

using Curve = std::function<double(const Vec3d&, double)>;

double sum_of_squares(const Curve& model, const Vec3d& p, std::span<const double> times,
                      std::span<const double> values) {
  MUROSIMF_ASSERT(times.size() == values.size());
  double sum = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double left = values[i] - model(p, times[i]);
    sum += left * left;
  }
  return sum;
}

Vec3d gradient(const Curve& model, const Vec3d& p, double time) {
  const auto along = [&](double Vec3d::*of) {
    const double h = small_change * std::max(std::abs(p.*of), 1e-2);
    Vec3d more = p, less = p;
    more.*of += h;
    less.*of -= h;
    return (model(more, time) - model(less, time)) / (2 * h);
  };
  return {along(&Vec3d::x), along(&Vec3d::y), along(&Vec3d::z)};
}

NormalEquations equations(const Curve& model, const Vec3d& p, std::span<const double> times,
                          std::span<const double> values) {
  NormalEquations sums;
  for (std::size_t i = 0; i < times.size(); ++i) {
    sums.add(gradient(model, p, times[i]), values[i] - model(p, times[i]));
  }
  return sums;
}

}  // namespace

void NormalEquations::add(const Vec3d& row, double value) {
  matrix_ += outer(row);
  right_ += value * row;
}

/// Inverse of the matrix. Unknowns without a row get one in the diagonal, which the right side makes zero.
SymMat3d NormalEquations::inverse_matrix() const {
  SymMat3d filled = matrix_;
  for (double SymMat3d::*entry : {&SymMat3d::xx, &SymMat3d::yy, &SymMat3d::zz}) {
    if (filled.*entry == 0) filled.*entry = 1;
  }
  return inverse(filled);
}

Vec3d NormalEquations::solution() const { return inverse_matrix() * right_; }

LeastSquares fit_curve(const Curve& model, const Vec3d& start, std::span<const double> times,
                       std::span<const double> values) {
  MUROSIMF_ASSERT(times.size() == values.size() && !times.empty());
  Vec3d p = start;
  double sum = sum_of_squares(model, p, times, values);
  for (int step = 0; step < most_steps; ++step) {
    Vec3d change = equations(model, p, times, values).solution();
    double next = sum_of_squares(model, p + change, times, values);
    // The step of Gauss and Newton may overshoot: it is halved until it helps.
    for (int i = 0; i < most_halvings && !(next < sum); ++i) {
      change = 0.5 * change;
      next = sum_of_squares(model, p + change, times, values);
    }
    if (!(next < sum)) break;
    const bool settled = sum - next < no_gain * sum;
    p = p + change;
    sum = next;
    if (settled) break;
  }
  const double n = static_cast<double>(times.size());
  const SymMat3d spread = equations(model, p, times, values).inverse_matrix();
  return {p, (sum / std::max(1.0, n - 3)) * spread, std::sqrt(sum / n)};
}

}  // namespace murosimf::identification
