// A page can show any camera's picture: the one that the camera itself would take there, without any change to the run.
#include "murosimf/web/camera_subscriptions.h"

#include <chrono>
#include <functional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"

namespace murosimf::web {
namespace {

using namespace std::chrono_literals;

constexpr const char* camera = "blue1.camera";
constexpr Duration instant = 100ms;  // when the camera, at 20 Hz, takes its third picture

/// A lens that bends, and all that becomes of light but what takes time.
const std::vector<std::string> eye{"blue1.sensors.camera.k1=-0.2", "blue1.sensors.camera.width=160",
                                   "blue1.sensors.camera.height=120", "blue1.sensors.camera.blur=0.7",
                                   "blue1.sensors.camera.exposure=0.9"};

std::vector<std::string> eye_and(const std::string& more) {
  std::vector<std::string> all = eye;
  all.push_back(more);
  return all;
}

bool wait_until(const std::function<bool()>& good) {
  for (int i = 0; i < 3000 && !good(); ++i) std::this_thread::sleep_for(10ms);
  return good();
}

/// A run that comes to `instant` and stays there.
struct Running {
  explicit Running(const std::vector<std::string>& overrides = eye)
      : scene("three_on_three", {.overrides = overrides}), session(scene), thread([this] { session.run(instant); }) {}
  ~Running() { finish(); }
  void finish() {
    session.finish();
    if (thread.joinable()) thread.join();
  }
  bool comes_to_its_end() {
    return wait_until([&] { return session.status().paused && session.status().time == instant; });
  }

