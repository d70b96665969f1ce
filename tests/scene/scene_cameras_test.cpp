/// scene_cameras_test - cameras in scenes: what they show, and that they change nothing for the rest of the scene.
#include <cmath>

#include <gtest/gtest.h>

#include "murosimf/component_files/camera_info.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"
#include "murosimf/scene/scene_viewpoints.h"
#include "murosimf/sensors/camera_frame.h"
#include "murosimf/sensors/reading.h"
#include "tests/fixtures.h"
#include "tests/law.h"
#include "tests/written_scene.h"

namespace murosimf::scene {
namespace {

using namespace std::chrono_literals;
using fixtures::error_of;
using fixtures::says;
using sensors::CameraFrame;
using sensors::frames_of;

/// Two robots that walk, with small cameras that draw all layers.
std::string game(const std::string& camera = "") {
  return "[ball]\nposition = [0.8, 0.0]\n[defaults]\nmodel = 'kid21'\ncontroller = 'walk'\ncommand = [0.1, 0, 0]\n"
         "[defaults.sensors.camera]\nwidth = 80\nheight = 60\nrate = 20\ndepth = true\nlabels = true\nalways_on = "
         "true\n" +
         camera +
         "[[robots]]\nname = 'one'\n[[robots]]\nname = 'two'\nposition = [0.6, 0.5]\nlevel = "
         "'simplified_dynamics'\n";
}

const CameraFrame& frame(Scene& scene, const std::string& name) {
  return *sensors::frames_of(scene.simulation().world().entity(name)).at(0);
}

TEST(SceneCameras, AScenesRobotsSee) {
  Scene scene(fixtures::write_scene(game()));
  scene.simulation().run(201ms);
  const CameraFrame& seen = frame(scene, "one");
  EXPECT_EQ(seen.number, 5u);
  EXPECT_EQ(seen.time, 200ms);
  ASSERT_EQ(seen.info->labels.size(), 7u);
  EXPECT_EQ(seen.info->labels[4], "ball");
  EXPECT_EQ(seen.info->labels[6], "two");
  std::map<int, int> count;
  for (const std::uint16_t label : seen.labels.pixels()) ++count[label];
  EXPECT_GT(count[4], 5) << "the ball in front of it";
  EXPECT_GT(count[6], 20) << "the other robot";
  EXPECT_GT(count[1], 500) << "ground";
}

TEST(SceneCameras, FramesAndStatesDoNotDependOnThreads) {
  std::vector<std::uint64_t> frames, states;
  for (const int threads : {1, 2, 3}) {
    Scene scene(fixtures::write_scene(game("k1 = -0.2\nshot_noise = 0.02\nblur = 0.7\nreadout_time = 0.02\n")),
                {.threads = threads});
    scene.simulation().run(300ms);
    std::uint64_t hash = 0;
    for (const char* name : {"one", "two"}) hash = 31 * hash + sensors::hash_of(frame(scene, name));
    frames.push_back(hash);
    states.push_back(scene.simulation().state_hash());
  }
  for (const SceneOptions& options :
       {SceneOptions{.cameras = false}, SceneOptions{.overrides = {"one.sensors.camera=false"}}}) {
    Scene scene(fixtures::write_scene(game()), options);
    scene.simulation().run(300ms);
    states.push_back(scene.simulation().state_hash());
  }
  EXPECT_EQ(frames, std::vector(3, frames[0]));
  EXPECT_EQ(states, std::vector(5, states[0])) << "looking changes nothing";
}

TEST(SceneCameras, NobodyLooksNothingIsDrawn) {
  Scene quiet(fixtures::write_scene(game("always_on = false\n").replace(game().find("always_on = true\n"), 17, "")));
  quiet.simulation().run(100ms);
  EXPECT_EQ(frame(quiet, "one").number, 0u);
  Scene off(fixtures::write_scene(game()), {.cameras = false});
  off.simulation().run(100ms);
  EXPECT_EQ(frame(off, "one").number, 0u);
  for (const std::string& note : make_report(off).notes) EXPECT_FALSE(says(note, {"drawn by"}));
}

/// Where the halfway line is in a picture, column by column, against where the lens projects it.
TEST(SceneCameras, AStraightLineBendsAsTheLensSays) {
  struct Case {
    const char *name, *keys;
  };
  for (const Case& lens : {Case{"plumb_bob", "k1 = -0.3\nk2 = 0.08\np1 = 0.002\n"}, Case{"equidistant", "k1 = 0.05\n"},
                           Case{"ray_polynomial", "a1 = 1.0\na2 = 0.02\na3 = -0.15\n"}}) {
    Scene scene(fixtures::write_scene(
        std::string(
            "[[robots]]\nname = 'one'\nmodel = 'kid21'\ncontroller = 'none'\nposition = [-1.2, 0.4]\n"
            "[robots.sensors.camera]\nalways_on = true\nlabels = true\nposition = [0.1, 0, 0.4]\nrpy_deg = [4, 20, 3]\n"
            "fx = 320.0\nlens = '") +
        lens.name + "'\n" + lens.keys));
    scene.simulation().run(2ms);
    const CameraFrame& seen = frame(scene, "one");
    const auto& robot = scene.simulation().world().entity("one");
    const auto link = static_cast<std::size_t>(seen.info->link);
    const Mat3d R = robot.find(properties::orientation)->values[link];
    const Vec3d eye = robot.find(properties::position)->values[link] + R * seen.info->position;
    law::Worst worst;
    double bend_low = 1e9, bend_high = -1e9;
    for (double y = -0.6; y <= 1.3; y += 0.02) {
      const auto place = [&](double x) {
        return seen.info->lens.project(transposed_times(R * seen.info->orientation, Vec3d{x, y, 0} - eye));
      };
      const auto near = place(-0.025), far = place(0.025);
      if (!near || !far || near->u < 2 || near->u > 637) continue;
      // along the column of the line's middle: from its far edge to its near one
      const int u = static_cast<int>(std::lround(0.5 * (near->u + far->u)));
      int first = -1, last = -1;
      for (int v = static_cast<int>(far->v) - 6; v < static_cast<int>(near->v) + 6; ++v) {
        if (v < 0 || v >= 480 || seen.labels(u, v) != sensors::label_line) continue;
        if (first < 0) first = v;
        last = v;
      }
      // the center circle touches the line at two places, the mark lies on it
      if (first < 0 || std::abs(std::abs(y) - 0.6) < 0.1 || std::abs(y) < 0.15) continue;
      const double expected = 0.5 * (near->v + far->v);
      worst.see(std::abs(0.5 * (first + last) - expected), lens.name, y);
      bend_low = std::min(bend_low, expected);
      bend_high = std::max(bend_high, expected);
    }
    law::expect_below({"a straight field line through a lens: where it is in the picture", lens.name,
                       "projection of its points"},
                      worst, 1.0, "px");
    EXPECT_GT(bend_high - bend_low, 5) << "it is not level";
  }
}

TEST(SceneCameras, WhatIsWrongIsNamedWithItsPlace) {
  const auto error = [](const std::string& camera) {
    return error_of([&] { const Scene scene(fixtures::write_scene(game(camera))); });
  };
  EXPECT_TRUE(says(error("colour = true\n"), {".toml:14:", "colour", "color"}));
  EXPECT_TRUE(says(error("color = 1\n"), {".toml:14:", "color", "true or false"}));
  EXPECT_TRUE(says(error("mosaic = 'rgbg'\n"), {"mosaic", "rgbg"}));
  EXPECT_TRUE(says(error("lens = 'plumbob'\n"), {"plumbob", "plumb_bob"}));
  EXPECT_TRUE(says(error("calibration = 'nobody'\n"), {".toml:14:", "nobody"}));
  EXPECT_TRUE(says(error("mounting_error_deg = 3\n"), {".toml:14:", "mounting_error_deg"}));
  EXPECT_TRUE(says(error_of([] { const Scene s(fixtures::write_scene("[light]\nname = 'moon'\n" + game())); }),
                   {".toml:2:", "moon"}));
  EXPECT_TRUE(says(error_of([] { const Scene s(fixtures::write_scene("[light]\ntoward = [0, 0, -1]\n" + game())); }),
                   {"toward"}));
  EXPECT_TRUE(says(error_of([] { const Scene s(fixtures::write_scene("[views.a]\nlook_at = [0, 0, 0]\n" + game())); }),
                   {"eye"}));
  EXPECT_TRUE(
      says(error_of([] { const Scene s(fixtures::write_scene("views.a = 3\n" + game())); }), {".toml:1:", "a"}));
}

TEST(SceneCameras, ACalibrationFileIsTheLensAndKeysBesideItWin) {
  Scene scene(fixtures::write_scene(game("calibration = 'nubots_frankie'\n")), {.cameras = false});
  const imaging::LensSpec& lens = frame(scene, "one").info->lens.spec();
  EXPECT_EQ(lens.model, "equidistant");
  EXPECT_EQ(lens.width, 80) << "a key";
  const imaging::LensSpec file =
      component_files::read_camera_info(component_files::find_lens_file("nubots_frankie")).lens;
  EXPECT_EQ(lens.coefficients.at(0), file.coefficients.at(0));
  const double scale = 80.0 / file.width;
  EXPECT_NEAR(lens.fx, scale * file.fx, 1e-9) << "a smaller picture of the same view";
  const auto ray = imaging::Lens(lens).ray({10, 29.5}),
             same = imaging::Lens(file).ray({10.5 / scale - 0.5, 30.0 * file.height / 60 - 0.5});
  ASSERT_TRUE(ray && same);
  EXPECT_LT(norm(*ray - *same), 1e-9);
}

TEST(SceneViewpoints, SeeTheWholeFieldAndKnowTheirNames) {
  Scene scene(fixtures::write_scene("[views.corner]\neye = [3, 2, 1]\nlook_at = [0, 0, 0]\n" + game()));
  scene.simulation().initialize();
  for (const char* name : {"overview", "top", "side", "left", "right"}) {
    const sensors::Perspective view = viewpoint_perspective(scene, name, 640, 360);
    for (const Vec3d& corner : {Vec3d{3, 2, 0}, {-3, 2, 0}, {3, -2, 0}, {-3, -2, 0}}) {
      const Vec3d seen = transposed_times(view.axes, corner - view.eye);
      EXPECT_GT(seen.z, 0) << name;
      EXPECT_LT(std::abs(seen.x / seen.z), view.right) << name;
      EXPECT_LT(std::abs(seen.y / seen.z), view.bottom) << name;
    }
    EXPECT_LT(view.axes.y.z, 1e-12) << name << ": down is down";
  }
  EXPECT_EQ(viewpoint_perspective(scene, "corner", 64, 64).eye.x, 3);
  const sensors::Perspective robot = viewpoint_perspective(scene, "two", 64, 64);
  EXPECT_LT(norm(robot.eye - Vec3d{0.6, 0.5, 0.3}), 1.5);
  EXPECT_TRUE(
      says(error_of([&] { (void)viewpoint_perspective(scene, "corna", 64, 64); }), {"view", "corna", "corner"}));
}

TEST(SceneViewpoints, ByParallelRaysIsWhatViewSays) {
  Scene whole(fixtures::write_scene(game()));
  const render::ParallelView all = parallel_view(whole, 640, 360);
  for (const Vec3d& corner : {Vec3d{3, 2, 0}, {-3, 2, 0}, {3, -2, 0}, {-3, -2, 0}}) {
    const Vec3d seen = transposed_times(all.axes, corner - all.center);
    EXPECT_LT(std::abs(seen.x), 320 * all.pixel);
    EXPECT_LT(std::abs(seen.y), 180 * all.pixel);
  }
  EXPECT_NEAR(-all.axes.z.z, std::sin(whole.spec().view.elevation), 1e-12);
  EXPECT_LT(all.axes.y.z, 0) << "down is down";
  Scene part(fixtures::write_scene("[view]\ncenter = [1, 0.5, 0.2]\nwidth = 3.2\nazimuth_deg = 0\nelevation_deg = 0\n" +
                                   game()));
  const render::ParallelView near = parallel_view(part, 640, 360);
  EXPECT_NEAR(near.pixel, 0.005, 1e-12);
  EXPECT_EQ(near.center.y, 0.5);
  EXPECT_LT(norm(near.axes.x - Vec3d{0, 1, 0}), 1e-12) << "from the front";
}

}  // namespace
}  // namespace murosimf::scene
