/// camera_test - a camera looks from where it is mounted, at the times it says, through its lens. Who draws is a stand-in
/// that paints where and when it was asked to look.
#include "murosimf/sensors/camera.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "murosimf/imaging/srgb.h"
#include "tests/sensors/range_rig.h"

namespace murosimf::sensors {
namespace {

using fixtures::error_of;
using fixtures::says;
using test::RangeRig;
using namespace std::chrono_literals;

/// Red: 1000 times the time ahead. Green and blue: the direction of the pixel in the world, y and z. Depth: 2 along the
/// axis. Labels: the number of the call.
class Painter final : public ViewSource {
 public:
  void draw(const Perspective& view, const Layers& layers, double ahead, View& into) noexcept override {
    looks.push_back({view, layers, ahead});
    const auto fit = [&](auto& image) {
      if (image.width() != view.width || image.height() != view.height) {
        image = std::remove_reference_t<decltype(image)>(view.width, view.height);
      }
    };
    fit(into.color);
    fit(into.depth);
    fit(into.labels);
    const int rows = view.rows > 0 ? view.rows : view.height;
    for (int v = view.first_row; v < view.first_row + rows; ++v) {
      for (int u = 0; u < view.width; ++u) {
        const double x = view.left + (u + 0.5) * (view.right - view.left) / view.width;
        const double y = view.top + (v + 0.5) * (view.bottom - view.top) / view.height;
        const Vec3d ray = view.axes * ((1 / std::sqrt(x * x + y * y + 1)) * Vec3d{x, y, 1});
        const auto byte = [](double share) { return static_cast<std::uint8_t>(std::lround(127.5 + 127.5 * share)); };
        if (layers.color)
          into.color(u, v) = {static_cast<std::uint8_t>(std::lround(1000 * ahead)), byte(ray.y), byte(ray.z)};
        if (layers.depth) into.depth(u, v) = 2;
        if (layers.labels) into.labels(u, v) = static_cast<std::uint16_t>(looks.size());
      }
    }
  }

