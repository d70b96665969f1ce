// A hundred worlds in one process, each put back to its start with another seed instead of being built anew: what learning needs.
//
//     example_many_worlds
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <murosimf/model/properties.h>
#include <murosimf/runtime/thread_pool.h>
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

  ThreadPool pool(2);  // each world has one thread at a time
  std::vector<double> turned(worlds.size());
  for (std::uint64_t episode = 0; episode < 2; ++episode) {
    pool.for_each(worlds.size(), [&](std::size_t i) {
      worlds[i]->reset(episode * worlds.size() + i + 1);
      worlds[i]->simulation().run(200ms);
      const Mat3d axes = worlds[i]->simulation().world().entity("walker").base().get(properties::orientation);
      turned[i] = std::atan2(axes.x.y, axes.x.x);
    });
    const auto [least, most] = std::minmax_element(turned.begin(), turned.end());
    std::printf("episode %d: headings of %zu robots from %.2f to %.2f rad\n", static_cast<int>(episode), worlds.size(),
                *least, *most);
  }
}
