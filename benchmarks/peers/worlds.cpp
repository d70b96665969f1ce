/// murosimf_peer_worlds FOLDER --worlds 100 --threads 2 --seconds 1 - many worlds of the same scene in one process, each on one thread at a
/// time, as examples/many_worlds.cpp: prints `wall_us_per_step` and `us_per_step` of one world, and how far robots came.
#include <cmath>
#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include "benchmarks/peers/options.h"
#include "murosimf/model/properties.h"
#include "murosimf/runtime/thread_pool.h"
#include "murosimf/scene/assets.h"
#include "murosimf/scene/scene.h"
#include "murosimf/world/time.h"

namespace {

using namespace murosimf;

using Worlds = std::vector<std::unique_ptr<scene::Scene>>;

Worlds make_worlds(const peers::Options& options) {
  const scene::SceneOptions sharing{.overrides = {"*.level=" + options.setting},
                                    .cameras = false,
                                    .assets = std::make_shared<scene::Assets>()};
  Worlds worlds{};
  worlds.push_back(std::make_unique<scene::Scene>(options.folder / "scene.toml", sharing));
  while (worlds.size() < static_cast<std::size_t>(options.worlds)) {
    worlds.push_back(std::make_unique<scene::Scene>(worlds.front()->spec(), sharing));
  }
  return worlds;
}

/// [m] In the mean over worlds, from the first robot's place to the origin.
double mean_distance(Worlds& worlds, const Vec3d& from) {
  double sum = 0;
  for (auto& world : worlds) {
    const Vec3d r =
        world->simulation().world().entity(world->spec().robots.front().name).base().get(properties::position);
    sum += std::hypot(r.x - from.x, r.y - from.y);
  }
  return sum / static_cast<double>(worlds.size());
}

nlohmann::json measure(const peers::Options& options) {
  Worlds worlds = make_worlds(options);
  ThreadPool pool(options.threads);
  const auto run = [&](double seconds) {
    pool.for_each(worlds.size(), [&](std::size_t i) { worlds[i]->simulation().run(from_seconds(seconds)); });
  };
  const Vec3d start = worlds.front()->spec().robots.front().position;
  run(options.warm);
  const double processor = peers::processor_seconds(), wall = peers::wall_seconds();
  run(options.seconds);
  const double steps = options.seconds * worlds.front()->spec().rate * static_cast<double>(worlds.size());
  const double wall_us = 1e6 * (peers::wall_seconds() - wall) / steps;
  const double processor_us = 1e6 * (peers::processor_seconds() - processor) / steps;
  return {{"engine", "MuRoSimF"},
          {"setting", options.setting},
          {"wall_us_per_step", wall_us},
          {"us_per_step", processor_us},
          {"observed", {{"distance_m", mean_distance(worlds, start)}}}};
}

}  // namespace

int main(int count, char** arguments) {
  try {
    const peers::Options options =
        peers::read_options({arguments, static_cast<std::size_t>(count)},
                            {"articulated_dynamics", "full_dynamics", "simplified_dynamics", "kinematic_walking"});
    std::printf("%s\n", measure(options).dump().c_str());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "murosimf_peer_worlds: %s\n", error.what());
    return 1;
  }
}
