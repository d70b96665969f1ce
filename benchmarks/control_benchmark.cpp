// What the door for control software in shared libraries costs per step: signals shown, call, commands taken over and counted.
#include <benchmark/benchmark.h>

#include "murosimf/control_software/controller_task.h"
#include "murosimf/control_software/library_software.h"
#include "murosimf/scene/scene.h"

namespace {

using namespace murosimf;

/// Steps of the software alone, as the scheduler makes them; everything is guarded and timed.
void control_software_step(benchmark::State& state, const char* library) {
  scene::Scene scene("walk", {.overrides = {"walker.controller=library", std::string("walker.library=") + library},
                              .cameras = false});
  scene.simulation().run(std::chrono::seconds(1));
  const control_software::SoftwareReport* report =
      control_software::software_report(scene.simulation().world().entity("walker"));
  const auto share_of = [&](std::string_view name) {
    for (const AlgorithmStatistics& one : scene.simulation().statistics()) {
      if (one.name == name) return one.us_per_call;
    }
    return 0.0;
  };
  for (auto _ : state) scene.simulation().run(std::chrono::seconds(1));
  state.counters["us_per_step"] = share_of("control_software");
  state.counters["us_in_library"] =
      1e-3 * static_cast<double>(report->spent.count()) / static_cast<double>(report->calls);
}

BENCHMARK_CAPTURE(control_software_step, wave, MUROSIMF_WAVE)->Unit(benchmark::kMillisecond);

/// A guarded call of a function that does nothing.
void guarded_call(benchmark::State& state) {
  const control_software::GuardedCall call{"a benchmark", "its step", std::chrono::seconds(10)};
  int calls = 0;
  for (auto _ : state) benchmark::DoNotOptimize(call([&] { benchmark::DoNotOptimize(++calls); }));
}
BENCHMARK(guarded_call);

}  // namespace
