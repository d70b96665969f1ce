// A robot is added to a game that runs, a box falls into its way, and both leave again.
//
//     example_come_and_go
#include <cstdio>

#include <murosimf/model/properties.h>
#include <murosimf/scene/scene.h>

int main() {
  using namespace murosimf;
  using namespace std::chrono_literals;
  scene::Scene scene("walk");
  Simulation& simulation = scene.simulation();
  simulation.run(2s);

  scene_file::RobotSpec robot = scene.spec().robots[0];  // as the walker, but beside it, and exact
  robot.name = "second";
  robot.level = "full_dynamics";
  robot.position.y += 0.8;
  Entity& second = scene.add(robot);

  scene_file::BodySpec box;
  box.name = "box";
  box.shape = Box{{0.1, 0.3, 0.1}};  // half of its edges
  box.mass = 1;
  box.position = robot.position + Vec3d{0.35, 0, 0.5};
  scene.add(box);
  simulation.run(4s);
  const Vec3d at_the_box = second.base().get(properties::position);

  scene.leave("box");
  simulation.run(2s);
  const Vec3d in_the_end = second.base().get(properties::position);
  scene.leave("second");
  simulation.run(1s);

  for (const Event& event : simulation.events()) std::printf("%.1f s: %s\n", seconds(event.time), event.text.c_str());
  std::printf("second: %.2f m with the box in its way, %.2f m without\n", at_the_box.x - robot.position.x,
              in_the_end.x - at_the_box.x);
}
