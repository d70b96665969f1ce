#include "murosimf/studies/cma_es.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/math/random.h"
#include "murosimf/model/error.h"

namespace murosimf::studies {

/// Table 1 of the tutorial, with its letters. Not in the anonymous namespace: part of CmaEs::Inside.
struct CmaConstants {
  std::size_t lambda, mu;
  Eigen::VectorXd weights;  // of all ranks, also negative ones
  double mueff, c_sigma, d_sigma, c_c, c_1, c_mu, chi_n;
};

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

double sum_of_squares_ratio(const VectorXd& some) { return some.sum() * some.sum() / some.squaredNorm(); }

CmaConstants constants_of(std::size_t numbers, std::size_t population) {
  MUROSIMF_ASSERT(numbers > 0);
  const auto n = static_cast<double>(numbers);
  CmaConstants c{};
  c.lambda = population > 0 ? population : 4 + static_cast<std::size_t>(3 * std::log(n));
  c.mu = c.lambda / 2;
  MUROSIMF_ASSERT(c.lambda >= 2 && c.mu >= 1);
  const auto lambda = static_cast<Eigen::Index>(c.lambda), mu = static_cast<Eigen::Index>(c.mu);
  VectorXd w(lambda);
  for (Eigen::Index i = 0; i < lambda; ++i) {
    w[i] = std::log((static_cast<double>(lambda) + 1) / 2) - std::log(static_cast<double>(i) + 1);
  }
  c.mueff = sum_of_squares_ratio(w.head(mu));
  const double mueff_minus = sum_of_squares_ratio(w.tail(lambda - mu));
  c.c_sigma = (c.mueff + 2) / (n + c.mueff + 5);
  c.d_sigma = 1 + 2 * std::max(0.0, std::sqrt((c.mueff - 1) / (n + 1)) - 1) + c.c_sigma;
  c.c_c = (4 + c.mueff / n) / (n + 4 + 2 * c.mueff / n);
  c.c_1 = 2 / ((n + 1.3) * (n + 1.3) + c.mueff);
  c.c_mu = std::min(1 - c.c_1, 2 * (0.25 + c.mueff + 1 / c.mueff - 2) / ((n + 2) * (n + 2) + c.mueff));
  const double least = std::min({1 + c.c_1 / c.c_mu, 1 + 2 * mueff_minus / (mueff_minus + 2),
                                 (1 - c.c_1 - c.c_mu) / (n * c.c_mu)});  // the last one keeps C positive definite
  double positive = 0, negative = 0;
  for (const double one : w) (one >= 0 ? positive : negative) += std::abs(one);
  for (double& one : w) one *= one >= 0 ? 1 / positive : least / negative;
  c.weights = w;
  c.chi_n = std::sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n));
  MUROSIMF_ASSERT(c.mueff > 0 && c.chi_n > 0);
  return c;
}

/// As a ball between two walls.
double reflected(double x, double low, double high) {
  MUROSIMF_ASSERT(low < high);
  const double width = high - low;
  const double way = std::fmod(std::abs(x - low), 2 * width);  // |x - low|: the first wall
  return std::clamp(low + (way <= width ? way : 2 * width - way), low, high);
}

bool all_finite(const std::vector<double>& numbers) {
  return std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); });
}

/// Options come from files and programs, so they are errors of the user.
void check(const CmaEsOptions& options) {
  const std::size_t n = options.start.size();
  if (n == 0) throw SetupError("a search needs numbers to change");
  if (!all_finite(options.start)) throw SetupError("a search must start from finite numbers");
  if (!(options.sigma > 0) || !std::isfinite(options.sigma)) throw SetupError("the sigma of a search must be above 0");
  if (options.population == 1) throw SetupError("a generation needs two points at least");
  if (options.low.empty() && options.high.empty()) return;
  if (options.low.size() != n || options.high.size() != n) {
    throw SetupError(fmt::format("the box of a search over {} numbers has {} and {} sides", n, options.low.size(),
                                 options.high.size()));
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (!(options.low[i] < options.high[i]) || !std::isfinite(options.high[i] - options.low[i]))
      throw SetupError(fmt::format("number {} of a search has no room: {} to {}", i, options.low[i], options.high[i]));
  }
}

