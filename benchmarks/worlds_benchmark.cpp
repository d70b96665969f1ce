// Many worlds in one process: what another one costs, and how long it takes to put one back to its start.
#include <malloc.h>

#include <fstream>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "murosimf/scene/assets.h"
#include "murosimf/scene/scene.h"

namespace murosimf::benchmarks {
namespace {

/// A file with `count` kid21 in rows, without ball and cameras.
std::string scene_of(int count, bool sensors) {
  const std::string name =
      (std::filesystem::temp_directory_path() / fmt::format("worlds_{}_{}.toml", count, sensors)).string();
  std::ofstream file(name);
  file << "[field]\ngoals = false\n[defaults]\nmodel = 'kid21'\nlevel = 'simplified_dynamics'\ncontroller = 'walk'\n";
  if (!sensors) file << "sensors = false\n";
  for (int i = 0; i < count; ++i) {
    file << fmt::format("[[robots]]\nname = 'r{}'\nposition = [{}, {}]\n", i, i % 6, i / 6);
  }
  return name;
}

scene::SceneOptions sharing(const std::shared_ptr<scene::Assets>& assets) {
  return {.cameras = false, .assets = assets};
}

/// From the file on, with the models that are read already.
void further_world(benchmark::State& bench) {
  const auto assets = std::make_shared<scene::Assets>();
  const std::string file = scene_of(1, bench.range(0) != 0);
  const scene::Scene first(file, sharing(assets));
  for (auto _ : bench) {
    scene::Scene scene(file, sharing(assets));
    scene.simulation().initialize();
    benchmark::DoNotOptimize(scene.simulation().now());
  }
}

/// The same with what the file says known.
void further_world_from_memory(benchmark::State& bench) {
  const auto assets = std::make_shared<scene::Assets>();
  const scene::Scene first(scene_of(1, bench.range(0) != 0), sharing(assets));
  for (auto _ : bench) {
    scene::Scene scene(first.spec(), sharing(assets));
    scene.simulation().initialize();
    benchmark::DoNotOptimize(scene.simulation().now());
  }
}

void reset(benchmark::State& bench) {
  scene::Scene scene(scene_of(static_cast<int>(bench.range(0)), bench.range(1) != 0), sharing(nullptr));
  scene.simulation().run(std::chrono::milliseconds(100));
  std::uint64_t seed = 1;
  for (auto _ : bench) scene.reset(++seed);
}

/// Bytes of the heap for each of 200 further worlds that have run for a while.
void memory(benchmark::State& bench) {
  const auto assets = std::make_shared<scene::Assets>();
  const scene::Scene first(scene_of(1, bench.range(0) != 0), sharing(assets));
  for (auto _ : bench) {
    std::vector<std::unique_ptr<scene::Scene>> worlds;
    const auto before = mallinfo2().uordblks;
    for (int i = 0; i < 200; ++i) {
      worlds.push_back(std::make_unique<scene::Scene>(first.spec(), sharing(assets)));
      worlds.back()->simulation().run(std::chrono::milliseconds(20));
    }
    bench.counters["kB_per_world"] = static_cast<double>(mallinfo2().uordblks - before) / 200 / 1e3;
  }
}

BENCHMARK(further_world)->ArgName("sensors")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);
BENCHMARK(further_world_from_memory)->ArgName("sensors")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);
BENCHMARK(reset)->ArgNames({"robots", "sensors"})->ArgsProduct({{1, 22}, {0, 1}})->Unit(benchmark::kMicrosecond);
BENCHMARK(memory)->ArgName("sensors")->Arg(0)->Arg(1)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace murosimf::benchmarks
