/// depth_laser_test - a laser by pictures of depths against the one by rays.
#include "murosimf/sensors/depth_laser.h"

#include <cmath>

#include "tests/law.h"
#include "tests/render/drawn.h"
#include "tests/sensors/range_rig.h"

namespace murosimf::sensors {
namespace {

using test::RangeRig;
using namespace std::chrono_literals;

struct LaserRig : RangeRig {
  explicit LaserRig() = default;
  const Reading& attach_laser(Entity& robot, const SensorSpec& spec) {
    const auto source = [this]() -> ViewSource* {
      if (!renderer) {
        renderer =
            std::make_unique<render::Renderer>(simulation.world(), moving_entities, render::appearance_of_shapes);
        renderer->locate();
      }
      return renderer.get();
    };
    return components::attach_sensor(simulation, robot, spec, {1, moving_entities, source}, rate).reading();
  }
  std::unique_ptr<render::Renderer> renderer;
};

PlacedShape wall(const Vec3d& at, const Vec3d& half) {
  return {.shape = Box{half}, .position = at, .orientation = {}, .surface = {}, .color = {}};
}

TEST(DepthLaser, MeasuresAsTheRaysDo) {
  if (!test::no_drawing().empty()) GTEST_SKIP() << test::no_drawing();
  LaserRig rig;
  Entity& box = rig.add_box("box");
  rig.add_ball("ball", 0.2);
  rig.add_walls({wall({4, 0, 0}, {0.1, 4, 3}), wall({-3, 0, 0}, {0.1, 4, 3}), wall({0, 4, 0}, {4, 0.1, 3}),
                 wall({0, -4, 0}, {4, 0.1, 3}), wall({1.5, 1.5, 0}, {0.3, 0.2, 2})});
  const std::map<std::string, double> numbers{{"rays", 721}, {"fov", 4.7}};
  SensorSpec one = test::sensor("laser", numbers), other = test::sensor("depth_laser", numbers);
  one.position = other.position = {0.05, 0, 0.1};
  const Reading& rays = rig.attach(box, one);
  const Reading& depths = rig.attach_laser(box, other);
  rig.begin();
  RangeRig::put(*rig.moving_entities[1], {2, -0.5, 0.1});
  law::Worst worst;
  int edges = 0, seen = 0;
  for (int i = 0; i < 12; ++i) {
    RangeRig::put(box, {0.1 * i - 0.5, 0.2, 0}, rotation_z(0.5 * i) * rotation_x(0.05 * i));
    rig.simulation.run(1ms);
    for (std::size_t k = 1; k + 1 < rays.values.size(); ++k) {
      // at the edge of a thing one of the two rays may just miss it; very slanted surfaces magnify facets
      const double a = rays.values[k - 1], b = rays.values[k], c = rays.values[k + 1];
      if (std::abs(a - b) > 0.02 * b || std::abs(c - b) > 0.02 * b) {
        ++edges;
        continue;
      }
      ++seen;
      worst.see(std::abs(depths.values[k] - b), i, k);
    }
  }
  EXPECT_GT(seen, 8000);
  EXPECT_LT(edges, 500);
  law::expect_below(
      {"laser by depth pictures against rays, box room, box and ball, where neighbors differ by less than 2 %",
       "depth_laser", "QueryScene::cast"},
      worst, 2e-3, "m");
}

TEST(DepthLaser, ShowsNothingAsInfinityAndItsRobotNotAtAll) {
  if (!test::no_drawing().empty()) GTEST_SKIP() << test::no_drawing();
  LaserRig rig;
  Entity& box = rig.add_box("box");
  rig.add_walls({wall({2, 0, 0}, {0.1, 1, 1})});
  const Reading& depths =
      rig.attach_laser(box, test::sensor("depth_laser", {{"rays", 3}, {"fov", pi}, {"range_max", 5}}));
  rig.begin();
  RangeRig::put(box, {0, 0, 0});
  rig.simulation.run(1ms);
  EXPECT_EQ(depths.values[0], test::infinity);
  EXPECT_NEAR(depths.values[1], 1.9, 2e-3) << "from inside its own box";
  EXPECT_EQ(depths.values[2], test::infinity);
}

TEST(DepthLaser, WithoutAnybodyWhoDrawsItKnowsNothing) {
  RangeRig rig;
  Entity& box = rig.add_box("box");
  const Reading& depths = rig.attach(box, test::sensor("depth_laser", {{"rays", 5}}));
  rig.begin();
  RangeRig::put(box, {0, 0, 0});
  rig.simulation.run(1ms);
  EXPECT_TRUE(std::isnan(depths.values[2]));
}

}  // namespace
}  // namespace murosimf::sensors
