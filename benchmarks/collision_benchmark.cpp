// Bounding trees of the kid21 robot: refit, and the pairs of 22 robots on a field of 9 m x 6 m.
#include <benchmark/benchmark.h>

#include "benchmarks/robots.h"
#include "murosimf/collision/compound.h"
#include "murosimf/multibody/kinematics.h"

namespace murosimf::benchmarks {
namespace {

using collision::Compound;

/// 22 robots in two rows, all `apart` [m] from each other.
struct Teams {
  Teams(const std::string& volume, double apart)
      : r(static_cast<std::size_t>(kid21()->size())), R(r.size()), robots(22, Compound(*kid21(), {volume, true})) {
    for (std::size_t i = 0; i < robots.size(); ++i) {
      const double angle = static_cast<double>(i);
      const std::vector<double> q(r.size(), 0.3);
      r[0] = {apart * static_cast<double>(i % 11), apart * static_cast<double>(i / 11), 0.3};
      R[0] = rotation_z(angle);
      multibody::poses<double>(kid21()->tree(), q, r, R);
      robots[i].refit(r, R);
    }
  }
  /// Pairs of shapes whose bounds overlap, and volume tests.
  std::pair<int, int> pairs() const {
    int found = 0, tests = 0;
    for (std::size_t a = 0; a < robots.size(); ++a) {
      for (std::size_t b = a + 1; b < robots.size(); ++b) {
        tests += collision::for_pairs(robots[a], robots[b], [&](int, int) { return ++found > 0; });
      }
    }
    return {found, tests};
  }

  std::vector<Vec3d> r;
  std::vector<Mat3d> R;
  std::vector<Compound> robots;
};

void refit(benchmark::State& bench, const char* volume) {
  Teams teams(volume, 0.8);
  for (auto _ : bench) {
    teams.robots[0].refit(teams.r, teams.R);
    benchmark::ClobberMemory();
  }
  const auto leaves = static_cast<double>(teams.robots[0].shapes().size());
  using benchmark::Counter;
  bench.counters["per_leaf"] = Counter(leaves, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

void pairs(benchmark::State& bench, const char* volume, double apart) {
  const Teams teams(volume, apart);
  std::pair<int, int> found;
  for (auto _ : bench) {
    found = teams.pairs();
    benchmark::DoNotOptimize(found);
  }
  bench.counters["pairs"] = found.first;
  bench.counters["tests"] = found.second;
}

BENCHMARK_CAPTURE(refit, sphere, "sphere");
BENCHMARK_CAPTURE(refit, aabb, "aabb");
BENCHMARK_CAPTURE(refit, obb, "obb");
BENCHMARK_CAPTURE(refit, capsule, "capsule");
BENCHMARK_CAPTURE(pairs, roots_of_22_robots, "sphere", 2.0);
BENCHMARK_CAPTURE(pairs, sphere, "sphere", 0.4);
BENCHMARK_CAPTURE(pairs, aabb, "aabb", 0.4);
BENCHMARK_CAPTURE(pairs, obb, "obb", 0.4);
BENCHMARK_CAPTURE(pairs, capsule, "capsule", 0.4);

}  // namespace
}  // namespace murosimf::benchmarks