/// A state may come from a damaged or edited file.
void check(const CmaEsState& state, std::size_t n) {
  const bool fits = state.mean.size() == n && state.sigma_path.size() == n && state.path.size() == n &&
                    state.covariance.size() == n * n;
  if (!fits) throw SetupError(fmt::format("the state of a search is not of one over {} numbers", n));
  const bool good = state.sigma > 0 && std::isfinite(state.sigma) && all_finite(state.mean) &&
                    all_finite(state.sigma_path) && all_finite(state.path) && all_finite(state.covariance);
  if (!good) throw SetupError("the state of a search has impossible numbers");
}

/// Covariance 1: all numbers are equally uncertain at first.
CmaEsState first_state(const CmaEsOptions& options) {
  const std::size_t n = options.start.size();
  CmaEsState state{.sigma = options.sigma, .mean = options.start, .sigma_path = std::vector<double>(n)};
  state.path.resize(n);
  state.covariance.resize(n * n);
  for (std::size_t i = 0; i < n; ++i) state.covariance[i * n + i] = 1;
  return state;
}

/// The numbers as a vector of Eigen, without a copy.
Eigen::Map<VectorXd> view(std::vector<double>& numbers) {
  return {numbers.data(), static_cast<Eigen::Index>(numbers.size())};
}

}  // namespace

struct CmaEs::Inside {
  Inside(const CmaEsOptions& given, CmaEsState from)
      : options(given),
        constants(constants_of(given.start.size(), given.population)),
        random(given.seed, "cma_es"),
        state(std::move(from)) {
    decompose();
  }

  [[nodiscard]] std::size_t n() const { return options.start.size(); }
  [[nodiscard]] Eigen::Map<MatrixXd> covariance() {
    const auto size = static_cast<Eigen::Index>(n());
    return {state.covariance.data(), size, size};
  }

  /// Eigenvectors B and standard deviations D: C = B D^2 B^T.
  void decompose() {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(covariance());
    B = solver.eigenvectors();
    D = solver.eigenvalues().cwiseMax(1e-300).cwiseSqrt();  // rounding may make an eigenvalue negative
  }

  /// y = B D z of a point, the mean being m + sigma y.
  [[nodiscard]] VectorXd step_of(std::size_t point) const {
    MUROSIMF_ASSERT(point < constants.lambda);
    VectorXd z(static_cast<Eigen::Index>(n()));
    const std::uint64_t first = (state.generation * constants.lambda + point) * n();
    for (std::size_t i = 0; i < n(); ++i) z[static_cast<Eigen::Index>(i)] = random.normal(first + i);
    return B * D.cwiseProduct(z);
  }

  [[nodiscard]] std::vector<double> inside(std::vector<double> x) const {
    MUROSIMF_ASSERT(x.size() == n());
    if (options.low.empty()) return x;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = reflected(x[i], options.low[i], options.high[i]);
    return x;
  }

  [[nodiscard]] VectorXd without_scale(const VectorXd& y) const {  // C^(-1/2) y
    return B * (B.transpose() * y).cwiseQuotient(D);
  }

  void update(const std::vector<VectorXd>& ranked);

  CmaEsOptions options;
  CmaConstants constants;
  RandomStream random;
  CmaEsState state;
  MatrixXd B;
  VectorXd D;
};

