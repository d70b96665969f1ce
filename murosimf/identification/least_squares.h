/// least_squares.h - least squares in three unknowns: linear ones by their normal equations, others by Gauss and Newton.
#pragma once

#include <functional>
#include <span>

#include "murosimf/math/mat3.h"

namespace murosimf::identification {

/// Minimizes sum_i (row_i . p - value_i)^2. Unknowns that are not needed have zeros in all rows.
class NormalEquations {
 public:
  void add(const Vec3d& row, double value);
  /// Zero for unknowns that no row has.
  [[nodiscard]] Vec3d solution() const;
  [[nodiscard]] SymMat3d inverse_matrix() const;

 private:
  SymMat3d matrix_ = diagonal(0.0);
  Vec3d right_;
};

struct LeastSquares {
  Vec3d parameters;
  SymMat3d covariance;  ///< of the parameters, from the residuals; zero for parameters without effect
  double residual = 0;  ///< root mean square of the residuals
};

/// The parameters of model(parameters, time) that fit `values` at `times` best, searched from `start` on. Steps that do not reduce
/// the residuals are halved; the search ends when no step does.
[[nodiscard]] LeastSquares fit_curve(const std::function<double(const Vec3d&, double)>& model, const Vec3d& start,
                                     std::span<const double> times, std::span<const double> values);

}  // namespace murosimf::identification
