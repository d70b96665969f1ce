// One step of every level with its contacts, and the demo's game: what a robot costs.
#include <benchmark/benchmark.h>

#include "murosimf/io/scene.h"

namespace murosimf::benchmarks {
namespace {

/// One millisecond of one walking robot at `level`, control included.
void walking_robot(benchmark::State& bench, const char* level) {
  io::Scene scene("walk", {.overrides = {std::string("walker.level=") + level}});
  Simulation& simulation = scene.simulation();
  simulation.run(std::chrono::seconds(1));  // past the start
  for (auto _ : bench) simulation.step();
}

/// One simulated second of the three-on-three game; "real_time" is simulated seconds per second.
void game(benchmark::State& bench) {
  io::Scene scene("three_on_three", {.threads = static_cast<int>(bench.range(0))});
  Simulation& simulation = scene.simulation();
  simulation.run(std::chrono::seconds(1));
  for (auto _ : bench) simulation.run(std::chrono::seconds(1));
  bench.counters["real_time"] = benchmark::Counter(1, benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK_CAPTURE(walking_robot, kinematic_walking, "kinematic_walking");
BENCHMARK_CAPTURE(walking_robot, simplified_dynamics, "simplified_dynamics");
BENCHMARK_CAPTURE(walking_robot, full_dynamics, "full_dynamics");
BENCHMARK_CAPTURE(walking_robot, articulated_dynamics, "articulated_dynamics");
BENCHMARK(game)->Arg(1)->Arg(2)->ArgName("threads")->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace murosimf::benchmarks
