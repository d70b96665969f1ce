#include "murosimf/identification/search.h"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/math/random.h"
#include "murosimf/model/error.h"

namespace murosimf::identification {
namespace {

constexpr int evaluations_per_report = 100;
constexpr double global_share = 0.75;  // of the evaluations; the rest polishes

/// Progress of all starts together.
class Board {
 public:
  Board(const Progress& progress, int evaluations) : progress_(progress), evaluations_(evaluations) {}
  void report(double cost) {
    const std::scoped_lock lock(mutex_);
    done_ += evaluations_per_report;
    best_ = std::min(best_, cost);
    if (progress_) progress_(std::min(1.0, static_cast<double>(done_) / evaluations_), best_);
  }

 private:
  const Progress& progress_;
  int evaluations_;
  std::mutex mutex_;
  int done_ = 0;
  double best_ = std::numeric_limits<double>::infinity();
};

/// One start: its own copy of the objective, and the best point so far.
struct Start {
  Objective objective;
  Board& board;
  const std::function<bool()>& stop;
  std::vector<double> places;
  nlopt_opt search = nullptr;  // while it runs
  double cost = std::numeric_limits<double>::infinity();
  int evaluations = 0;
};

double evaluate(unsigned count, const double* places, double* /*gradient*/, void* data) {
  Start& start = *static_cast<Start*>(data);
  if (start.stop && start.stop()) nlopt_force_stop(start.search);
  const double cost = start.objective({places, count});
  if (cost < start.cost) {
    start.cost = cost;
    start.places.assign(places, places + count);
  }
  if (++start.evaluations % evaluations_per_report == 0) start.board.report(start.cost);
  return cost;
}

/// Minimizes from start.places on; the best point is stored there.
void minimize(Start& start, nlopt_algorithm algorithm, double evaluations) {
  const auto count = static_cast<unsigned>(start.places.size());
  MUROSIMF_ASSERT(count > 0 && evaluations >= 0);
  const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> search(nlopt_create(algorithm, count), nlopt_destroy);
  nlopt_set_lower_bounds1(search.get(), 0);
  nlopt_set_upper_bounds1(search.get(), 1);
  nlopt_set_min_objective(search.get(), evaluate, &start);
  nlopt_set_maxeval(search.get(), static_cast<int>(evaluations));
  nlopt_set_ftol_rel(search.get(), 1e-5);
  nlopt_set_xtol_rel(search.get(), 1e-6);
  nlopt_set_initial_step1(search.get(), 0.03);
  start.search = search.get();
  // NLopt returns its last point; evaluate() keeps the best one.
  std::vector<double> point = start.places;
  double cost = 0;
  nlopt_optimize(search.get(), point.data(), &cost);
}

/// The expected value of each parameter that the prior names, and random values for the others.
std::vector<double> first_point(const Objective& objective, std::uint64_t seed) {
  const RandomStream dice(seed, "first point of a fit");
  std::vector<double> places;
  for (const Parameter& parameter : objective.parameters()) {
    const auto known = expected_value(objective.prior(), parameter);
    const double chance = dice.uniform(places.size(), 0.05, 0.95);
    places.push_back(known ? place_of(parameter, *known) : chance);
  }
  return places;
}

void run(Start& start, const SearchOptions& options, std::uint64_t number) {
  // Each start has its own seed, independent of the number of threads.
  const std::uint64_t seed = options.seed * 1000003 + number;
  nlopt_srand(static_cast<unsigned long>(seed));  // of this thread
  start.places = first_point(start.objective, seed);
  minimize(start, NLOPT_GN_CRS2_LM, global_share * options.evaluations);
  if (options.stop && options.stop()) return;
  minimize(start, NLOPT_LN_SBPLX, (1 - global_share) * options.evaluations);
}

/// Calls work(i) for every i below `count`, each in its own thread; throws SetupError if the system does not provide so many.
void in_threads(int count, const std::function<void(std::size_t)>& work) {
  MUROSIMF_ASSERT(count >= 0);
  std::vector<std::jthread> threads;  // join when they go
  try {
    for (int i = 0; i < count; ++i) threads.emplace_back(work, static_cast<std::size_t>(i));
  } catch (const std::system_error& error) {
    throw SetupError(fmt::format("only {} of {} threads could begin ({}); use fewer: --threads {}", threads.size(),
                                 count, error.code().message(), std::max<std::size_t>(1, threads.size())));
  }
}

}  // namespace

Found search(const Objective& objective, const SearchOptions& options, const Progress& progress) {
  Board board(progress, options.starts * options.evaluations);
  std::vector<Start> starts(static_cast<std::size_t>(options.starts), Start{objective, board, options.stop, {}});
  const auto work = [&](std::size_t first) {
    // Starts are distributed by their numbers: results do not depend on the threads.
    for (std::size_t i = first; i < starts.size(); i += static_cast<std::size_t>(options.threads)) {
      if (options.stop && options.stop()) return;
      run(starts[i], options, i);
    }
  };
  in_threads(std::min(options.threads, options.starts), work);

  const auto best = std::ranges::min_element(starts, {}, &Start::cost);
  if (best->places.empty()) best->places = first_point(objective, options.seed);  // stopped before it began
  Found found{.servo = objective.servo_at(best->places), .places = best->places, .cost = best->cost, .costs = {}};
  for (const Start& start : starts) {
    if (std::isfinite(start.cost)) found.costs.push_back(start.cost);
  }
  return found;
}

Found refine(const Found& found, const Objective& objective, int evaluations, const std::function<bool()>& stop) {
  const Progress none;
  Board board(none, evaluations);
  Start start{objective, board, stop, found.places};
  minimize(start, NLOPT_LN_SBPLX, evaluations);
  return {objective.servo_at(start.places), start.places, start.cost, found.costs};
}

void check_search() {}

}  // namespace murosimf::identification
