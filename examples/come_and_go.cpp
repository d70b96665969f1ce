// A robot is added to a game that runs, a box falls into its way, and both leave again.
//
//     example_come_and_go
#include <cstdio>

#include <murosimf/scene.h>

int main() {
  using namespace murosimf;
  Scene scene("walk");
  scene.run(2.0);

  const Vector3 begin{-2, 0.8, 0};
  Robot second = scene.add(
      NewRobot{.name = "second", .model = "kid21", .level = "full_dynamics", .controller = "walk", .position = begin});
  second.set_command(0.15, 0, 0);
  scene.add(NewBody{.name = "box",
                    .shape = NewBody::Shape::box,
                    .size = {0.2, 0.6, 0.2},
                    .mass = 1,
                    .position = {begin.x + 0.35, begin.y, 0.5}});
  scene.run(4.0);
  const double at_the_box = second.pose().position.x;

  scene.leave("box");
  scene.run(2.0);
  const double in_the_end = second.pose().position.x;
  scene.leave("second");
  scene.run(1.0);

  for (const RunEvent& event : scene.events()) std::printf("%.1f s: %s\n", event.time, event.text.c_str());
  std::printf("second: %.2f m with the box in its way, %.2f m without\n", at_the_box - begin.x,
              in_the_end - at_the_box);
}
