// A robot walks cheaply, becomes exact while it is pushed, and walks on cheaply: levels change while the scene runs.
//
//     example_change_levels
#include <cstdio>

#include <murosimf/collision/contact_properties.h>
#include <murosimf/model/properties.h>
#include <murosimf/scene/scene.h>

int main() {
  using namespace murosimf;
  using namespace std::chrono_literals;
  scene::Scene scene("walk");  // a kinematic walker
  Simulation& simulation = scene.simulation();
  Entity& robot = simulation.world().entity("walker");
  const auto push = [&](double newtons) { robot.base().set(properties::applied_force, {{}, {0, newtons, 0}}); };

  simulation.run(3s);
  scene.exchange_level("walker", "articulated_dynamics");
  push(10);
  simulation.run(100ms);
  push(0);
  simulation.run(2s);
  scene.exchange_level("walker", "kinematic_walking");  // throws if the push has thrown it over
  simulation.run(2s);

  for (const Event& event : simulation.events()) std::printf("%.1f s: %s\n", seconds(event.time), event.text.c_str());
  const Vec3d r = robot.base().get(properties::position);
  std::printf("%.1f s: at (%.2f, %.2f) m\n", seconds(simulation.now()), r.x, r.y);
}
