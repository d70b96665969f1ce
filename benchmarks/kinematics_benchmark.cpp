// Kernels on the kid21 robot, one at a time and eight in lanes. Times are per call; "per_robot" divides by the lanes.
#include <benchmark/benchmark.h>

#include "benchmarks/robots.h"
#include "murosimf/math/pack.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/multibody/mass.h"

namespace murosimf::benchmarks {
namespace {

template <class S>
struct State {
  State() : q(size()), qd(size()), r(size()), v(size()), w(size()), R(size()) {
    for (std::size_t i = 0; i < q.size(); ++i) {
      q[i] = S(0.1 * static_cast<double>(i % 7) - 0.3);
      qd[i] = S(0.5);
    }
  }
  static std::size_t size() { return static_cast<std::size_t>(kid21()->size()); }

  std::vector<S> q, qd;
  std::vector<Vec3<S>> r, v, w;
  std::vector<Mat3<S>> R;
};

template <class S>
constexpr double lanes = 1;
template <>
constexpr double lanes<Pack8> = Pack8::lanes;

template <class S>
void count_robots(benchmark::State& bench) {
  using benchmark::Counter;
  bench.counters["per_robot"] = Counter(lanes<S>, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

template <class S>
void direct_kinematics(benchmark::State& bench) {
  State<S> s;
  const Tree& tree = kid21()->tree();
  for (auto _ : bench) {
    multibody::poses<S>(tree, s.q, s.r, s.R);
    benchmark::DoNotOptimize(s.r.data());
    benchmark::ClobberMemory();
  }
  count_robots<S>(bench);
}

template <class S>
void velocities(benchmark::State& bench) {
  State<S> s;
  const Tree& tree = kid21()->tree();
  multibody::poses<S>(tree, s.q, s.r, s.R);
  for (auto _ : bench) {
    multibody::velocities<S>(tree, s.qd, s.r, s.R, s.v, s.w);
    benchmark::DoNotOptimize(s.v.data());
    benchmark::ClobberMemory();
  }
  count_robots<S>(bench);
}

template <class S>
void common_body(benchmark::State& bench) {
  State<S> s;
  const Tree& tree = kid21()->tree();
  multibody::poses<S>(tree, s.q, s.r, s.R);
  multibody::velocities<S>(tree, s.qd, s.r, s.R, s.v, s.w);
  for (auto _ : bench) {
    auto body = multibody::common_body<S>(tree, s.r, s.R, s.v, s.w);
    benchmark::DoNotOptimize(body);
  }
  count_robots<S>(bench);
}

BENCHMARK_TEMPLATE(direct_kinematics, double);
BENCHMARK_TEMPLATE(direct_kinematics, Pack8);
BENCHMARK_TEMPLATE(velocities, double);
BENCHMARK_TEMPLATE(velocities, Pack8);
BENCHMARK_TEMPLATE(common_body, double);
BENCHMARK_TEMPLATE(common_body, Pack8);

}  // namespace
}  // namespace murosimf::benchmarks