/// Fig. 6 of the tutorial: `ranked` are the steps y, best first.
void CmaEs::Inside::update(const std::vector<VectorXd>& ranked) {
  MUROSIMF_ASSERT(ranked.size() == constants.lambda);
  const CmaConstants& c = constants;
  const auto size = static_cast<double>(n());
  VectorXd y_w = VectorXd::Zero(static_cast<Eigen::Index>(n()));
  for (std::size_t i = 0; i < c.mu; ++i) y_w += c.weights[static_cast<Eigen::Index>(i)] * ranked[i];
  view(state.mean) += state.sigma * y_w;

  auto p_sigma = view(state.sigma_path), p_c = view(state.path);
  p_sigma = (1 - c.c_sigma) * p_sigma + std::sqrt(c.c_sigma * (2 - c.c_sigma) * c.mueff) * without_scale(y_w);
  const double length = p_sigma.norm();
  // The path begins at 0: its expected length is smaller in the first generations.
  const double settled = std::sqrt(1 - std::pow(1 - c.c_sigma, 2 * (static_cast<double>(state.generation) + 1)));
  const double h = length / settled < (1.4 + 2 / (size + 1)) * c.chi_n ? 1 : 0;
  p_c = (1 - c.c_c) * p_c + h * std::sqrt(c.c_c * (2 - c.c_c) * c.mueff) * y_w;

  auto C = covariance();
  // While the path stalls (h = 0), C would lose variance, which is given back.
  const double lost = (1 - h) * c.c_c * (2 - c.c_c);
  MatrixXd next = (1 + c.c_1 * lost - c.c_1 - c.c_mu * c.weights.sum()) * C + c.c_1 * p_c * p_c.transpose();
  for (std::size_t i = 0; i < ranked.size(); ++i) {
    double weight = c.weights[static_cast<Eigen::Index>(i)];
    // The longer the step of a bad point, the less it may take from C, which stays positive definite so.
    if (weight < 0) weight *= size / std::max(without_scale(ranked[i]).squaredNorm(), 1e-300);
    next += c.c_mu * weight * ranked[i] * ranked[i].transpose();
  }
  // Rounding leaves C slightly unsymmetric.
  C = 0.5 * (next + next.transpose());
  const double growth = std::exp(c.c_sigma / c.d_sigma * (length / c.chi_n - 1));
  state.sigma = std::clamp(state.sigma * growth, 1e-150, 1e150);  // whatever the costs are, numbers stay numbers
  ++state.generation;
  decompose();
}

CmaEs::CmaEs(const CmaEsOptions& options) : CmaEs(options, first_state(options)) {}

CmaEs::CmaEs(const CmaEsOptions& options, CmaEsState state) {
  check(options);
  check(state, options.start.size());
  inside_ = std::make_unique<Inside>(options, std::move(state));
}

CmaEs::~CmaEs() = default;
CmaEs::CmaEs(CmaEs&&) noexcept = default;
CmaEs& CmaEs::operator=(CmaEs&&) noexcept = default;

/// The same points until tell(): random numbers are counted, not drawn from a running generator.
std::vector<std::vector<double>> CmaEs::ask() const {
  std::vector<std::vector<double>> points;
  for (std::size_t k = 0; k < population(); ++k) {
    std::vector<double> x = state().mean;
    view(x) += sigma() * inside_->step_of(k);
    points.push_back(inside_->inside(std::move(x)));
  }
  return points;
}

void CmaEs::tell(const std::vector<double>& costs) {
  if (costs.size() != population())
    throw SetupError(fmt::format("{} costs for {} points of a search", costs.size(), population()));
  std::vector<std::size_t> order(costs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // NaN ranks last: it must not lead the search.
  const auto cost = [&](std::size_t i) { return std::isnan(costs[i]) ? HUGE_VAL : costs[i]; };
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return cost(a) < cost(b); });
  std::vector<VectorXd> ranked;
  // Steps as they were drawn, before they were reflected: the distribution has no bounds.
  for (const std::size_t i : order) ranked.push_back(inside_->step_of(i));
  inside_->update(ranked);
}

std::vector<double> CmaEs::mean() const { return inside_->inside(state().mean); }
double CmaEs::sigma() const { return inside_->state.sigma; }
std::size_t CmaEs::population() const { return inside_->constants.lambda; }
const CmaEsState& CmaEs::state() const { return inside_->state; }

}  // namespace murosimf::studies
