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
        renderer = std::make_unique<render::SoftwareRenderer>(simulation.world(), moving_entities,
                                                              render::appearance_of_shapes);
        renderer->locate();
      }
      return renderer.get();
    };
    return component_files::attach_sensor(simulation, robot, spec, {1, moving_entities, source}, rate).reading();
  }
  std::unique_ptr<render::SoftwareRenderer> renderer;
};

PlacedShape wall(const Vec3d& at, const Vec3d& half) {
  return {.shape = Box{half}, .position = at, .orientation = {}, .surface = {}, .color = {}};
}

TEST(DepthLaser, MeasuresAsTheRaysDo) {
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

/// Draws walls at the distance 2 from the plane through the eye across the row's axis, and keeps what it was asked for.
struct Asked final : ViewSource {
  void draw(const Perspective& row, const Layers& layers, double, View& into) noexcept override {
    rows.push_back(row);
    only_depth = only_depth && layers.depth && !layers.color && !layers.labels;
    into.depth = imaging::DepthImage(row.width, 1, 2.0F);
  }
  std::vector<Perspective> rows;
  bool only_depth = true;
};

/// Requests of a laser to its source of pictures, and its output.
struct Looked {
  explicit Looked(const std::map<std::string, double>& numbers) {
    box = &rig.add_box("box");
    const auto source = [this]() -> ViewSource* { return &asked; };
    const Reading& reading = component_files::attach_sensor(rig.simulation, *box, test::sensor("depth_laser", numbers),
                                                            {1, rig.moving_entities, source}, rig.rate)
                                 .reading();
    rig.begin();
    RangeRig::put(*box, {1, 2, 3}, rotation_z(0.5));
    rig.simulation.run(1ms);
    values = reading.values;
  }
  RangeRig rig;
  Entity* box = nullptr;
  Asked asked;
  std::vector<double> values;
};

/// [rad] of the row's axis about the box's z axis, from its x axis on.
double bearing(const Perspective& row) {
  const Vec3d axis = transpose(rotation_z(0.5)) * row.axes.z;
  return std::atan2(axis.y, axis.x);
}

// Eight pixels for each ray, from 256 to 8192; rows of 80 degrees at most, each a bit wider than its part of the fan.
TEST(DepthLaser, AsksForRowsThatCoverItsFan) {
  const Looked looked({{"rays", 301}, {"fov", 3.0}, {"first_angle", -1.0}});
  ASSERT_EQ(looked.asked.rows.size(), 3U);
  EXPECT_TRUE(looked.asked.only_depth);
  for (std::size_t i = 0; i < 3; ++i) {
    const Perspective& row = looked.asked.rows[i];
    EXPECT_EQ(row.width, static_cast<int>(8 * 301 / 3.0));
    EXPECT_EQ(row.height, 1);
    EXPECT_NEAR(bearing(row), -0.5 + static_cast<double>(i), 1e-12);
    EXPECT_LT(fixtures::difference(row.axes.y, {0, 0, -1}), 1e-12);
    EXPECT_LT(fixtures::difference(cross(row.axes.x, row.axes.y), row.axes.z), 1e-12);
    EXPECT_LT(fixtures::difference(row.eye, {1, 2, 3}), 1e-9);
    EXPECT_EQ(row.without, looked.box);
    EXPECT_TRUE(row.finest);
    const double pixel = (row.right - row.left) / row.width;
    EXPECT_NEAR(row.right, std::tan(0.5) + 2 * pixel, 0.02 * pixel) << "two pixels more";
    EXPECT_EQ(row.left, -row.right);
    EXPECT_NEAR(row.bottom - row.top, pixel, 1e-15) << "pixels are square";
    EXPECT_EQ(row.top, -row.bottom);
  }
  EXPECT_EQ(Looked({{"rays", 5}, {"fov", 1}}).asked.rows[0].width, 256);
  EXPECT_EQ(Looked({{"rays", 2000}, {"fov", 1}}).asked.rows[0].width, 8192);
  EXPECT_EQ(Looked({{"rays", 1}, {"fov", 0}}).asked.rows.size(), 1U);
  EXPECT_EQ(Looked({{"rays", 9}, {"fov", 79.9 * pi / 180}}).asked.rows.size(), 1U);
  EXPECT_EQ(Looked({{"rays", 9}, {"fov", 80.1 * pi / 180}}).asked.rows.size(), 2U);
  EXPECT_EQ(Looked({{"rays", 9}, {"fov", 160.1 * pi / 180}}).asked.rows.size(), 3U);
}

// Each ray finds the wall of its row: at 2 / cos of the angle between them.
TEST(DepthLaser, RaysAreEvenlyOverTheFan) {
  for (const int rays : {2, 3, 301}) {
    const Looked looked({{"rays", rays}, {"fov", 3.0}, {"first_angle", -1.0}});
    ASSERT_EQ(looked.values.size(), static_cast<std::size_t>(rays));
    for (int i = 0; i < rays; ++i) {
      const double angle = 3.0 * i / (rays - 1), row = std::min(std::floor(angle), 2.0) + 0.5;
      if (std::abs(angle - std::round(angle)) < 1e-9 && i > 0 && i + 1 < rays) continue;  // at the seam of two rows
      EXPECT_NEAR(looked.values[static_cast<std::size_t>(i)], 2 / std::cos(angle - row), 1e-6) << i << " of " << rays;
    }
  }
  EXPECT_NEAR(Looked({{"rays", 1}, {"fov", 0}}).values[0], 2, 1e-9);
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
