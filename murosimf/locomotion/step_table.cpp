#include "murosimf/locomotion/step_table.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::locomotion {
namespace {

using Terms = std::array<double, step_terms>;
using Bin = std::array<Terms, step_signals>;

Terms terms_of(const Vec3d& velocity) noexcept { return {1, velocity.x, velocity.y, velocity.z}; }

double value(const Terms& factors, const Terms& terms) noexcept {
  double sum = 0;
  for (std::size_t i = 0; i < step_terms; ++i) sum += factors[i] * terms[i];
  return sum;
}

/// The normal equations of one bin: A x_k = B_k.
struct Sums {
  std::array<Terms, step_terms> A{};
  Bin B{};
  int count = 0;

  void add(const StepSample& sample) {
    const Terms u = terms_of(sample.velocity);
    MUROSIMF_ASSERT(std::isfinite(sample.share));
    const auto s = sample.signals.numbers();
    for (std::size_t i = 0; i < step_terms; ++i) {
      for (std::size_t j = 0; j < step_terms; ++j) A[i][j] += u[i] * u[j];
      for (std::size_t k = 0; k < step_signals; ++k) B[k][i] += u[i] * s[k];
    }
    ++count;
  }

  /// Solves by elimination; a small weight on the diagonal decides where the samples do not (a velocity that none of them has: 0).
  [[nodiscard]] Bin solve() const {
    // The weight also makes the matrix positive definite, so that no pivoting is needed.
    constexpr double weight = 1e-3;
    auto a = A;
    Bin b = B;
    for (std::size_t i = 0; i < step_terms; ++i) a[i][i] += weight;
    for (std::size_t i = 0; i < step_terms; ++i) {
      for (std::size_t row = i + 1; row < step_terms; ++row) {
        MUROSIMF_ASSERT(a[i][i] > 0);
        const double factor = a[row][i] / a[i][i];
        for (std::size_t j = i; j < step_terms; ++j) a[row][j] -= factor * a[i][j];
        for (Terms& right : b) right[row] -= factor * right[i];
      }
    }
    for (Terms& x : b) {
      for (std::size_t i = step_terms; i-- > 0;) {
        for (std::size_t j = i + 1; j < step_terms; ++j) x[i] -= a[i][j] * x[j];
        x[i] /= a[i][i];
      }
    }
    return b;
  }
};

}  // namespace

StepSignals steady_signals(const StepTable& table, double compliance, double share, const Vec3d& velocity) noexcept {
  constexpr double last = step_bins - 1;
  const double place = std::clamp(share * step_bins - 0.5, 0.0, last);
  const auto first = static_cast<std::size_t>(std::floor(place));
  MUROSIMF_ASSERT(!(first >= step_bins));
  const std::size_t next = std::min(first + 1, step_bins - 1);
  const double t = place - static_cast<double>(first);
  const Terms terms = terms_of(velocity);
  const auto at = [&](const StepCourse& course, std::size_t signal) {
    return (1 - t) * value(course[first][signal], terms) + t * value(course[next][signal], terms);
  };
  std::array<double, step_signals> s{};
  for (std::size_t k = 0; k < step_signals; ++k)
    s[k] = (1 - compliance) * at(table.rigid, k) + compliance * at(table.compliant, k);
  return {s[0], s[1], s[2], s[3], s[4], s[5]};
}

StepCourse fit_course(std::span<const StepSample> samples) {
  std::array<Sums, step_bins> sums;
  for (const StepSample& sample : samples) {
    const auto bin = static_cast<std::size_t>(std::clamp(sample.share, 0.0, 1.0) * step_bins);
    sums[std::min(bin, step_bins - 1)].add(sample);
  }
  StepCourse course{};
  const Sums* known = nullptr;
  for (const Sums& bin : sums) {
    if (!known && bin.count > 0) known = &bin;
    // Empty bins before the first known one get the values of that.
  }
  for (std::size_t i = 0; known && i < step_bins; ++i) {
    if (sums[i].count > 0) known = &sums[i];
    course[i] = known->solve();
  }
  return course;
}

}  // namespace murosimf::locomotion
