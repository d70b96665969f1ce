// Kernels of rigid-body dynamics on the kid21 robot, one at a time and eight in lanes.
#include <benchmark/benchmark.h>

#include "benchmarks/robots.h"
#include "murosimf/math/pack.h"
#include "murosimf/multibody/articulated_body.h"
#include "murosimf/multibody/inverse_dynamics.h"
#include "murosimf/multibody/kinematics.h"

namespace murosimf::benchmarks {
namespace {

template <class S>
struct Robot {
  Robot()
      : q(size()),
        qd(size()),
        r(size()),
        R(size()),
        links(tree().links.size()),
        bodies(links.size()),
        force(links.size()),
        external(links.size()),
        qdd(links.size(), S(1.0)),
        torque(links.size()),
        working(links.size()) {
    for (std::size_t i = 0; i < q.size(); ++i) {
      q[i] = S(0.1 * static_cast<double>(i % 7) - 0.3);
      qd[i] = S(0.5);
    }
    multibody::poses<S>(tree(), q, r, R);
    move_links();
    for (auto& body : bodies) {
      body.torque = S(0.1);
      body.added_inertia = S(0.01);
    }
  }
  static std::size_t size() { return static_cast<std::size_t>(kid21()->size()); }
  static const Tree& tree() { return kid21()->tree(); }
  void move_links() { multibody::link_motions<S>(tree(), r, R, Vec3<S>{S(0.1), S(0.2), S(0.3)}, qd, links); }

  std::vector<S> q, qd;
  std::vector<Vec3<S>> r;
  std::vector<Mat3<S>> R;
  std::vector<multibody::LinkMotion<S>> links;
  std::vector<multibody::ArticulatedLink<S>> bodies;
  std::vector<Wrench<S>> force, external;
  std::vector<S> qdd, torque;
  std::vector<Twist<S>> working;
};

template <class S, class Step>
void run(benchmark::State& bench, const Step& step) {
  Robot<S> robot;
  for (auto _ : bench) {
    step(robot);
    benchmark::ClobberMemory();
  }
  using benchmark::Counter;
  const double robots = sizeof(S) / sizeof(double);
  bench.counters["per_robot"] = Counter(robots, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

template <class S>
void link_motions(benchmark::State& bench) {
  run<S>(bench, [](Robot<S>& robot) { robot.move_links(); });
}

template <class S>
void inverse_dynamics(benchmark::State& bench) {
  run<S>(bench, [](Robot<S>& r) {
    multibody::inverse_dynamics<S>(r.tree(), r.links, Twist<S>{}, r.qdd, r.external, r.force, r.torque);
  });
}

/// Composite inertia, force that the joints take, solution for the base: the paper's eq. (3).
template <class S>
void base_of_full_dynamics(benchmark::State& bench) {
  run<S>(bench, [](Robot<S>& r) {
    const Wrench<S> bias = multibody::base_bias<S>(r.tree(), r.links, r.qdd, r.working);
    r.working[0] = solve(to_sym6(multibody::composite_inertia<S>(r.links)), bias);
  });
}

template <class S>
void articulated_bodies(benchmark::State& bench) {
  run<S>(bench, [](Robot<S>& r) {
    multibody::clear_loads<S>(r.bodies);
    multibody::sweep_to_base<S>(r.tree(), r.links, r.bodies);
    multibody::accelerate<S>(r.tree(), r.links, r.bodies, solve(r.bodies[0].inertia, r.bodies[0].force));
  });
}

BENCHMARK_TEMPLATE(link_motions, double);
BENCHMARK_TEMPLATE(link_motions, Pack8);
BENCHMARK_TEMPLATE(inverse_dynamics, double);
BENCHMARK_TEMPLATE(inverse_dynamics, Pack8);
BENCHMARK_TEMPLATE(base_of_full_dynamics, double);
BENCHMARK_TEMPLATE(base_of_full_dynamics, Pack8);
BENCHMARK_TEMPLATE(articulated_bodies, double);
BENCHMARK_TEMPLATE(articulated_bodies, Pack8);

}  // namespace
}  // namespace murosimf::benchmarks
