/// search.h - searches for the numbers that explain the logs best.
///
/// The objective is rugged and has many minima, so several searches start from different points: each a controlled random
/// search (CRS2 with local mutation, Kaelo and Ali 2006) and, from what it found, a subspace simplex (Rowan 1990), both of
/// NLopt (S. G. Johnson). Searches run in threads of their own; results depend on the seed only.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "murosimf/identification/objective.h"

namespace murosimf::identification {

struct SearchOptions {
  std::uint64_t seed = 1;
  int starts = 4;
  int evaluations = 8000;  ///< of the objective, per start
  int threads = 1;
  std::function<bool()> stop{};  ///< true: end with the best so far; called from any thread
};

struct Found {
  multibody::BenchServo servo;
  std::vector<double> places;  ///< of the objective
  double cost = 0;             ///< [rad] of the objective
  std::vector<double> costs;   ///< [rad] of every start that began: if they differ much, more starts are needed
};

/// Gets the share that is done, 0 to 1, and the lowest cost [rad] so far; one call at a time, from any thread.
using Progress = std::function<void(double share, double best)>;

/// Throws SetupError in a build without NLopt. A search that was stopped before any evaluation has an infinite cost.
[[nodiscard]] Found search(const Objective& objective, const SearchOptions& options, const Progress& progress = {});

/// A local search with another objective of the same parameters, such as one with finer steps, from the point of `found`.
[[nodiscard]] Found refine(const Found& found, const Objective& objective, int evaluations,
                           const std::function<bool()>& stop = {});

/// Throws SetupError in a build without NLopt: to be called before logs are read.
void check_search();

}  // namespace murosimf::identification
