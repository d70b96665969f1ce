#include "murosimf/imaging/lens_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/math/scalar.h"
#include "murosimf/model/error.h"

namespace murosimf::imaging {
namespace {

/// A pixel of the first lens, and its ray.
struct Sample {
  Pixel pixel;
  Vec3d ray;
};

std::vector<Sample> sampled(const Lens& lens, int most_to_a_side) {
  MUROSIMF_ASSERT(most_to_a_side > 0);
  const LensSpec& spec = lens.spec();
  const int columns = std::min(spec.width, most_to_a_side), rows = std::min(spec.height, most_to_a_side);
  const auto place = [](int i, int count, int size) { return count > 1 ? (size - 1.0) * i / (count - 1) : 0.0; };
  std::vector<Sample> samples;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const Pixel pixel{place(i, columns, spec.width), place(j, rows, spec.height)};
      if (const auto ray = lens.ray(pixel)) samples.push_back({pixel, *ray});
    }
  }
  return samples;
}

/// Numbers of the model in the order fx fy cx cy, the skew if the first lens has one, and coefficients, without a1 of
/// ray_polynomial.
class Problem {
 public:
  Problem(const std::vector<Sample>& samples, const LensSpec& start, std::string_view model)
      : samples_(samples), start_(start) {
    start_.model = model;
    start_.coefficients.clear();
  }

  [[nodiscard]] Eigen::VectorXd start() const {
    const int coefficients = start_.model == "perspective"           ? 0
                             : start_.model == "equidistant"         ? 4
                             : start_.model == "rational_polynomial" ? 8
                                                                     : 5;
    Eigen::VectorXd x = Eigen::VectorXd::Zero(before_coefficients() + coefficients);
    x.head(4) << start_.fx, start_.fy, start_.cx, start_.cy;
    if (skewed()) x[4] = start_.skew;
    return x;
  }

  [[nodiscard]] LensSpec spec(const Eigen::VectorXd& x) const {
    MUROSIMF_ASSERT(x.size() >= before_coefficients());
    LensSpec made = start_;
    made.fx = x[0];
    made.fy = x[1];
    made.cx = x[2];
    made.cy = x[3];
    if (skewed()) made.skew = x[4];
    if (made.model == "ray_polynomial") made.coefficients.push_back(1);
    made.coefficients.insert(made.coefficients.end(), x.begin() + before_coefficients(), x.end());
    return made;
  }

  /// Where the model sees the rays, less where they belong [px].
  [[nodiscard]] Eigen::VectorXd misses(const Eigen::VectorXd& x) const {
    const LensSpec now = spec(x);
    if (now.model == "equidistant") return angle_misses(now, AnglePolynomial::equidistant(now.coefficients));
    if (now.model == "ray_polynomial") return angle_misses(now, AnglePolynomial::powers(now.coefficients));
    return plane_misses(now, PlaneDistortion::formula(now.coefficients));
  }

  /// Derivatives of the misses, by central differences.
  [[nodiscard]] Eigen::MatrixXd slopes(const Eigen::VectorXd& x) const {
    Eigen::MatrixXd all(2 * samples_.size(), x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const double step = 1e-6 * std::max(1.0, std::fabs(x[i]));
      Eigen::VectorXd above = x, below = x;
      above[i] += step;
      below[i] -= step;
      all.col(i) = (misses(above) - misses(below)) / (above[i] - below[i]);
    }
    return all;
  }

 private:
  [[nodiscard]] bool skewed() const { return start_.skew != 0; }
  [[nodiscard]] Eigen::Index before_coefficients() const { return skewed() ? 5 : 4; }

  template <class Seen>
  [[nodiscard]] Eigen::VectorXd collect(const LensSpec& spec, const Seen& seen) const {
    Eigen::VectorXd all(2 * samples_.size());
    MUROSIMF_ASSERT(all.size() == 2 * static_cast<Eigen::Index>(samples_.size()));
    Eigen::Index i = 0;
    for (const Sample& sample : samples_) {
      const Pixel pixel = pixel_at(spec, seen(sample.ray));
      all[i++] = pixel.u - sample.pixel.u;
      all[i++] = pixel.v - sample.pixel.v;
    }
    return all;
  }

