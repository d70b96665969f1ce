/// murosimf_peer_batch FOLDER --worlds 1024 --threads 2 --seconds 1 - many worlds of one scene in a Batch (include/murosimf/batch.h), ten steps
/// at a time: prints `us_per_step` and `wall_us_per_step` of one world, how far robots came, and `kib_per_world` of the heap.
///
/// Joints begin up to a degree beside their posture: worlds that are all the same would settle their contacts in the same passes.
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <vector>

#include <nlohmann/json.hpp>

#include "benchmarks/peers/options.h"
#include "murosimf/batch.h"

namespace {

constexpr int steps_at_once = 10;  // as mujoco_worlds.py

/// [m] In the mean over worlds, between poses of their bases.
double mean_distance(std::span<const double> from, std::span<const double> to) {
  double sum = 0;
  for (std::size_t i = 0; i < from.size(); i += 7) sum += std::hypot(to[i] - from[i], to[i + 1] - from[i + 1]);
  return 7 * sum / static_cast<double>(from.size());
}

nlohmann::json measure(const peers::Options& options) {
  const std::size_t before = mallinfo2().uordblks;
  const auto worlds = static_cast<std::size_t>(options.worlds);
  murosimf::Batch batch((options.folder / "scene.toml").string(), worlds,
                        {.set = {"*.level=" + options.setting, "start.jitter_posture_deg=1"}, .cameras = false},
                        options.threads);
  const std::vector<double> start(batch.base_pose().begin(), batch.base_pose().end());
  const double step = batch.step_length();
  const auto run = [&](double seconds) {
    const int cycles = std::max(1, static_cast<int>(std::lround(seconds / step / steps_at_once)));
    for (int i = 0; i < cycles; ++i) batch.step(steps_at_once);
    return static_cast<double>(cycles) * steps_at_once * static_cast<double>(worlds);
  };
  run(options.warm);
  const double processor = peers::processor_seconds(), wall = peers::wall_seconds();
  const double steps = run(options.seconds);
  const double wall_us = 1e6 * (peers::wall_seconds() - wall) / steps;
  const double processor_us = 1e6 * (peers::processor_seconds() - processor) / steps;
  const double bytes = static_cast<double>(mallinfo2().uordblks - before);
  return {{"engine", "MuRoSimF"},
          {"setting", options.setting},
          {"wall_us_per_step", wall_us},
          {"us_per_step", processor_us},
          {"observed",
           {{"distance_m", mean_distance(start, batch.base_pose())},
            {"kib_per_world", bytes / 1024 / static_cast<double>(worlds)}}}};
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
    std::fprintf(stderr, "murosimf_peer_batch: %s\n", error.what());
    return 1;
  }
}
