// Nets of goals keep the ball in.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene_file/field.h"
#include "tests/law.h"
#include "tests/written_scene.h"

namespace murosimf {
namespace {

struct Goalmouth {
  double line, depth, width, height;  // [m]
};

Goalmouth goalmouth(const std::string& field) {
  const scene_file::FieldSize& size = scene_file::field_size(field);
  return {size.length / 2, size.goal_depth, size.goal_width, size.goal_height};
}

/// A ball in front of the goal at x > 0, that flies towards a place in its mouth, y and z in parts of its half width and height.
std::string shot(const std::string& field, double speed, double heading_deg, double y, double z, double rate) {
  const Goalmouth goal = goalmouth(field);
  const double heading = heading_deg * pi / 180, radius = 0.07;
  const Vec3d target{goal.line + 0.05, y * (goal.width / 2 - radius), std::max(0.0, z * (goal.height - 2 * radius))};
  const Vec3d direction{std::cos(heading), std::sin(heading), 0};
  const Vec3d from = target - 0.6 * direction;
  return fmt::format(
      "rate = {}\nfield.size = '{}'\nfield.nets = true\nfield.landmark_poles = false\n[ball]\nradius = {}\nmass = 0.3\n"
      "position = [{}, {}, {}]\nvelocity = [{}, {}, 0.3]\n",
      rate, field, radius, from.x, from.y, from.z, speed * direction.x, speed * direction.y);
}

/// How far [m] a place is outside of the room between line, posts, bars and nets; below 0 inside.
double outside(const Goalmouth& goal, const Vec3d& r) {
  return std::max(
      {goal.line - r.x, r.x - goal.line - goal.depth, std::abs(r.y) - goal.width / 2 - 0.1, r.z - goal.height - 0.1});
}

// 24 shots at each field and step: where it comes to rest, and where it was meanwhile.
TEST(Net, KeepsShotsInTheGoal) {
  int shots = 0;
  law::Worst at_rest, meanwhile, speed_after;
  for (const std::string field : {"kid_size_2008", "kid_size_2023"}) {
    const Goalmouth goal = goalmouth(field);
    for (const double rate : {1000.0, 200.0}) {
      for (const double speed : {3.0, 6.0, 10.0, 20.0}) {
        for (const double heading : {-25.0, 0.0, 25.0}) {
          for (const double z : {0.05, 0.7}) {
            const double y = heading < 0 ? 0.5 : heading > 0 ? -0.5 : 0.1;
            scene::Scene scene(fixtures::write_scene(shot(field, speed, heading, y, z, rate)));
            const ObjectAccess ball = scene.simulation().world().entity("ball").base();
            bool in = false;
            for (int i = 0; i < 100; ++i) {
              scene.simulation().run(from_seconds(0.05));
              const Vec3d r = ball.get(properties::position);
              in |= r.x > goal.line + 0.1;
              if (in) meanwhile.see(outside(goal, r), field, rate, speed, heading, z);
            }
            EXPECT_TRUE(in) << "it was no shot at the goal";
            at_rest.see(outside(goal, ball.get(properties::position)), field, rate, speed, heading, z);
            speed_after.see(norm(ball.get(properties::linear_velocity)), field, rate, speed, heading, z);
            ++shots;
          }
        }
      }
    }
  }
  EXPECT_EQ(shots, 2 * 2 * 24);
  law::expect_below(
      {.law = "96 shots of 3 to 20 m/s at goals with nets: how far outside of the goal the ball comes to rest",
       .level = "simplified_dynamics, 1 and 5 ms",
       .source = "inside"},
      at_rest, 0, "m");
  law::expect_below({.law = "the same: how far outside it was after it had come in",
                     .level = "simplified_dynamics, 1 and 5 ms",
                     .source = "inside"},
                    meanwhile, 0, "m");
  law::expect_below({.law = "the same: speed after 5 s",
                     .level = "simplified_dynamics, 1 and 5 ms",
                     .source = "at rest"},
                    speed_after, 0.05, "m/s");
}

// Without a net the same shots leave it.
TEST(Net, IsWhatKeepsThem) {
  scene::Scene scene(fixtures::write_scene(shot("kid_size_2023", 10, 0, 0.1, 0.7, 1000)),
                     {.overrides = {"field.nets=false"}});
  scene.simulation().run(from_seconds(2));
  const Vec3d r = scene.simulation().world().entity("ball").base().get(properties::position);
  EXPECT_GT(outside(goalmouth("kid_size_2023"), r), 1);
}

// Of 2023, not of the paper's time; a scene says otherwise.
TEST(Net, IsThereAsTheYearOrTheSceneSays) {
  const auto objects = [](const std::string& field) {
    const scene::Scene scene(fixtures::write_scene("[field]\n" + field + "[ball]\n"));
    return scene.simulation().world().entity("field").model().bodies().size();
  };
  EXPECT_EQ(objects("size = 'kid_size_2008'\n"), 13U);
  EXPECT_EQ(objects("size = 'kid_size_2008'\nnets = true\n"), 21U);
  EXPECT_EQ(objects("size = 'kid_size_2023'\n"), 21U);
  EXPECT_EQ(objects("size = 'kid_size_2023'\nnets = false\n"), 13U);
  EXPECT_EQ(objects("size = 'kid_size_2023'\ngoals = false\n"), 1U);
  EXPECT_THROW((void)objects("goals = false\nnets = true\n"), SetupError);
}

// From outside, too: neither from behind nor from above.
TEST(Net, StopsBallsFromOutside) {
  const Goalmouth goal = goalmouth("kid_size_2023");
  const std::string head = "field.size = 'kid_size_2023'\nfield.nets = true\n[ball]\nradius = 0.07\nmass = 0.3\n";
  scene::Scene behind(fixtures::write_scene(
      head + fmt::format("position = [{}, 0.3, 0.5]\nvelocity = [-10, 0, 0]\n", goal.line + goal.depth + 0.5)));
  behind.simulation().run(from_seconds(2));
  EXPECT_GT(behind.simulation().world().entity("ball").base().get(properties::position).x, goal.line + goal.depth);
}

}  // namespace
}  // namespace murosimf
