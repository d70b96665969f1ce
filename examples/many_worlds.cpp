// A hundred worlds in one process, each put back to its start with another seed instead of being built anew, as for learning.
//
//     example_many_worlds
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <murosimf/batch.h>

int main() {
  using namespace murosimf;
  Batch worlds("walk", 100,
               {.set = {"start.jitter_heading_deg=20", "walker.level=simplified_dynamics"}, .cameras = false}, 2);

  std::vector<double> turned(worlds.size());  // [rad]
  for (std::uint64_t episode = 0; episode < 2; ++episode) {
    worlds.reset(episode * worlds.size() + 1);
    worlds.step(200);
    const std::span<const double> pose = worlds.base_pose();  // 7 numbers of each: position, quaternion
    for (std::size_t i = 0; i < turned.size(); ++i) turned[i] = 2 * std::atan2(pose[7 * i + 6], pose[7 * i + 3]);
    const auto [least, most] = std::minmax_element(turned.begin(), turned.end());
    std::printf("episode %d: headings of %zu robots from %.2f to %.2f rad\n", static_cast<int>(episode), worlds.size(),
                *least, *most);
  }
}
