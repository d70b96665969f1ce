#include <cstdio>

#include <murosimf/model/properties.h>
#include <murosimf/scene/scene.h>

int main() {
  using namespace murosimf;
  scene::Scene scene("walk", {.overrides = {"walker.level=simplified_dynamics"}});
  Simulation& simulation = scene.simulation();
  simulation.run(std::chrono::seconds(5));
  const Vec3d head = simulation.world().entity("walker").object("head").get(properties::position);
  std::printf("after %.0f s the head is at (%.2f, %.2f, %.2f) m\n", seconds(simulation.now()), head.x, head.y, head.z);
}