  struct Look {
    Perspective view;
    Layers layers;
    double ahead;
  };
  std::vector<Look> looks;
};

SensorSpec camera(const std::map<std::string, double>& numbers = {}) {
  SensorSpec spec;
  spec.name = "eye";
  spec.type = "camera";
  spec.rate = 50;
  spec.numbers = {{"width", 40}, {"height", 30}, {"fov", 1.0}, {"always_on", 1}};
  for (const auto& [key, number] : numbers) spec.numbers[key] = number;
  return spec;
}

struct CameraRig : RangeRig {
  const CameraFrame& attach_camera(Entity& robot, const SensorSpec& spec) {
    reading =
        &components::attach_sensor(simulation, robot, spec, {1, moving_entities, [this] { return &painter; }}, rate)
             .reading();
    return *frames_of(robot).at(0);
  }
  Painter painter;
  const Reading* reading = nullptr;
};

TEST(Camera, LooksFromItsPlaceAlongItsXAxis) {
  CameraRig rig;
  Entity& box = rig.add_box("box");
  SensorSpec spec = camera();
  spec.position = {0.1, 0.02, 0.03};
  spec.orientation = rotation_y(0.2);
  const CameraFrame& frame = rig.attach_camera(box, spec);
  rig.begin();
  const Mat3d turn = rotation_z(0.5) * rotation_x(0.3);
  RangeRig::put(box, {1, 2, 3}, turn);
  rig.simulation.run(1ms);
  ASSERT_EQ(rig.painter.looks.size(), 1u);
  const Perspective& view = rig.painter.looks[0].view;
  const Mat3d axes = turn * rotation_y(0.2);
  EXPECT_LT(norm(view.eye - (Vec3d{1, 2, 3} + turn * spec.position)), 1e-12);
  EXPECT_LT(norm(view.axes.z - axes.x), 1e-12) << "forward";
  EXPECT_LT(norm(view.axes.x + axes.y), 1e-12) << "right";
  EXPECT_LT(norm(view.axes.y + axes.z), 1e-12) << "down";
  EXPECT_NEAR(view.right - view.left, 2 * std::tan(0.5), 1e-12);
  EXPECT_EQ(frame.number, 1u);
  EXPECT_EQ(frame.color.width(), 40);
  EXPECT_EQ(frame.color.height(), 30);
  const auto intrinsics = rig.reading->output("intrinsics");
  EXPECT_NEAR(intrinsics[0], 20 / std::tan(0.5), 1e-9);
  EXPECT_EQ(intrinsics[2], 19.5);
}

TEST(Camera, AMountingErrorTurnsWhatIsSeenNotWhatIsBelieved) {
  CameraRig rig;
  Entity& box = rig.add_box("box");
  SensorSpec spec = camera();
  spec.orientation = rotation_y(0.2);
  spec.mounting_error = {0.01, -0.02, 0.03};
  const CameraFrame& frame = rig.attach_camera(box, spec);
  rig.begin();
  RangeRig::put(box, {0, 0, 1});
  rig.simulation.run(1ms);
  const Mat3d error = rotation_z(0.03) * rotation_y(-0.02) * rotation_x(0.01);
  EXPECT_LT(norm(rig.painter.looks[0].view.axes.z - (rotation_y(0.2) * error).x), 1e-12);
  EXPECT_LT(norm(frame.info->orientation.z - (rotation_y(0.2) * error).x), 1e-12);
  EXPECT_LT(norm(frame.info->nominal.z - rotation_y(0.2).x), 1e-12);
  EXPECT_LT(norm(frame.info->nominal.x - Vec3d{0, -1, 0}), 1e-12);
  EXPECT_EQ(rig.reading->output("mounting_error")[1], -0.02);
}

TEST(Camera, AFrameComesLateAndSaysWhenItWasExposed) {
  CameraRig rig;
  Entity& box = rig.add_box("box");
  SensorSpec spec = camera();
  spec.delay = 0.033;
  const CameraFrame& frame = rig.attach_camera(box, spec);
  rig.begin();
  RangeRig::put(box, {0, 0, 1});
  rig.simulation.run(33ms);
  EXPECT_EQ(frame.number, 0u);
  rig.simulation.run(1ms);
  EXPECT_EQ(frame.number, 1u);
  EXPECT_EQ(frame.time, 0ms);
  rig.simulation.run(20ms);
  EXPECT_EQ(frame.number, 2u);
  EXPECT_EQ(frame.time, 20ms) << "50 Hz";
  EXPECT_EQ(rig.painter.looks.size(), 3u) << "at 0, 20 and 40 ms";
}

TEST(Camera, DrawsOnlyForSomebody) {
  for (const bool wanted : {false, true}) {
    CameraRig rig;
    Entity& box = rig.add_box("box");
    const CameraFrame& frame = rig.attach_camera(box, camera({{"always_on", 0}}));
    if (wanted) (void)want_frames(box, "eye");
    rig.begin();
    RangeRig::put(box, {0, 0, 1});
    rig.simulation.run(100ms);
    EXPECT_EQ(rig.painter.looks.empty(), !wanted);
    EXPECT_EQ(frame.number, wanted ? 5u : 0u);
  }
}

TEST(Camera, WithoutAnybodyWhoDrawsThereAreNoFrames) {
  RangeRig rig;
  Entity& box = rig.add_box("box");
  rig.attach(box, camera());
  rig.begin();
  RangeRig::put(box, {0, 0, 1});
  rig.simulation.run(100ms);
  EXPECT_EQ(frames_of(box).at(0)->number, 0u);
}

TEST(Camera, RowsAreExposedOneAfterTheOther) {
  CameraRig rig;
  Entity& box = rig.add_box("box");
  const CameraFrame& frame = rig.attach_camera(box, camera({{"readout_time", 0.09}, {"readout_bands", 10}}));
  rig.begin();
  RangeRig::put(box, {0, 0, 1});
  box.base().set(properties::angular_velocity, {0, 0, 2});
  box.base().set(properties::linear_velocity, {0.5, 0, 0});
  rig.simulation.run(1ms);
  ASSERT_EQ(rig.painter.looks.size(), 10u);
  for (int v = 0; v < 30; ++v) {
    const int band = v / 3;
    const double ahead = 0.09 * (band + 0.5) / 10;
    EXPECT_NEAR(frame.color(5, v).red, 1000 * ahead, 0.6) << v;
    const Perspective& view = rig.painter.looks[static_cast<std::size_t>(band)].view;
    EXPECT_LT(norm(view.axes.z - rotation_z(2 * ahead).x), 1e-12);
    EXPECT_NEAR(view.eye.x, 0.5 * ahead, 1e-12);
  }
}

TEST(Camera, AnExposureIsTheMeanOfItsTime) {
  CameraRig rig;
  Entity& box = rig.add_box("box");
  const CameraFrame& frame =
      rig.attach_camera(box, camera({{"exposure_time", 0.2}, {"motion_samples", 4}, {"depth", 1}, {"labels", 1}}));
  rig.begin();
  RangeRig::put(box, {0, 0, 1});
  rig.simulation.run(1ms);
  ASSERT_EQ(rig.painter.looks.size(), 4u);
  double light = 0;  // of the red values 25, 75, 125, 175
  for (const int red : {25, 75, 125, 175}) light += imaging::light_of_srgb(red / 255.0) / 4;
  EXPECT_NEAR(frame.color(7, 7).red, 255 * imaging::srgb_of_light(light), 1);
  EXPECT_EQ(frame.labels(7, 7), 1) << "labels are those of the first instant";
  EXPECT_FALSE(rig.painter.looks[1].layers.depth);
}

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

TEST(Camera, ADistortedPictureShowsEachPixelsDirection) {
  expect_directions({{"k1", -0.25}, {"k2", 0.05}}, "plumb_bob", 1);
}
TEST(Camera, AWideLensIsMadeOfSeveralViews) { expect_directions({{"fov", 2.9}}, "equidistant", 5); }

// Pictures take turns: the second one is made where nothing was drawn before.
TEST(Camera, EveryPictureThroughALensIsWhole) {
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

TEST(Camera, EffectsComeAfterTheLens) {
  CameraRig rig;
  Entity& box = rig.add_box("box");
  SensorSpec spec = camera({{"exposure", 0.25}, {"blur", 1}, {"read_noise", 0.01}});
  spec.texts["mosaic"] = "rggb";
  const CameraFrame& frame = rig.attach_camera(box, spec);
  rig.begin();
  RangeRig::put(box, {0, 0, 1});
  rig.simulation.run(1ms);
  EXPECT_TRUE(frame.color.empty());
  ASSERT_EQ(frame.mosaic.width(), 40);
  // green of a level view in the middle is 127.5: a quarter of its light
  EXPECT_NEAR(frame.mosaic(20, 15), 255 * imaging::srgb_of_light(0.25 * imaging::light_of_srgb(0.5)), 25);
}

TEST(Camera, NoiseIsAnotherOneInEachFrameAndTheSameInEachRun) {
  std::vector<std::uint64_t> first, second;
  for (auto* hashes : {&first, &second}) {
    CameraRig rig;
    Entity& box = rig.add_box("box");
    const CameraFrame& frame = rig.attach_camera(box, camera({{"shot_noise", 0.05}}));
    rig.begin();
    RangeRig::put(box, {0, 0, 1});
    for (int i = 0; i < 3; ++i) {
      rig.simulation.run(20ms);
      CameraFrame timeless = frame;
      timeless.time = {};
      timeless.number = 0;
      hashes->push_back(hash_of(timeless));
    }
  }
  EXPECT_EQ(first, second);
  EXPECT_NE(first[0], first[1]);
}

TEST(Camera, WhatIsWrongIsNamed) {
  const auto error = [](const std::map<std::string, double>& numbers, const std::string& lens = "") {
    return error_of([&] {
      CameraRig rig;
      Entity& box = rig.add_box("box");
      SensorSpec spec = camera(numbers);
      if (!lens.empty()) spec.texts["lens"] = lens;
      rig.attach_camera(box, spec);
    });
  };
  EXPECT_TRUE(says(error({{"width", 0}}), {"eye", "width"}));
  EXPECT_TRUE(says(error({{"height", 100000}}), {"eye", "height"}));
  EXPECT_TRUE(says(error({{"fx", 0}}), {"focal length"}));
  EXPECT_TRUE(says(error({{"fov", 3.5}}), {"fov"}));
  EXPECT_TRUE(says(error({{"k1", 0.1}}, "perspective"), {"k1", "perspective"}));
  EXPECT_TRUE(says(error({}, "fish"), {"fish"}));
  EXPECT_TRUE(says(error({{"color", 0}}), {"color", "depth", "labels"}));
  EXPECT_TRUE(says(error({{"blur", -1}}), {"blur"}));
  EXPECT_TRUE(says(error({{"exposure", 0}}), {"exposure"}));
}

TEST(Camera, ALensThatFoldsOverIsRemarkedWithItsAngle) {
  CameraRig rig;
  Entity& box = rig.add_box("box");
  const SensorSpec spec = camera({{"k1", -0.9}, {"fx", 15}});
  const Sensor& sensor = components::attach_sensor(rig.simulation, box, spec, {1, rig.moving_entities, {}}, rig.rate);
  EXPECT_TRUE(says(sensor.remark({}), {"folds", "deg"}));
}

}  // namespace
}  // namespace murosimf::sensors
