// What cameras cost: the scene six_cameras, and one frame by robots, size, lens and effects.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "murosimf/render/software_renderer.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_cameras.h"
#include "murosimf/scene/scene_parts.h"
#include "murosimf/scene_file/scene_spec.h"
#include "murosimf/sensors/camera_frame.h"

namespace murosimf::benchmarks {
namespace {

std::string each(const std::string& key) { return "*.sensors.camera." + key; }

/// Simulates a tenth of a second at a time; frames per second of wall time, and how many times real time that is.
void play(benchmark::State& bench, const std::string& name, const scene::SceneOptions& options) {
  scene::Scene scene(name, options);
  Simulation& simulation = scene.simulation();
  simulation.initialize();
  constexpr double step = 0.1;  // [s]
  for (auto _ : bench) simulation.run(from_seconds(step));
  double frames = 0;
  for (const Entity* moving_entity : scene.moving_entities()) {
    for (const sensors::CameraFrame* frame : sensors::frames_of(*moving_entity))
      frames += static_cast<double>(frame->number);
  }
  bench.counters["frames/s"] = benchmark::Counter(frames, benchmark::Counter::kIsRate);
  bench.counters["real_time"] =
      benchmark::Counter(step * static_cast<double>(bench.iterations()), benchmark::Counter::kIsRate);
}

void six_cameras(benchmark::State& bench) {
  play(bench, "six_cameras", {.threads = static_cast<int>(bench.range(0)), .cameras = bench.range(1) != 0});
}
BENCHMARK(six_cameras)->ArgNames({"threads", "cameras"})->Args({1, 1})->Args({2, 1})->Args({1, 0})->UseRealTime();

/// All at the same instant, so that threads have something to share.
void six_at_once(benchmark::State& bench) {
  play(bench, "six_cameras", {.threads = static_cast<int>(bench.range(0)), .overrides = {each("phase=0")}});
}
BENCHMARK(six_at_once)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime();

void size(benchmark::State& bench) {
  play(bench, "six_cameras",
       {.overrides = {each("width=" + std::to_string(bench.range(0))),
                      each("height=" + std::to_string(bench.range(0) * 3 / 4))}});
}
BENCHMARK(size)->ArgName("width")->Arg(160)->Arg(320)->Arg(640)->Arg(1280)->UseRealTime();

/// One camera that sees some robots of the eleven-a-side game.
void robots(benchmark::State& bench) {
  scene::SceneOptions options{.overrides = {"blue1.sensors.camera.always_on=true", "blue1.sensors.camera.fov=1.48"}};
  scene::Scene scene(bench.range(0) > 6 ? "eleven_a_side" : "three_on_three", options);
  Simulation& simulation = scene.simulation();
  simulation.initialize();
  const auto renderer = scene::make_camera_renderer(scene.parts(), {});
  sensors::Perspective view;  // from behind a goal: everybody is in the picture
  view.eye = {-6.5, 0, 1.5};
  view.axes = {{0, -1, 0}, {-0.17, 0, -0.985}, {0.985, 0, -0.17}};
  view.left = -0.9;
  view.right = 0.9;
  view.top = -0.675;
  view.bottom = 0.675;
  view.width = 640;
  view.height = 480;
  sensors::View drawn;
  for (auto _ : bench) renderer->draw(view, {.depth = bench.range(1) != 0}, 0, drawn);
  const render::DrawTotals totals = renderer->totals();
  bench.counters["triangles"] = static_cast<double>(totals.triangles) / static_cast<double>(totals.views);
  bench.counters["frames/s"] = benchmark::Counter(static_cast<double>(totals.views), benchmark::Counter::kIsRate);
}
BENCHMARK(robots)->ArgNames({"robots", "depth"})->Args({6, 0})->Args({22, 0})->Args({6, 1})->UseRealTime();

/// What one key of the camera adds.
void with(benchmark::State& bench, const std::vector<std::string>& keys) {
  scene::SceneOptions options;
  for (const std::string& key : keys) options.overrides.push_back(key.find("light") == 0 ? key : each(key));
  play(bench, "six_cameras", options);
}
BENCHMARK_CAPTURE(with, distortion, {"k1=-0.1"})->UseRealTime();
BENCHMARK_CAPTURE(with, fisheye_170_deg, {"lens='equidistant'", "fov=2.97"})->UseRealTime();
BENCHMARK_CAPTURE(with, blur, {"blur=1.0"})->UseRealTime();
BENCHMARK_CAPTURE(with, noise, {"shot_noise=0.02"})->UseRealTime();
BENCHMARK_CAPTURE(with, depth_and_labels, {"depth=true", "labels=true"})->UseRealTime();
BENCHMARK_CAPTURE(with, shadows, {"light.shadows=true"})->UseRealTime();
BENCHMARK_CAPTURE(with, four_samples, {"light.samples=4"})->UseRealTime();

}  // namespace
}  // namespace murosimf::benchmarks
