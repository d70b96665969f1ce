// Sensors that work out their samples in several threads: cameras and lasers, by a painter that needs no driver, and
// cameras that draw. The first are the thread sanitizer's view of what sensors share.
#include <algorithm>
#include <atomic>
#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/scene/scene.h"
#include "murosimf/sensors/camera_frame.h"
#include "tests/sensors/range_rig.h"
#include "tests/temp_folder.h"

namespace murosimf::test {
namespace {

using namespace std::chrono_literals;

/// Paints the direction of each pixel; many cameras may ask at once.
class Painter final : public sensors::ViewSource {
 public:
  void draw(const sensors::Perspective& view, const sensors::Layers& layers, double ahead,
            sensors::View& into) noexcept override {
    ++looks;
    if (into.color.width() != view.width || into.color.height() != view.height) {
      into.color = imaging::ColorImage(view.width, view.height);
    }
    const int rows = view.rows > 0 ? view.rows : view.height;
    for (int v = view.first_row; layers.color && v < view.first_row + rows; ++v) {
      for (int u = 0; u < view.width; ++u) {
        const double x = view.left + (u + 0.5) * (view.right - view.left) / view.width;
        const double y = view.top + (v + 0.5) * (view.bottom - view.top) / view.height;
        const Vec3d ray = view.axes * Vec3d{x, y, 1};
        const auto byte = [](double share) {
          return static_cast<std::uint8_t>(std::clamp(128 + 100 * share, 0.0, 255.0));
        };
        into.color(u, v) = {byte(ray.x), byte(ray.y), byte(ray.z + ahead)};
      }
    }
  }

  std::atomic<int> looks = 0;
};

/// What cameras and lasers of four boxes that tumble have seen in the end.
std::uint64_t seen_by_tumblers(int threads) {
  RangeRig rig(threads);
  Painter painter;
  for (const char* name : {"one", "two", "three", "four"}) rig.add_box(name);
  Hasher hasher;
  std::vector<const sensors::Reading*> readings;
  for (Entity* robot : rig.moving_entities) {
    sensors::SensorSpec camera = sensor("camera", {{"width", 64},
                                                   {"height", 48},
                                                   {"opening", 1.2},
                                                   {"k1", -0.25},
                                                   {"k2", 0.05},
                                                   {"always_on", 1},
                                                   {"shot_noise", 0.05},
                                                   {"read_noise", 0.01},
                                                   {"blur", 0.8},
                                                   {"exposure_time", 0.01},
                                                   {"motion_samples", 2},
                                                   {"readout_time", 0.01},
                                                   {"readout_bands", 3}});
    camera.rate = 25;
    (void)component_files::attach_sensor(rig.simulation, *robot, camera,
                                         {1, rig.moving_entities, [&] { return &painter; }}, rig.rate);
    sensors::SensorSpec laser = sensor("laser");
    laser.rate = 40;
    laser.signals[""].noise = 0.01;
    readings.push_back(&rig.attach(*robot, laser));
  }
  rig.begin();
  double x = 0;
  for (Entity* robot : rig.moving_entities) {
    RangeRig::put(*robot, {x, 0.1 * x, 1});
    RangeRig::launch(*robot, {-0.5 * x, 0.3, 0}, {x, 1, 2 - x});
    x += 0.7;
  }
  for (int frame = 0; frame < 5; ++frame) {
    rig.simulation.run(40ms);
    for (const Entity* robot : rig.moving_entities) append_hash(hasher, *sensors::frames_of(*robot).at(0));
  }
  for (const sensors::Reading* reading : readings) append_hash(hasher, *reading);
  EXPECT_GE(painter.looks, 4 * 5 * 2 * 3);
  return hasher.value();
}

TEST(Sensing, ThreadsChangeNoFrameAndNoReading) {
  const std::uint64_t one = seen_by_tumblers(1);
  for (const int threads : {2, 4}) EXPECT_EQ(seen_by_tumblers(threads), one) << threads;
}

TEST(Sensing, ThreadsChangeNothingThatIsDrawn) {
#ifdef MUROSIMF_THREAD_SANITIZER
  GTEST_SKIP() << "the driver of OpenGL has threads of its own, which the thread sanitizer does not see";
#endif
  const std::string file = fixtures::temp_folder().string() + "/sensing_in_threads.toml";
  std::ofstream(file) << R"([ball]
position = [0.8, 0.0]
[defaults]
model = "kid21"
controller = "walk"
[defaults.sensors.camera]
width = 80
height = 60
rate = 20
k1 = -0.2
shot_noise = 0.02
depth = true
labels = true
always_on = true
[[robots]]
name = "one"
[[robots]]
name = "two"
position = [0.6, 0.5]
level = "articulated_dynamics"
[[robots]]
name = "three"
position = [0.6, -0.5]
level = "simplified_dynamics"
)";
  std::vector<std::uint64_t> frames;
  for (const int threads : {1, 3}) {
    scene::Scene scene(file, {.threads = threads});
    scene.simulation().run(200ms);
    Hasher hasher;
    for (const char* name : {"one", "two", "three"}) {
      append_hash(hasher, *sensors::frames_of(scene.simulation().world().entity(name)).at(0));
    }
    frames.push_back(hasher.value());
  }
  EXPECT_EQ(frames[0], frames[1]);
}

}  // namespace
}  // namespace murosimf::test
