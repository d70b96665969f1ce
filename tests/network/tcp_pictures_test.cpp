// Pictures of cameras over TCP: the bytes of the camera, at its rate and delay; a missing signal is reported by name.
#include <gtest/gtest.h>

#include "murosimf/sensors/camera_frame.h"
#include "tests/network/tcp_fixture.h"
#include "tests/written_scene.h"

namespace murosimf::control_software {
namespace {

using namespace fixtures;

std::string seeing_robot(const std::string& camera) {
  return "[ball]\nposition = [0.8, 0.0]\n[[robots]]\nname = 'one'\nmodel = 'kid21'\ncontroller = 'tcp'\n"
         "control_rate = 50\n[robots.sensors.camera]\nwidth = 80\nheight = 60\nrate = 10\n" +
         camera;
}

template <class Pixel>
std::string bytes_of(const imaging::Image<Pixel>& image) {
  return {reinterpret_cast<const char*>(image.pixels().data()), image.pixels().size_bytes()};
}

/// Has the client receive all of `names` in each cycle for 0.5 s; `look` in the loop, with the frame of the camera.
template <class Look>
void see(const std::string& camera, const std::vector<std::string>& names, const Look& look) {
  const Listener listener;
  scene::Scene* there = nullptr;
  Software software_of_one([&] {
    client::RobotClient robot({.robot = "one", .port = listener.port()});
    std::vector<const client::Picture*> pictures;
    for (const std::string& name : names) pictures.push_back(&robot.picture(name));
    // the simulation waits for the answer: its frames remain
    while (robot.next()) {
      if (!robot.starts()) look(robot, pictures, *sensors::frames_of(there->simulation().world().entity("one")).at(0));
    }
  });
  {
    scene::Scene scene(::murosimf::fixtures::write_scene(seeing_robot(camera)), {.software = listener.server});
    there = &scene;
    scene.simulation().run(500ms);
  }
  EXPECT_EQ(software_of_one.error(), "");
}

TEST(TcpPictures, AreThoseOfTheCamera) {
  int cycles = 0;
  see("depth = true\nlabels = true\n", {"camera.color", "camera.depth", "camera.labels"},
      [&](const client::RobotClient&, const auto& pictures, const sensors::CameraFrame& frame) {
        ++cycles;
        EXPECT_EQ(pictures[0]->format, "rgb8");
        EXPECT_EQ(pictures[1]->format, "32FC1");
        EXPECT_EQ(pictures[2]->format, "16UC1");
        for (const client::Picture* picture : pictures) {
          EXPECT_EQ(picture->width, 80);
          EXPECT_EQ(picture->height, 60);
          EXPECT_EQ(picture->period, 0.1);
          EXPECT_EQ(picture->time, frame.time.count());
          EXPECT_EQ(picture->number, frame.number);
        }
        EXPECT_EQ(pictures[0]->bytes, bytes_of(frame.color));
        EXPECT_EQ(pictures[0]->bytes.size(), 80U * 60 * 3);
        EXPECT_EQ(pictures[1]->bytes, bytes_of(frame.depth));
        EXPECT_EQ(pictures[2]->bytes, bytes_of(frame.labels));
      });
  EXPECT_EQ(cycles, 25);
}

TEST(TcpPictures, OfAMosaicHaveItsPattern) {
  see("mosaic = 'grbg'\n", {"camera.color"},
      [&](const client::RobotClient&, const auto& pictures, const sensors::CameraFrame& frame) {
        EXPECT_EQ(pictures[0]->format, "bayer_grbg8");
        EXPECT_EQ(pictures[0]->bytes, bytes_of(frame.mosaic));
        EXPECT_EQ(pictures[0]->bytes.size(), 80U * 60);
      });
}

// Taken at 0, 100, ... ms, available 55 ms later: in the cycles of 60, 160, ... ms.
TEST(TcpPictures, ComeWithTheDelayOfTheCamera) {
  std::vector<std::pair<long long, long long>> come;  // [ms] now, time
  std::uint64_t last = 0;
  see("delay = 0.055\n", {"camera.color"},
      [&](const client::RobotClient& robot, const auto& pictures, const sensors::CameraFrame&) {
        if (pictures[0]->number == last) return;
        last = pictures[0]->number;
        come.emplace_back(robot.now() / 1'000'000, pictures[0]->time / 1'000'000);
      });
  EXPECT_EQ(come,
            (std::vector<std::pair<long long, long long>>{{60, 0}, {160, 100}, {260, 200}, {360, 300}, {460, 400}}));
}

TEST(TcpPictures, ThatAreNotThereAreToldByName) {
  const Listener listener;
  Software software_of_one([&] {
    client::RobotClient robot({.robot = "one", .port = listener.port()});
    const auto refused = [&](const std::string& name) { return error_text([&] { (void)robot.picture(name); }); };
    EXPECT_TRUE(says(refused("camera.colour"), {"unknown picture 'camera.colour'; did you mean 'camera.color'"}));
    EXPECT_TRUE(says(refused("camera.depth"), {"unknown picture 'camera.depth'"}));
    EXPECT_TRUE(says(refused("camera"), {"unknown picture 'camera'"}));
    EXPECT_TRUE(says(refused("camera.color"), {"the picture 'camera.color' is too large: pictures of one cycle"}));
    while (robot.next()) {
    }
  });
  {
    scene::Scene scene(::murosimf::fixtures::write_scene(seeing_robot("")),
                       {.overrides = {"one.sensors.camera.width=4000", "one.sensors.camera.height=3000"},
                        .cameras = false,
                        .software = listener.server});
    scene.simulation().run(100ms);
  }
  EXPECT_EQ(software_of_one.error(), "");
}

}  // namespace
}  // namespace murosimf::control_software
