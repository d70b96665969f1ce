// Another thread steers a running scene and looks at it: lock step, commands, copies of poses. Then the run is repeated from its record.
//
//     example_from_another_thread
#include <cstdio>
#include <thread>

#include <murosimf/runtime/lock_step.h>
#include <murosimf/scene/scene.h>

int main() {
  using namespace murosimf;
  using namespace std::chrono_literals;
  scene::Scene scene("walk");
  LockStep pacer;
  const auto poses = scene.simulation().poses().subscribe({.period = 100ms});
  std::thread run([&] {
    scene.simulation().run(4s, pacer);
    pacer.finish();
  });

  const int robot = 1;  // the second entity of the world; the first one is the field
  for (int cycle = 0; cycle < 40; ++cycle) {
    pacer.advance(100ms);  // now the simulation stands still, for as long as this thread thinks
    const PoseFrame* frame = poses->latest();
    if (!frame) continue;
    const Vec3d& r = frame->position[frame->first[robot]];
    if (cycle % 10 == 0) std::printf("%.1f s: at (%.2f, %.2f) m\n", seconds(frame->time), r.x, r.y);
    if (cycle == 10) (void)scene.post("walker.command = [0.1, 0, 0.5]");
    if (cycle == 20) (void)scene.post("walker.level = simplified_dynamics");
  }
  run.join();

  scene::Scene again("walk", {.events = scene::events_of_commands(scene.simulation().commands())});
  again.simulation().run(scene.simulation().now());
  const bool same = scene.simulation().state_hash() == again.simulation().state_hash();
  std::printf("%.1f s again: %s\n", seconds(again.simulation().now()), same ? "the same, bit for bit" : "not the same");
  return same ? 0 : 1;
}
