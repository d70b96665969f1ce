// Pictures of cameras for libraries: the bytes that the camera has, at its rate and delay.
#include <gtest/gtest.h>

#include <cstddef>

#include "murosimf/control_software/controller_task.h"
#include "murosimf/scene/scene.h"
#include "murosimf/sensors/camera_frame.h"
#include "murosimf/world/drawing.h"
#include "tests/fixtures.h"
#include "tests/written_scene.h"

namespace murosimf::control_software {
namespace {

using namespace std::chrono_literals;

// Libraries of version 2 know the robot up to here.
static_assert(offsetof(murosimf_robot, picture) == offsetof(murosimf_robot, receive) + sizeof(void*));
static_assert(offsetof(murosimf_robot, receive) == offsetof(murosimf_robot, say) + 3 * sizeof(void*));

std::string scene_with(const std::string& camera, const std::string& picture) {
  return "[ball]\nposition = [0.8, 0.0]\n[[robots]]\nname = 'one'\nmodel = 'kid21'\ncontroller = 'library'\nlibrary = "
         "'" +
         std::string(MUROSIMF_CONTROLLERS) + "/controller_pictures.so'\noptions = {picture = '" + picture +
         "'}\n[robots.sensors.camera]\nwidth = 40\nheight = 30\nrate = 10\n" + camera;
}

template <class Pixel>
std::uint64_t sum(const imaging::Image<Pixel>& image) {
  std::uint64_t all = 0;
  for (const std::byte byte : std::as_bytes(image.pixels())) all = 31 * all + std::to_integer<std::uint64_t>(byte);
  return all;
}

const SoftwareReport& software(const scene::Scene& scene) {
  return *software_report(scene.simulation().world().entity("one"));
}

TEST(LibraryPictures, AreThoseOfTheCamera) {
  scene::Scene scene(fixtures::write_scene(scene_with("delay = 0.03\ndepth = true\n", "camera.depth")),
                     {.libraries = true});
  scene.simulation().run(250ms);
  const auto& said = software(scene).said;
  ASSERT_EQ(said.size(), 3U);
  EXPECT_TRUE(fixtures::says(said[0].text, {"40 x 30 32FC1, 0.1 s, number 1 of 0 ms at 40 ms: "}));
  EXPECT_TRUE(fixtures::says(said[1].text, {"number 2 of 100 ms at 140 ms: "}));
  const sensors::CameraFrame& frame = *sensors::frames_of(scene.simulation().world().entity("one")).at(0);
  EXPECT_EQ(said[2].text, fmt::format("40 x 30 32FC1, 0.1 s, number 3 of 200 ms at 240 ms: {}", sum(frame.depth)));
}

TEST(LibraryDrawings, StandThereAsTheyWereDrawn) {
  scene::Scene scene(fixtures::write_scene(scene_with("", "camera.color")), {.libraries = true});
  scene.simulation().run(50ms);
  const Drawings& all = scene.simulation().world().entity("one").find(properties::drawings)->values[0];
  ASSERT_EQ(all.groups.size(), 1U);
  EXPECT_EQ(all.groups[0].name, "picture");
  EXPECT_TRUE(all.groups[0].of_robot);
  ASSERT_EQ(all.groups[0].shapes.size(), 2U);
  EXPECT_EQ(all.groups[0].shapes[0].kind, DrawnShape::polygon);
  EXPECT_EQ(all.groups[0].shapes[0].points.at(2).y, 2);
  EXPECT_EQ(all.groups[0].shapes[0].color, (Color{0, 1, 0.5}));
  EXPECT_EQ(all.groups[0].shapes[1].words, "seen");
}

TEST(LibraryPictures, AreAskedForByName) {
  const auto error = [](const std::string& picture) {
    return fixtures::error_of(
        [&] { scene::Scene(fixtures::write_scene(scene_with("", picture)), {.libraries = true, .cameras = false}); });
  };
  EXPECT_TRUE(fixtures::says(error("camera.colour"), {"unknown picture 'camera.colour'; did you mean 'camera.color'"}));
  EXPECT_TRUE(fixtures::says(error("camera.depth"), {"unknown picture 'camera.depth'"}));
  const std::string none = fixtures::error_of([&] {
    scene::Scene("walk", {.overrides = {"walker.controller=library", "walker.sensors.camera=false",
                                        "walker.library=" MUROSIMF_CONTROLLERS "/controller_pictures.so"},
                          .cameras = false});
  });
  EXPECT_TRUE(fixtures::says(none, {"there is no picture 'camera.color': walker has no camera"}));
}

}  // namespace
}  // namespace murosimf::control_software
