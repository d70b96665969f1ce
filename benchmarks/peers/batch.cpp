/// murosimf_peer_batch FOLDER --worlds 1024 --threads 2 --seconds 1 - many worlds of one scene in a Batch (include/murosimf/batch.h), ten steps
/// at a time: prints what many_worlds.h says; observed are how far robots came, and `kib_per_world` of the heap.
///
/// Joints begin up to a degree beside their posture: worlds that are all the same would settle their contacts in the same passes.
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <nlohmann/json.hpp>

#include "benchmarks/peers/many_worlds.h"
#include "murosimf/batch.h"

namespace {

constexpr int steps_at_once = 10;  // as mujoco_worlds.py

/// [m] In the mean over worlds, between poses of their bases.
double mean_distance(std::span<const double> from, std::span<const double> to) {
  double sum = 0;
  for (std::size_t i = 0; i < from.size(); i += 7) sum += std::hypot(to[i] - from[i], to[i + 1] - from[i + 1]);
  return 7 * sum / static_cast<double>(from.size());
}

class Worlds final : public peers::ManyWorlds {
 public:
  explicit Worlds(const peers::Options& options)
      : batch_((options.folder / "scene.toml").string(), static_cast<std::size_t>(options.worlds),
               {.set = {"*.level=" + options.setting, "start.jitter_posture_deg=1"}, .cameras = false},
               options.threads),
        start_(batch_.base_pose().begin(), batch_.base_pose().end()) {}

  double run(double seconds) override {
    const int cycles = std::max(1, static_cast<int>(std::lround(seconds / batch_.step_length() / steps_at_once)));
    for (int i = 0; i < cycles; ++i) batch_.step(steps_at_once);
    return static_cast<double>(cycles) * steps_at_once * static_cast<double>(batch_.size());
  }
  [[nodiscard]] nlohmann::json observed() override {
    const auto bytes = static_cast<double>(mallinfo2().uordblks - bytes_before_);
    return {{"distance_m", mean_distance(start_, batch_.base_pose())},
            {"kib_per_world", bytes / 1024 / static_cast<double>(batch_.size())}};
  }

 private:
  std::size_t bytes_before_ = mallinfo2().uordblks;  // before there is a batch
  murosimf::Batch batch_;
  std::vector<double> start_;
};

}  // namespace

int main(int count, char** arguments) {
  return peers::race_worlds(count, arguments, [](const auto& options) { return std::make_unique<Worlds>(options); });
}
