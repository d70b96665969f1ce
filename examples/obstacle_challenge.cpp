// A robot crosses the field between poles that its camera sees: does it touch one?
//
// <!-- not run (example_obstacle_challenge  ): takes minutes -->
//     example_obstacle_challenge                      # a table: five seeds at every level
//     example_obstacle_challenge kinematic_walking    # one seed at one level
//     example_obstacle_challenge course camera 12     # course.png, camera.png at a time [s], as in the paper's Fig. 8
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include <murosimf/collision/queries.h>
#include <murosimf/files/output_file.h>
#include <murosimf/render/field_picture.h>
#include <murosimf/render/image_png.h>
#include <murosimf/scene/scene.h>
#include <murosimf/scene_file/field.h>
#include <murosimf/soccer/behavior_properties.h>
#include <murosimf/soccer/obstacle_course.h>
#include <murosimf/soccer/planar.h>

using namespace murosimf;
using namespace std::chrono_literals;

namespace {

constexpr double field_half_length = 3;  // [m]
constexpr Color black{0, 0, 0}, magenta{0.85, 0.1, 0.6}, red{0.95, 0.1, 0.1}, blue{0.2, 0.4, 0.95};

struct Crossing {
  double nearest = std::numeric_limits<double>::infinity();  // [m] to a pole, less than 0 if it touched
  double time = 0;                                           // [s] at which it was across; 0: never
};

Crossing cross(const std::string& level, std::uint64_t seed) {
  scene::Scene scene("obstacle_challenge", {.seed = seed, .overrides = {"robot.level=" + level}});
  Simulation& simulation = scene.simulation();
  Entity& robot = simulation.world().entity("robot");
  collision::QueryScene queries(simulation.world());
  Crossing crossing;
  while (crossing.time == 0 && simulation.now() < from_seconds(scene.spec().duration)) {
    simulation.run(20ms);
    queries.refresh();
    for (const Entity* moving_entity : scene.moving_entities()) {
      if (moving_entity == &robot) continue;
      const auto gap = queries.distance({&robot}, {moving_entity});
      crossing.nearest = std::min(crossing.nearest, gap->distance);
    }
    if (robot.base().get(properties::position).x > field_half_length - 0.2) crossing.time = seconds(simulation.now());
  }
  return crossing;
}

void print_table(const std::vector<std::string>& levels, std::uint64_t seeds) {
  std::printf("level                   seed   across after [s]   nearest to a pole [m]\n");
  for (const std::string& level : levels) {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const Crossing crossing = cross(level, seed);
      std::printf("%-22s %5d %18.1f %23.3f\n", level.c_str(), static_cast<int>(seed), crossing.time, crossing.nearest);
      std::fflush(stdout);
    }
  }
}

/// Poles as they stand, in their own color; obstacles black and the way red, as the robot sees them from where it is.
void draw(const std::string& course_file, const std::string& camera_file, double time) {
  scene::Scene scene("obstacle_challenge");
  scene.simulation().run(from_seconds(time));
  Entity& robot = scene.simulation().world().entity("robot");
  const soccer::Course& course = robot.base().get(soccer::planned_course);
  const Vec3d place = robot.base().get(properties::position);
  const Vec3d truth{place.x, place.y, heading(robot.base().get(properties::orientation))};
  const Vec3d believed = robot.base().get(properties::pose_estimate);
  const auto shown = [&](const Vec3d& p) { return soccer::from_frame(truth, soccer::to_frame(believed, p)); };
  render::Overlay overlay;
  for (Entity* moving_entity : scene.moving_entities()) {
    if (moving_entity == &robot) continue;
    overlay.circles.push_back({moving_entity->base().get(properties::position), 0.1, magenta, true});
  }
  for (const soccer::Obstacle& obstacle : course.obstacles.all()) {
    overlay.circles.push_back({shown(obstacle.place), 0.12, black});
  }
  overlay.lines.push_back({{}, red, true});
  for (const Vec3d& point : course.way) overlay.lines.back().points.push_back(shown(point));
  overlay.arrows.push_back({truth, 0.4, blue});
  char title[80];
  std::snprintf(title, sizeof title, "%s: %.1f s", scene.spec().name.c_str(), time);
  files::write_file(course_file,
                    render::field_picture_png(scene_file::field_markings(scene_file::kid_size_2008, false), {},
                                              {.pixels_per_meter = 100, .title = title, .overlay = overlay}));
  files::write_file(camera_file, render::image_png(sensors::frames_of(robot).front()->color));
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc > 2) {
    draw(argv[1] + std::string(".png"), argv[2] + std::string(".png"), argc > 3 ? std::atof(argv[3]) : 10);
  } else if (argc > 1) {
    print_table({argv[1]}, 1);
  } else {
    print_table({"kinematic_walking", "simplified_dynamics", "full_dynamics", "articulated_dynamics"}, 5);
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