  scene::Scene scene;
  session::Session session;
  std::thread thread;
};

/// The camera's own picture of that instant.
sensors::CameraFrame own_picture(const std::vector<std::string>& overrides) {
  scene::Scene scene("three_on_three", {.overrides = overrides});
  const sensors::CameraFrame& frame =
      sensors::want_frames(scene.simulation().world().entity("blue1"), std::string(camera).substr(6));
  scene.simulation().run(instant + 1ms);
  EXPECT_EQ(frame.time, instant);
  return frame;
}

TEST(CameraSubscriptions, SeeWhatTheCameraWouldSeeAndChangeNothing) {
  const sensors::CameraFrame own = own_picture(eye);
  std::uint64_t alone = 0;
  {
    scene::Scene scene("three_on_three", {.overrides = eye});
    scene.simulation().run(instant);
    alone = scene.simulation().state_hash();
  }
  Running run;
  CameraSubscriptions cameras(run.session);
  cameras.want({camera});
  ASSERT_TRUE(run.comes_to_its_end());
  ASSERT_TRUE(wait_until([&] {
    const auto seen = cameras.seen(camera);
    return seen && seen->frame && seen->frame->time == instant;
  }));
  const SeenPicture seen = *cameras.seen(camera);
  EXPECT_FALSE(seen.own);
  EXPECT_EQ(seen.trouble, "");
  ASSERT_EQ(seen.frame->color.width(), 160);
  int different = 0;
  for (int v = 0; v < 120; ++v) {
    for (int u = 0; u < 160; ++u) {
      const imaging::Rgb &a = own.color(u, v), &b = seen.frame->color(u, v);
      different += a.red != b.red || a.green != b.green || a.blue != b.blue ? 1 : 0;
    }
  }
  EXPECT_EQ(different, 0) << "of 19,200 pixels";
  std::set<int> greens;
  for (const imaging::Rgb& pixel : own.color.pixels()) greens.insert(pixel.green);
  EXPECT_GT(greens.size(), 30U) << "there is something to be seen";
  run.finish();
  EXPECT_EQ(run.scene.simulation().state_hash(), alone);
  EXPECT_EQ(sensors::frames_of(run.scene.simulation().world().entity("blue1")).at(0)->number, 0U);
}

TEST(CameraSubscriptions, DrawOnlyWhatSomebodyWants) {
  Running run;
  CameraSubscriptions cameras(run.session);
  ASSERT_TRUE(run.comes_to_its_end());
  EXPECT_EQ(cameras.drawn(), 0U);
  cameras.want({camera});
  ASSERT_TRUE(wait_until([&] { return cameras.drawn() == 1; }));
  std::this_thread::sleep_for(300ms);
  EXPECT_EQ(cameras.drawn(), 1U) << "nothing moves";
  run.session.step(1);
  ASSERT_TRUE(wait_until([&] { return cameras.drawn() == 2; }));
  cameras.want({});
  EXPECT_FALSE(cameras.seen(camera));
  run.session.step(50);
  std::this_thread::sleep_for(500ms);
  EXPECT_EQ(cameras.drawn(), 2U);
  cameras.want({camera, "red1.camera"});
  ASSERT_TRUE(wait_until([&] { return cameras.drawn() == 4; }));
  for (int i = 0; i < 20; ++i) {  // a page that looks away and again sees it again, though nothing has moved
    cameras.want({});
    cameras.want({camera});
    ASSERT_TRUE(wait_until([&] { return cameras.seen(camera) && cameras.seen(camera)->frame; })) << i;
  }
}

TEST(CameraSubscriptions, ACameraThatDrawsShowsItsOwnPictures) {
  Running run(eye_and("blue1.sensors.camera.always_on=true"));
  CameraSubscriptions cameras(run.session);
  cameras.want({camera});
  ASSERT_TRUE(run.comes_to_its_end());
  ASSERT_TRUE(wait_until([&] {
    const auto seen = cameras.seen(camera);
    return seen && seen->frame && seen->frame->number == 2;
  })) << "those of 0 and 0.05 s";
  EXPECT_TRUE(cameras.seen(camera)->own);
  cameras.want({});
  cameras.want({camera});
  ASSERT_TRUE(wait_until([&] { return cameras.seen(camera) && cameras.seen(camera)->frame; }));
  EXPECT_EQ(cameras.drawn(), 0U);
}

TEST(CameraSubscriptions, AMosaicIsOne) {
  Running run(eye_and("blue1.sensors.camera.mosaic='rggb'"));
  CameraSubscriptions cameras(run.session);
  cameras.want({camera});
  ASSERT_TRUE(wait_until([&] { return cameras.seen(camera) && cameras.seen(camera)->frame; }));
  EXPECT_EQ(cameras.seen(camera)->frame->mosaic.width(), 160);
  EXPECT_TRUE(cameras.seen(camera)->frame->color.empty());
}

TEST(CameraSubscriptions, WhatIsNoCameraIsSaid) {
  Running run;
  CameraSubscriptions cameras(run.session);
  cameras.want({"blue1.eye", "ball", ""});
  ASSERT_TRUE(wait_until([&] { return cameras.seen("").has_value(); }));
  EXPECT_EQ(cameras.seen("blue1.eye")->trouble, "there is no camera 'blue1.eye'");
  EXPECT_EQ(cameras.seen("ball")->trouble, "there is no camera 'ball'");
  run.session
      .visit([](scene::Scene& scene) {
        EXPECT_NO_THROW(check_camera(scene, camera));
        EXPECT_THROW(check_camera(scene, "blue1.camra"), SetupError);
        EXPECT_THROW(check_camera(scene, "blue1"), SetupError);
      })
      .get();
}

TEST(CameraSubscriptions, EndWithTheRunOrBeforeItBegan) {
  {
    scene::Scene scene("three_on_three");
    session::Session session(scene);
    CameraSubscriptions cameras(session);
    cameras.want({camera});  // the scene is not stepped
    std::this_thread::sleep_for(50ms);
  }
  Running run;
  CameraSubscriptions cameras(run.session);
  cameras.want({camera});
  run.finish();
  std::this_thread::sleep_for(100ms);
}

}  // namespace
}  // namespace murosimf::web
