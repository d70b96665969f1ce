/// murosimf_peer_worlds FOLDER --worlds 100 --threads 2 --seconds 1 - many worlds of the same scene in one process, each on one thread at a
/// time, as examples/many_worlds.cpp: prints what many_worlds.h says; observed is how far robots came.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <nlohmann/json.hpp>

#include "benchmarks/peers/many_worlds.h"
#include "murosimf/model/properties.h"
#include "murosimf/runtime/thread_pool.h"
#include "murosimf/scene/assets.h"
#include "murosimf/scene/scene.h"
#include "murosimf/world/time.h"

namespace {

using namespace murosimf;

class Worlds final : public peers::ManyWorlds {
 public:
  explicit Worlds(const peers::Options& options) : pool_(options.threads) {
    const scene::SceneOptions sharing{.overrides = {"*.level=" + options.setting},
                                      .cameras = false,
                                      .assets = std::make_shared<scene::Assets>()};
    scenes_.push_back(std::make_unique<scene::Scene>(options.folder / "scene.toml", sharing));
    while (scenes_.size() < static_cast<std::size_t>(options.worlds)) {
      scenes_.push_back(std::make_unique<scene::Scene>(scenes_.front()->spec(), sharing));
    }
  }

  double run(double seconds) override {
    const double step = murosimf::seconds(scenes_.front()->simulation().tick());
    const int steps = std::max(1, static_cast<int>(std::lround(seconds / step)));
    pool_.for_each(scenes_.size(), [&](std::size_t i) { scenes_[i]->simulation().run(from_seconds(steps * step)); });
    return static_cast<double>(steps) * static_cast<double>(scenes_.size());
  }
  [[nodiscard]] nlohmann::json observed() override { return {{"distance_m", mean_distance()}}; }

 private:
  /// [m] In the mean over worlds, between the first robot's base and where the scene places it.
  [[nodiscard]] double mean_distance() {
    double sum = 0;
    for (auto& scene : scenes_) {
      const auto& robot = scene->spec().robots.front();
      const Vec3d r = scene->simulation().world().entity(robot.name).base().get(properties::position);
      sum += std::hypot(r.x - robot.position.x, r.y - robot.position.y);
    }
    return sum / static_cast<double>(scenes_.size());
  }

  ThreadPool pool_;
  std::vector<std::unique_ptr<scene::Scene>> scenes_;
};

}  // namespace

int main(int count, char** arguments) {
  return peers::race_worlds(count, arguments, [](const auto& options) { return std::make_unique<Worlds>(options); });
}
