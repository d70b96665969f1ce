// A camera looks from where it is mounted, at the times it says; what it says of itself, and what is refused.
#include "murosimf/sensors/camera.h"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "murosimf/imaging/srgb.h"
#include "tests/sensors/painter.h"

namespace murosimf::sensors {
namespace {

using fixtures::error_of;
using fixtures::says;
using test::camera;
using test::CameraRig;
using test::RangeRig;
using namespace std::chrono_literals;

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
  EXPECT_TRUE(frame.depth.empty() && frame.labels.empty() && frame.mosaic.empty()) << "not requested";
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
  const auto shown = rig.reading->output("mounting_error");
  EXPECT_EQ(std::vector<double>(shown.begin(), shown.end()), (std::vector<double>{0.01, -0.02, 0.03}));
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

/// Pictures of the samples that were drawn; 50 a second for 0.2 s, asked for between two instants.
std::map<std::uint64_t, std::uint64_t> asked_for(Duration from, Duration until) {
  CameraRig rig;
  Entity& box = rig.add_box("box");
  SensorSpec spec = camera({{"always_on", 0}, {"read_noise", 0.05}});
  spec.delay = 0.033;
  rig.attach_camera(box, spec);
  CameraFrame& frame = offer_frames(box, "eye");
  rig.begin();
  RangeRig::put(box, {0, 0, 1});
  std::map<std::uint64_t, std::uint64_t> pictures;
  for (Duration now{}; now < 200ms; now += 1ms) {
    frame.asked = now >= from && now < until;
    rig.simulation.run(1ms);
    if (frame.number > 0) pictures[frame.number] = hash_of(frame);
  }
  EXPECT_EQ(rig.painter.looks.size(), static_cast<std::size_t>((until - from) / 20ms));
  return pictures;
}

TEST(Camera, DrawsWhileItIsAskedTo) {
  const auto always = asked_for(0ms, 200ms), once = asked_for(60ms, 120ms), never = asked_for(0ms, 0ms);
  EXPECT_EQ(always.size(), 9u) << "the last one is on the way";
  EXPECT_TRUE(never.empty());
  ASSERT_EQ(once.size(), 3u);
  for (const std::uint64_t number : {4u, 5u, 6u}) EXPECT_EQ(once.at(number), always.at(number)) << number;
}

// Law: who asks while it runs gets the pictures of one that was asked for from the start, and after a reset all of them.
TEST(Camera, DrawsFromWhenItIsAskedForWhileItRuns) {
  const auto pictures_of = [](bool late, bool again) {
    CameraRig rig;
    Entity& box = rig.add_box("box");
    SensorSpec spec = camera({{"always_on", 0}, {"read_noise", 0.05}});
    spec.delay = 0.033;
    rig.attach_camera(box, spec);
    if (!late) (void)want_frames(box, "eye");
    rig.begin();
    RangeRig::put(box, {0, 0, 1});
    rig.simulation.run(50ms);
    const CameraFrame& frame = late ? want_frames(box, "eye") : *frames_of(box)[0];
    EXPECT_TRUE(frame.draws);
    if (again) {
      rig.simulation.run(70ms);
      rig.simulation.reset();
      RangeRig::put(box, {0, 0, 1});
    }
    std::map<std::uint64_t, std::uint64_t> pictures;
    for (int step = 0; step < 150; ++step) {
      rig.simulation.step();
      if (frame.number > 0) pictures[frame.number] = hash_of(frame);
    }
    return pictures;
  };
  const auto always = pictures_of(false, false), late = pictures_of(true, false);
  ASSERT_FALSE(late.empty());
  EXPECT_EQ(late.begin()->first, 4U) << "of 60 ms, the first sample since then";
  for (const auto& [number, hash] : late) EXPECT_EQ(always.at(number), hash) << number;
  EXPECT_EQ(pictures_of(true, true), pictures_of(false, true));
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

/// Its context is lost: it leaves everything as it was.
struct Blind final : ViewSource {
  void draw(const Perspective&, const Layers&, double, View&) noexcept override {}
};

// Rule: pictures have their size and only the layers that are wanted, also where the source could not draw: black then.
TEST(Camera, PicturesHaveTheirSizeThoughNothingWasDrawn) {
  for (const double exposure_time : {0.0, 0.01}) {
    for (const char* mosaic : {"", "rggb"}) {
      RangeRig rig;
      Blind blind;
      Entity& box = rig.add_box("box");
      SensorSpec spec = camera({{"depth", 1}, {"labels", 1}, {"exposure_time", exposure_time}, {"blur", 1}});
      if (*mosaic != '\0') spec.texts["mosaic"] = mosaic;
      component_files::attach_sensor(rig.simulation, box, spec, {1, rig.moving_entities, [&] { return &blind; }},
                                     rig.rate);
      const CameraFrame& frame = *frames_of(box).at(0);
      rig.begin();
      RangeRig::put(box, {0, 0, 1});
      rig.simulation.run(41ms);
      EXPECT_EQ(frame.number, 3U);
      const bool raw = *mosaic != '\0';
      EXPECT_EQ(frame.color.width(), raw ? 0 : 40);
      EXPECT_EQ(frame.mosaic.width(), raw ? 40 : 0);
      EXPECT_EQ(frame.depth.width(), 40);
      EXPECT_EQ(frame.depth.height(), 30);
      EXPECT_EQ(frame.labels.width(), 40);
      EXPECT_EQ(frame.labels.height(), 30);
      for (const imaging::Rgb& pixel : frame.color.pixels()) EXPECT_EQ(pixel.red + pixel.green + pixel.blue, 0);
      for (const std::uint8_t pixel : frame.mosaic.pixels()) EXPECT_EQ(pixel, 0);
    }
  }
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

// The optical axes of a frame are those of the link that carries the camera, which is not the base here.
TEST(Camera, SaysOnWhichLinkItIs) {
  CameraRig rig;
  Entity& robot = rig.add_moving_entity("robot", std::make_shared<const Model>(fixtures::two_legged()));
  SensorSpec spec = camera();
  spec.frame = "right_foot";
  spec.position = {0.03, 0, 0.01};
  const CameraFrame& frame = rig.attach_camera(robot, spec);
  EXPECT_EQ(frame.info->link, robot.model().object_index("right_ankle"));
  EXPECT_LT(norm(frame.info->position - Vec3d{0.05, 0, -0.02}), 1e-15);
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

}  // namespace
}  // namespace murosimf::sensors
