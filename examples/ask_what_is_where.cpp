// Asks a running game what a robot would see and feel: a ray, a distance, bodies nearby, contacts.
#include <cstdio>

#include <murosimf/collision/queries.h>
#include <murosimf/collision/touches.h>
#include <murosimf/model/properties.h>
#include <murosimf/scene/scene.h>

int main() {
  using namespace murosimf;
  scene::Scene scene("duel", {.overrides = {"blue1.level=simplified_dynamics"}});
  Simulation& simulation = scene.simulation();
  simulation.run(std::chrono::seconds(2));
  Entity& robot = simulation.world().entity("blue1");
  const Entity& ball = simulation.world().entity("ball");

  collision::QueryScene questions(simulation.world());
  questions.refresh();  // after every step of the simulation

  const Vec3d eye = robot.object("head").get(properties::position);
  const Vec3d to_goal = Vec3d{3, 0, 0.1} - eye;
  const auto hit = questions.cast({eye, (1 / norm(to_goal)) * to_goal}, {.range = 10, .without = &robot});
  if (hit) std::printf("looking at the goal: %s, %.2f m away\n", hit->body.entity->name().c_str(), hit->distance);

  const auto gap = questions.distance({&robot}, {&ball});
  if (gap) std::printf("the ball is %.2f m away\n", gap->distance);

  for (const auto& body : questions.overlapping(Sphere{1.0}, {eye, {}})) {
    if (body.entity != &robot) {
      std::printf("within a meter of the head: %s of %s\n", body.entity->model().objects()[body.object].name.c_str(),
                  body.entity->name().c_str());
    }
  }

  double weight = 0;
  for (const auto& touch : collision::touches(simulation.world(), robot)) weight += touch.force.z;
  std::printf("contacts carry %.1f N\n", weight);
}
