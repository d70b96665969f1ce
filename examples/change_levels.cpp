// A robot walks cheaply, becomes exact while it is pushed, and walks on cheaply: levels change while the scene runs.
//
//     example_change_levels
#include <cstdio>

#include <murosimf/scene.h>

int main() {
  murosimf::Scene scene("walk");  // a kinematic walker
  murosimf::Robot robot = scene.robot("walker");

  scene.run(3.0);
  robot.set_level("articulated_dynamics");
  robot.push("", {0, 10, 0}, 0.1);
  scene.run(2.1);
  robot.set_level("kinematic_walking");  // throws if the push has thrown it over
  scene.run(2.0);

  for (const murosimf::RunEvent& event : scene.events()) std::printf("%.1f s: %s\n", event.time, event.text.c_str());
  const murosimf::Vector3 r = robot.pose().position;
  std::printf("%.1f s: at (%.2f, %.2f) m\n", scene.time(), r.x, r.y);
}
