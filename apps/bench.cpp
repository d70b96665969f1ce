// `murosimf bench collision`: what collision detection tests and costs, in the paper's scene, on a full field, in a heap, or in
// the scenes that are named.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "apps/collision_probe.h"
#include "apps/command_line.h"
#include "apps/error_output.h"
#include "apps/interruption.h"
#include "apps/progress.h"
#include "apps/standard_output.h"
#include "murosimf/scene/collision_report.h"
#include "murosimf/scene/scene.h"

namespace murosimf::app {
namespace {

struct BenchOptions {
  std::string what;
  std::vector<std::string> scenes, overrides;
  std::optional<double> duration;  ///< [s]
  std::string json;                ///< file, "-" for standard output
};

void define(const Command& command, BenchOptions& options) {
  command.add("what", options.what, "collision").required().one_of({"collision"});
  command.add("scenes", options.scenes, "Scene files (TOML), or names; none: those of docs/collision.md")
      .offers_list("scenes");
  command.add("--set", options.overrides, "PATH=VALUE: change the scenes that are named").one_at_a_time();
  command.add("--duration", options.duration, "Simulated seconds of the scenes that are named, instead of their own")
      .within(0.001, scene_file::longest_duration);
  add_json(command, options.json);
}

/// A scene to measure, and when: [s] of simulated time.
struct Case {
  std::string name, scene;
  double from, until;
  std::vector<std::string> overrides;
};

std::vector<Case> usual_cases() {
  return {{"duel", "duel", 0, 60, {}},
          {"duel, aabb", "duel", 0, 60, {"blue1.volume=aabb", "red1.volume=aabb"}},
          {"duel, standing",
           "duel",
           1,
           4,
           {"blue1.controller=none", "red1.controller=none", "blue1.position=[-1, 0]", "red1.position=[1, 0]"}},
          {"eleven a side", "eleven_a_side", 1, 4, {}},
          {"heap", "heap", 4, 8, {}}};
}

std::vector<Case> cases_of(const BenchOptions& options) {
  if (options.scenes.empty()) {
    if (options.duration || !options.overrides.empty())
      throw SetupError(
          "--set and --duration are for scenes that are named: murosimf bench collision duel --duration 10");
    return usual_cases();
  }
  std::vector<Case> cases;
  for (const std::string& name : options.scenes) {
    const scene::Scene scene(name, {.overrides = options.overrides, .stop = interrupted});
    cases.push_back({std::filesystem::path(name).stem().string(), name, 0,
                     options.duration.value_or(scene.spec().duration), options.overrides});
  }
  return cases;
}

double median(std::vector<double> numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

scene::CollisionReport summed_up(const std::vector<CollisionProbe::Sample>& samples, std::int64_t naive) {
  scene::CollisionReport report;
  report.steps = static_cast<std::int64_t>(samples.size());
  report.naive_tests = naive;
  std::vector<double> pairs, ground;
  std::vector<std::int64_t> volumes_anew, objects;
  for (const CollisionProbe::Sample& sample : samples) {
    const double share = static_cast<double>(sample.volumes + sample.objects) / static_cast<double>(naive);
    report.mean_volume_tests += static_cast<double>(sample.volumes);
    report.mean_object_tests += static_cast<double>(sample.objects);
    report.mean_volume_tests_anew += static_cast<double>(sample.volumes_anew);
    volumes_anew.push_back(sample.volumes_anew);
    objects.push_back(sample.objects);
    report.mean_contacts += static_cast<double>(sample.contacts);
    report.worst_share = std::max(report.worst_share, share);
    ++report.histogram[std::min(scene::CollisionReport::bins - 1,
                                static_cast<int>(share * scene::CollisionReport::bins))];
    pairs.push_back(sample.pairs_us);
    ground.push_back(sample.ground_us);
  }
  for (double* sum :
       {&report.mean_volume_tests, &report.mean_object_tests, &report.mean_volume_tests_anew, &report.mean_contacts}) {
    *sum /= static_cast<double>(samples.size());
  }
  report.volume_tests_anew = scene::histogram_of(volumes_anew);
  report.object_tests = scene::histogram_of(objects);
  report.pairs_us = median(pairs);
  report.ground_us = median(ground);
  return report;
}

std::vector<Entity*> moving_entities_of(World& world, const Entity& environment) {
  std::vector<Entity*> moving_entities;
  for (const auto& entity : world.entities()) {
    if (entity.get() != &environment) moving_entities.push_back(entity.get());
  }
  return moving_entities;
}

/// Shows how far all cases are: each counts the same, and its run with the probe as much as that without.
class BenchProgress {
 public:
  explicit BenchProgress(std::size_t cases) : cases_(static_cast<double>(cases)) {}
  void begin(const Case& measured) {
    until_ = measured.until;
    what_ = measured.name;
  }
  void end_half() { ++halves_; }
  void show(Duration now) { line_.show((halves_ + seconds(now) / until_) / (2 * cases_), what_); }

 private:
  Progress line_;
  double cases_;
  std::string what_;
  double until_ = 1;  // [s]
  int halves_ = 0;
};

scene::SceneOptions scene_options(const Case& measured) {
  return {.overrides = measured.overrides, .stop = interrupted};
}

void run_to(Simulation& simulation, double time, BenchProgress& progress) {
  Pacer as_fast_as_possible;
  simulation.run(std::max(Duration{}, from_seconds(time) - simulation.now()), as_fast_as_possible,
                 [&](Duration now) { progress.show(now); });
}

/// Time of the same scene without the probe [us per step].
double step_us(const Case& measured, BenchProgress& progress) {
  scene::Scene scene(measured.scene, scene_options(measured));
  Simulation& simulation = scene.simulation();
  run_to(simulation, measured.from, progress);
  const auto start = std::chrono::steady_clock::now();
  run_to(simulation, measured.until, progress);
  const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
  return time.count() / ((measured.until - measured.from) * scene.spec().rate);
}

/// Nothing if it was interrupted.
std::optional<scene::CollisionReport> measure(const Case& measured, BenchProgress& progress) {
  progress.begin(measured);
  scene::Scene scene(measured.scene, scene_options(measured));
  Simulation& simulation = scene.simulation();
  Entity& field = simulation.world().entity("field");
  const auto& probe =
      simulation.attach<CollisionProbe>("collision_probe", field, scene.spec().rate,
                                        moving_entities_of(simulation.world(), field), scene.spec().materials);
  run_to(simulation, measured.until, progress);
  if (interrupted()) return std::nullopt;
  progress.end_half();
  const auto first = static_cast<std::ptrdiff_t>(measured.from * scene.spec().rate);
  scene::CollisionReport report =
      summed_up({probe.samples().begin() + first, probe.samples().end()}, probe.naive_tests());
  report.scene = measured.name;
  report.robots = static_cast<int>(scene.spec().robots.size());
  report.step_us = step_us(measured, progress);
  if (interrupted()) return std::nullopt;
  progress.end_half();
  return report;
}

int bench(const BenchOptions& options) {
  check_json_file(options.json);
  end_gently();
  const std::vector<Case> cases = cases_of(options);
  std::vector<scene::CollisionReport> reports;
  {
    BenchProgress progress(cases.size());
    for (const Case& measured : cases) {
      if (auto report = measure(measured, progress)) reports.push_back(*report);
      if (interrupted()) break;
    }
  }
  if (interrupted()) {
    say_error(fmt::format("stopped by {} after {} of {} scenes", signal_name(), reports.size(), cases.size()));
  }
  write_result(options.json, scene::to_text(reports), scene::to_json(reports));
  return exit_code();
}

}  // namespace

void add_bench(CommandLine& line) {
  line.add<BenchOptions>("bench", "Measure what a part of the simulation costs", define, bench);
}

}  // namespace murosimf::app
