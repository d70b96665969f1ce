// A hundred worlds in one process, each put back to its start with another seed instead of being built anew: what learning needs.
//
//     example_many_worlds
#include <cstdio>

#include <murosimf/model/properties.h>
#include <murosimf/motion/motion_properties.h>
#include <murosimf/scene/assets.h>
#include <murosimf/scene/scene.h>

int main() {
  using namespace murosimf;
  using namespace std::chrono_literals;
  const auto assets = std::make_shared<scene::Assets>();  // the robot's files are read once
  const scene::SceneOptions options{.overrides = {"start.jitter_heading_deg=20", "walker.level=simplified_dynamics"},
                                    .cameras = false,
                                    .assets = assets};
  const scene::Scene first("walk", options);
  std::vector<std::unique_ptr<scene::Scene>> worlds;
  for (int i = 0; i < 100; ++i) worlds.push_back(std::make_unique<scene::Scene>(first.spec(), options));

  for (std::uint64_t episode = 0; episode < 2; ++episode) {
    double furthest = 0;
    for (std::uint64_t i = 0; i < worlds.size(); ++i) {
      worlds[i]->reset(episode * worlds.size() + i + 1);
      Simulation& simulation = worlds[i]->simulation();
      simulation.run(200ms);
      furthest = std::max(furthest, norm(simulation.world().entity("walker").base().get(properties::position)));
    }
    std::printf("episode %d: one of %zu robots came %.2f m far\n", static_cast<int>(episode), worlds.size(), furthest);
  }
}
