/// cma_es.h - CMA-ES: minimizes a function of n numbers from its values alone, inside a box.
///
///     CmaEs search({.start = {0.5, 0.5}, .sigma = 0.2, .low = {0, 0}, .high = {1, 1}});
///     while (search.sigma() > 1e-6) search.tell(costs_of(search.ask()));
///
/// Each generation draws points from a normal distribution, mean m, covariance sigma^2 C, ranks them by cost, and moves m, sigma and C
/// towards the better ones, C also away from the worse ones. Ranks alone count, so neither the scale of costs nor that of numbers matters much.
/// Source: Hansen, "The CMA Evolution Strategy: A Tutorial", arXiv:1604.00772 (2016, 2023), fig. 6 and table 1: all constants are its
/// defaults, negative weights included; C is decomposed anew in every generation, which is cheap for some dozens of numbers.
///
/// The box: what is drawn outside is reflected at the sides until it is inside, and counts there; the distribution itself has no bounds.
/// Source: the method "reflection" of Biedrzycki, "Handling bound constraints in CMA-ES: an experimental study", Swarm and
/// Evolutionary Computation 52 (2020).
///
/// Random numbers are counted by seed, generation and place, so a continuation needs nothing but `state()`: a search that begins with it makes the same
/// points, bit for bit, as one that was never interrupted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace murosimf::studies {

struct CmaEsOptions {
  std::vector<double> start;  ///< n numbers: the mean of the first generation
  double sigma = 0.3;         ///< standard deviation of each number at first; about a third of how far the best may be
  std::vector<double> low, high;  ///< n numbers each, low < high; empty: no box
  std::size_t population = 0;     ///< points of a generation; 0: 4 + floor(3 ln n)
  std::uint64_t seed = 1;
};

struct CmaEsState {
  std::uint64_t generation = 0;    ///< that comes next
  double sigma = 0;                ///< step size
  std::vector<double> mean;        ///< n; may lie outside the box
  std::vector<double> sigma_path;  ///< n; p_sigma
  std::vector<double> path;        ///< n; p_c
  std::vector<double> covariance;  ///< n n, symmetric; C
  friend bool operator==(const CmaEsState&, const CmaEsState&) = default;
};

class CmaEs {
 public:
  /// Throws SetupError: no numbers, a start that is not finite, a sigma that is not above 0, a box of another size or without inside.
  explicit CmaEs(const CmaEsOptions& options);
  /// Continues a search. `options` as of the search that left the state. Throws SetupError also for a state of other sizes, or with impossible numbers.
  CmaEs(const CmaEsOptions& options, CmaEsState state);
  ~CmaEs();
  CmaEs(CmaEs&&) noexcept;
  CmaEs& operator=(CmaEs&&) noexcept;

  /// The points of this generation, inside the box: the same until tell() is called.
  [[nodiscard]] std::vector<std::vector<double>> ask() const;
  /// Their costs, in their order; lower is better, NaN is worst. Makes the next generation. Throws SetupError if they are not as many.
  void tell(const std::vector<double>& costs);

  /// The middle of the distribution, inside the box: as a rule better than its points where costs are noisy.
  [[nodiscard]] std::vector<double> mean() const;
  [[nodiscard]] double sigma() const;
  [[nodiscard]] std::size_t population() const;
  [[nodiscard]] const CmaEsState& state() const;

 private:
  struct Inside;  // keeps Eigen out of this header
  std::unique_ptr<Inside> inside_;
};

}  // namespace murosimf::studies
