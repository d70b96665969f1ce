// One step of every level with its contacts, and the demo's game: what a robot costs.
#include <benchmark/benchmark.h>

#include "murosimf/collision/contact.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/scene/scene.h"

namespace murosimf::benchmarks {
namespace {

/// Says besides the time how many points touched the ground, on average over a second more, and how often it fell.
void count_contacts(benchmark::State& bench, Simulation& simulation) {
  Entity& robot = simulation.world().entity("walker");
  const auto* contacts = robot.find(collision::contacts);
  double points = 0;
  constexpr int steps = 1000;
  for (int i = 0; i < steps; ++i) {
    simulation.step();
    if (contacts) points += static_cast<double>(contacts->values[0].points.size());
  }
  bench.counters["contacts"] = points / steps;
  bench.counters["falls"] = robot.base().get(properties::falls);
}

/// One millisecond of one robot at `level` that follows `command`, control included.
void robot(benchmark::State& bench, const std::string& level, const std::string& command) {
  scene::Scene scene("walk",
                     {.overrides = {"walker.level=" + level, "walker.command=" + command, "field.goals=false"}});
  Simulation& simulation = scene.simulation();
  simulation.run(std::chrono::seconds(1));  // past the start
  for (auto _ : bench) simulation.step();
  count_contacts(bench, simulation);
}

void walking_robot(benchmark::State& bench, const char* level) { robot(bench, level, "[0.2, 0, 0]"); }
void standing_robot(benchmark::State& bench, const char* level) { robot(bench, level, "[0, 0, 0]"); }

/// One simulated second of the three-on-three game; "real_time" is simulated seconds per second.
void game(benchmark::State& bench) {
  scene::Scene scene("three_on_three", {.threads = static_cast<int>(bench.range(0))});
  Simulation& simulation = scene.simulation();
  simulation.run(std::chrono::seconds(1));
  for (auto _ : bench) simulation.run(std::chrono::seconds(1));
  bench.counters["real_time"] = benchmark::Counter(1, benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK_CAPTURE(walking_robot, kinematic_walking, "kinematic_walking");
BENCHMARK_CAPTURE(walking_robot, simplified_dynamics, "simplified_dynamics");
BENCHMARK_CAPTURE(walking_robot, full_dynamics, "full_dynamics");
BENCHMARK_CAPTURE(walking_robot, articulated_dynamics, "articulated_dynamics");
BENCHMARK_CAPTURE(standing_robot, simplified_dynamics, "simplified_dynamics");
BENCHMARK_CAPTURE(standing_robot, full_dynamics, "full_dynamics");
BENCHMARK_CAPTURE(standing_robot, articulated_dynamics, "articulated_dynamics");
BENCHMARK(game)->Arg(1)->Arg(2)->ArgName("threads")->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace murosimf::benchmarks
