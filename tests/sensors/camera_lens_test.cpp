// Pictures through a lens: every pixel shows its direction, in every layer, in every picture.
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "murosimf/sensors/camera.h"
#include "tests/sensors/painter.h"

namespace murosimf::sensors {
namespace {

using fixtures::says;
using test::camera;
using test::CameraRig;
using test::RangeRig;
using namespace std::chrono_literals;

/// Pixels show the directions that the lens says; windows of any number.
void expect_directions(const std::map<std::string, double>& numbers, const std::string& lens, std::size_t views) {
  CameraRig rig;
  Entity& box = rig.add_box("box");
  SensorSpec spec = camera(numbers);
  spec.numbers["width"] = 160;
  spec.numbers["height"] = 120;
  spec.texts["lens"] = lens;
  const CameraFrame& frame = rig.attach_camera(box, spec);
  rig.begin();
  RangeRig::put(box, {0, 0, 1});
  rig.simulation.run(61ms);  // several frames: images take turns
  EXPECT_EQ(rig.painter.looks.size(), 4 * views);
  for (int v = 0; v < 120; v += 7) {
    for (int u = 0; u < 160; u += 7) {
      const auto ray = frame.info->lens.ray({static_cast<double>(u), static_cast<double>(v)});
      ASSERT_TRUE(ray);
      const Vec3d world = optical_axes * *ray;
      EXPECT_NEAR(frame.color(u, v).green, 127.5 + 127.5 * world.y, 1.5) << u << " " << v;
      EXPECT_NEAR(frame.color(u, v).blue, 127.5 + 127.5 * world.z, 1.5) << u << " " << v;
    }
  }
}

TEST(CameraLens, ADistortedPictureShowsEachPixelsDirection) {
  expect_directions({{"k1", -0.25}, {"k2", 0.05}}, "plumb_bob", 1);
}
TEST(CameraLens, AWideLensIsMadeOfSeveralViews) { expect_directions({{"fov", 2.9}}, "equidistant", 5); }

// A pixel's label comes from a view that sees its direction; the painter's labels are the numbers of the views.
TEST(CameraLens, AWideLensTakesLabelsFromTheViewThatSeesThem) {
  CameraRig rig;
  Entity& box = rig.add_box("box");
  SensorSpec spec = camera({{"fov", 2.9}, {"labels", 1}, {"width", 80}, {"height", 60}});
  spec.texts["lens"] = "equidistant";
  const CameraFrame& frame = rig.attach_camera(box, spec);
  rig.begin();
  RangeRig::put(box, {0, 0, 1});
  rig.simulation.run(1ms);
  ASSERT_EQ(rig.painter.looks.size(), 5U);
  std::set<int> views;
  for (int v = 0; v < 60; v += 3) {
    for (int u = 0; u < 80; u += 3) {
      const int label = frame.labels(u, v);
      ASSERT_TRUE(label >= 1 && label <= 5) << u << " " << v << " " << label;
      const Perspective& view = rig.painter.looks[static_cast<std::size_t>(label - 1)].view;
      const auto ray = frame.info->lens.ray({static_cast<double>(u), static_cast<double>(v)});
      ASSERT_TRUE(ray);
      const Vec3d seen = transpose(view.axes) * (optical_axes * *ray);
      EXPECT_GT(seen.z, 0);
      const double x = seen.x / seen.z, y = seen.y / seen.z, pixel = (view.right - view.left) / view.width;
      EXPECT_TRUE(x > view.left - pixel && x < view.right + pixel && y > view.top - pixel && y < view.bottom + pixel);
      views.insert(label);
    }
  }
  EXPECT_EQ(views.size(), 5U) << "all of them are seen";
}

// Pictures take turns: the second one is made where nothing was drawn before.
TEST(CameraLens, EveryPictureThroughALensIsWhole) {
  for (const char* mosaic : {"", "rggb"}) {
    CameraRig rig;
    Entity& box = rig.add_box("box");
    SensorSpec spec = camera({{"k1", -0.2}, {"depth", 1}, {"labels", 1}});
    if (*mosaic != '\0') spec.texts["mosaic"] = mosaic;
    const CameraFrame& frame = rig.attach_camera(box, spec);
    rig.begin();
    RangeRig::put(box, {0, 0, 1});
    rig.simulation.run(1ms);
    const CameraFrame first = frame;
    for (std::uint64_t number = 2; number <= 4; ++number) {
      rig.simulation.run(20ms);
      ASSERT_EQ(frame.number, number);
      EXPECT_TRUE(std::ranges::equal(frame.color.pixels(), first.color.pixels())) << mosaic << number;
      EXPECT_TRUE(std::ranges::equal(frame.mosaic.pixels(), first.mosaic.pixels())) << mosaic << number;
      EXPECT_TRUE(std::ranges::equal(frame.depth.pixels(), first.depth.pixels())) << mosaic << number;
      EXPECT_EQ(frame.labels.width(), 40) << mosaic << number;
    }
  }
}

// Bands of rows are exposed one after the other, and none of them takes away what others have left; depths are the painter's.
TEST(CameraLens, RowsAreExposedOneAfterTheOther) {
  CameraRig rig;
  Entity& box = rig.add_box("box");
  SensorSpec spec = camera({{"k1", -0.1}, {"readout_time", 0.09}, {"readout_bands", 10}, {"depth", 1}});
  const CameraFrame& frame = rig.attach_camera(box, spec);
  rig.begin();
  RangeRig::put(box, {0, 0, 1});
  rig.simulation.run(1ms);
  for (int v = 0; v < 30; ++v) {
    EXPECT_NEAR(frame.color(20, v).red, 1000 * 0.09 * (v / 3 + 0.5) / 10, 1.1) << v;
    EXPECT_NEAR(frame.depth(20, v), 2, 1e-5) << v;
  }
}

TEST(CameraLens, ALensThatFoldsOverIsRemarkedWithItsAngle) {
  CameraRig rig;
  Entity& box = rig.add_box("box");
  const SensorSpec spec = camera({{"k1", -0.9}, {"fx", 15}});
  const Sensor& sensor =
      component_files::attach_sensor(rig.simulation, box, spec, {1, rig.moving_entities, {}}, rig.rate);
  EXPECT_TRUE(says(sensor.diagnostic({}), {"folds", "deg"}));
}

}  // namespace
}  // namespace murosimf::sensors
