/// cost_search.h - the point of least cost, searched by CMA-ES within so many evaluations or minutes; it continues after any interruption.
///
/// First all of `first` are tried, then generations from the best of them. After each generation everything that the search
/// knows is in the file `state`, whole: a search that finds it goes on from there and ends as if it had never been interrupted,
/// to the last bit, if it ends by evaluations.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "murosimf/runtime/pacer.h"
#include "murosimf/studies/cma_es.h"

namespace murosimf::studies {

struct CostSearchProgress {
  std::size_t evaluations = 0, of = 0;
  double best = 0;   ///< cost; infinity: none is known
  double share = 0;  ///< [1] of evaluations or minutes, whichever is nearer to its end
};

struct CostSearchOptions {
  CmaEsOptions space;                      ///< its start is the first point that is tried
  std::vector<std::vector<double>> first;  ///< that are tried besides, before the first generation
  std::size_t evaluations = 500;           ///< at most: no generation begins that would need more
  double minutes =
      std::numeric_limits<double>::infinity();  ///< of wall time, those of earlier parts of the search included
  std::filesystem::path state;                  ///< empty: none
  std::string what;                             ///< of the file: all that costs follow from, and the program
  StopRequest stop{};
  std::function<void(const CostSearchProgress&)> progress{};  ///< after each generation
};

/// The costs of these points, finite, in their order; of fewer, if it was stopped.
using CostsOf = std::function<std::vector<double>(const std::vector<std::vector<double>>& points)>;

struct CostSearch {
  std::vector<double> start, best;  ///< points
  double start_cost = 0, best_cost = 0;
  std::size_t evaluations = 0;
  std::size_t generations = 0;
  std::size_t taken_over = 0;  ///< evaluations that the file had
  double seconds = 0;          ///< [s] wall time
  bool stopped = false;        ///< by `stop`; `best` is the best so far, the start before there is any
};

/// The middle of the last distribution is tried, too. Throws SetupError: a file of another search, or that cannot be read or written.
[[nodiscard]] CostSearch search_cost(const CostSearchOptions& options, const CostsOf& costs_of);

}  // namespace murosimf::studies
