// Queries of a running game: what a ray meets, a distance, contacts.
#include <cstdio>

#include <murosimf/scene.h>

int main() {
  using namespace murosimf;
  Scene scene("duel", {.set = {"blue1.level=simplified_dynamics"}});
  scene.run(2.0);

  const Vector3 eye = scene.robot("blue1").pose("head").position;
  const Vector3 to_goal{3 - eye.x, -eye.y, 0.1 - eye.z};
  const auto hit = scene.cast(eye, to_goal, 10, "blue1");
  if (hit) std::printf("looking at the goal: %s, %.2f m away\n", hit->entity.c_str(), hit->distance);

  const auto gap = scene.distance("blue1", "ball");
  if (gap) std::printf("the ball is %.2f m away\n", *gap);

  double weight = 0;
  for (const Contact& contact : scene.contacts()) {
    if (contact.a == "blue1" && contact.b == "field") weight += contact.force.z;
  }
  std::printf("contacts with the field carry %.1f N\n", weight);
}