  [[nodiscard]] Eigen::VectorXd plane_misses(const LensSpec& spec, const PlaneDistortion& map) const {
    return collect(spec, [&](const Vec3d& ray) { return map.at({ray.x / ray.z, ray.y / ray.z}).to; });
  }

  [[nodiscard]] Eigen::VectorXd angle_misses(const LensSpec& spec, const AnglePolynomial& map) const {
    return collect(spec, [&](const Vec3d& ray) {
      const double aside = std::hypot(ray.x, ray.y);
      const double scale = aside > 0 ? map.at(std::atan2(aside, ray.z)).value / aside : 0;
      return PlanePoint{scale * ray.x, scale * ray.y};
    });
  }

  const std::vector<Sample>& samples_;
  LensSpec start_;
};

/// Minimizes the squares of the misses by the method of Levenberg and Marquardt.
Eigen::VectorXd least_squares(const Problem& problem) {
  Eigen::VectorXd x = problem.start(), misses = problem.misses(x);
  double damping = 1e-3;
  for (int i = 0; i < 300 && damping < 1e12; ++i) {
    const Eigen::MatrixXd slopes = problem.slopes(x);
    Eigen::MatrixXd curvature = slopes.transpose() * slopes;
    curvature.diagonal() *= 1 + damping;  // Marquardt's scaling: coefficients differ by orders of magnitude
    curvature.diagonal().array() += 1e-300;
    const Eigen::VectorXd next = x - curvature.ldlt().solve(slopes.transpose() * misses);
    const Eigen::VectorXd next_misses = problem.misses(next);
    const double before = misses.squaredNorm(), after = next_misses.squaredNorm();
    damping = after < before ? std::max(1e-15, damping / 10) : damping * 10;
    if (!(after < before)) continue;
    x = next;
    misses = next_misses;
    if (before - after < 1e-14 * before) break;
  }
  return x;
}

/// Rejects rays that a lens model of the plane cannot show.
void check_reach(const std::vector<Sample>& samples, std::string_view model) {
  const bool by_angle = model == "equidistant" || model == "ray_polynomial";
  double lowest = 1;
  for (const Sample& sample : samples) lowest = std::min(lowest, sample.ray.z);
  if (by_angle || lowest > 0.01) return;
  throw SetupError(fmt::format("'{}' cannot show rays {:.1f} deg from the axis; choose equidistant or ray_polynomial",
                               model, std::acos(lowest) * 180 / pi));
}

}  // namespace

LensFit fit_lens(const Lens& lens, const std::string& model) {
  if (std::ranges::find(lens_models(), model) == lens_models().end()) {
    throw SetupError(unknown_name("lens model", model, lens_models()));
  }
  if (lens.spec().model == model) return {.spec = lens.spec()};
  const std::vector<Sample> samples = sampled(lens, 40);
  check_reach(samples, model);
  const Problem problem(samples, lens.spec(), model);
  const Lens fitted(problem.spec(least_squares(problem)));
  LensFit fit{.spec = fitted.spec()};
  double squares = 0;
  const std::vector<Sample> all = sampled(lens, 400);
  for (const auto& [pixel, ray] : all) {
    const auto seen = fitted.project(ray);
    if (!seen) {
      throw SetupError(fmt::format("'{}' cannot show what this lens sees: the best fit folds over at {:.1f} deg", model,
                                   fitted.widest_angle() * 180 / pi));
    }
    const double error = std::hypot(seen->u - pixel.u, seen->v - pixel.v);
    squares += error * error;
    if (error < fit.largest_error) continue;
    fit.largest_error = error;
    fit.where = pixel;
  }
  fit.usual_error = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, all.size())));
  return fit;
}

}  // namespace murosimf::imaging
