// Robots and bodies that come into a scene that runs.
#include "murosimf/scene/scene_addition.h"

#include <gtest/gtest.h>

#include "murosimf/collision/queries.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "murosimf/sensors/camera_frame.h"
#include "tests/fixtures.h"
#include "tests/scene/scene_hashes.h"
#include "tests/written_scene.h"

namespace murosimf::scene {
namespace {

using namespace std::chrono_literals;
using fixtures::error_of;
using fixtures::says;

std::string scene_with(const std::string& more) {
  return fixtures::write_scene(R"(
seed = 11
[start]
jitter_position = 0.01
jitter_heading_deg = 3
jitter_posture_deg = 1
[ball]
position = [0.25, 0.02]
[[teams]]
name = "blue"
[[teams]]
name = "red"
[[robots]]
name = "blue1"
team = "blue"
model = "kid21"
level = "full_dynamics"
controller = "walk"
command = [0.25, 0, 0]
position = [-0.1, 0]
[robots.sensors.around]
type = "laser"
position = [0.08, 0, -0.1]
rays = 31
)" + more);
}

std::string red1(const std::string& level) {
  return R"(
[[robots]]
name = "red1"
team = "red"
model = "kid21"
level = ")" +
         level + R"("
controller = "ball_chaser"
position = [0.6, 0.05]
heading_deg = 180
[robots.sensors.detect]
type = "detector"
[robots.sensors.around]
type = "sonar"
position = [0, 0, 0.1]
)";
}

const std::string crate = R"(
[[bodies]]
name = "crate"
shape = "box"
size = [0.2, 0.2, 0.2]
mass = 2
position = [0.9, 0.3, 0.1]
heading_deg = 20
velocity = [-1, 0, 0.5]
angular_velocity = [0, 1, 2]
)";

/// A robot or body as a file would have it.
scene_file::SceneSpec spec_of(const std::string& more) { return scene_file::read_scene(scene_with(more)); }

class AdditionAtLevel : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Levels, AdditionAtLevel,
                         testing::Values("kinematic_walking", "simplified_dynamics", "full_dynamics",
                                         "articulated_dynamics"),
                         [](const auto& test) { return test.param; });

// Law: what is added before the first step is as if the file had had it, bit for bit, readings included.
TEST_P(AdditionAtLevel, AtTheStartIsAsInTheFile) {
  for (const int threads : {1, 3}) {
    const auto robot = spec_of(red1(GetParam())).robots[1];
    Scene scene(scene_with(""), {.threads = threads});
    Entity& red = scene.add(robot);
    EXPECT_EQ(red.level, GetParam());
    Scene fresh(scene_with(red1(GetParam())), {.threads = threads});
    fresh.simulation().initialize();
    EXPECT_EQ(difference(go_on(scene, 2s), go_on(fresh, 2s)), "") << threads;
  }
}

TEST_P(AdditionAtLevel, InARunningSceneIsPartOfItFromThenOn) {
  const auto robot = spec_of(red1(GetParam())).robots[1];
  Scene scene(scene_with(""));
  scene.simulation().run(500ms);
  const auto before = scene.save();
  const auto warnings = scene.parts().diagnostics.warnings();
  Entity& red = scene.add(robot);
  Scene twin(scene_with(""), {.threads = 2});
  twin.simulation().run(500ms);
  (void)twin.add(robot);
  EXPECT_EQ(difference(go_on(scene, 2s), go_on(twin, 2s)), "") << "the same whenever it is done";
  EXPECT_GT(norm(red.base().get(properties::position) - robot.position), 0.05) << "it walks";
  EXPECT_EQ(scene.parts().diagnostics.warnings(), warnings);
  // states are of the scene as it is
  const auto bytes = scene.save();
  const auto expected = go_on(scene, 300ms);
  twin.load(bytes);
  EXPECT_EQ(difference(go_on(twin, 300ms), expected), "");
  EXPECT_NE(error_of([&] { scene.load(before); }), "") << "those of before fit no longer";
  Scene another(scene_with(""));
  EXPECT_NE(error_of([&] { another.load(bytes); }), "");
}

TEST_P(AdditionAtLevel, AResetBeginsWithIt) {
  Scene scene(scene_with(""));
  scene.simulation().run(300ms);
  (void)scene.add(spec_of(red1(GetParam())).robots[1]);
  scene.simulation().run(300ms);
  scene.reset(5);
  Scene fresh(scene.spec());
  fresh.simulation().initialize();
  EXPECT_EQ(fresh.spec().robots.size(), 2u);
  EXPECT_EQ(difference(go_on(scene, 1s), go_on(fresh, 1s)), "");
  scene.leave("red1");
  scene.simulation().run(100ms);
  scene.enter("red1");
  EXPECT_NO_THROW(scene.exchange_level("red1", "simplified_dynamics"));
}

TEST(SceneAddition, OfABody) {
  Scene scene(scene_with(""));
  const auto body = spec_of(crate).bodies[0];
  Entity& added = scene.add(body);
  Scene fresh(scene_with(crate));
  fresh.simulation().initialize();
  EXPECT_EQ(difference(go_on(scene, 1s), go_on(fresh, 1s)), "");
  EXPECT_LT(added.base().get(properties::position).x, 0.85);
  EXPECT_NO_THROW(scene.exchange_contact("crate", "kelvin_voigt"));
  auto still = body;
  still.name = "wall";
  still.is_static = true;
  EXPECT_TRUE(says(error_of([&] { (void)scene.add(still); }), {"wall", "static"}));
}

// Another body may have surfaces that were not there: contacts that last have the constants of before.
TEST(SceneAddition, OfOtherMaterialsKeepsContacts) {
  const std::string stack = R"(
[[bodies]]
name = "lower"
shape = "box"
size = [0.2, 0.2, 0.2]
mass = 2
position = [1, 1]
[[bodies]]
name = "upper"
shape = "box"
size = [0.2, 0.2, 0.2]
mass = 1
position = [1, 1, 0.2]
)";
  Scene scene(scene_with(stack)), twin(scene_with(stack));
  for (Scene* one : {&scene, &twin}) one->simulation().run(1s);
  auto far = spec_of(crate).bodies[0];
  far.material = "rubber";
  far.position = {-1.5, 1.5, 0};
  far.velocity = far.angular_velocity = {};
  (void)scene.add(far);
  for (Scene* one : {&scene, &twin}) one->simulation().run(1s);
  for (const char* name : {"lower", "upper", "blue1", "ball"}) {
    const auto place = [&](Scene& one) {
      return one.simulation().world().entity(name).base().get(properties::position);
    };
    EXPECT_EQ(norm(place(scene) - place(twin)), 0) << name;
  }
}

TEST(SceneAddition, IsSeenByThoseWhoWereThere) {
  Scene scene(scene_with(""));
  scene.simulation().run(100ms);
  auto wall = spec_of(crate).bodies[0];
  wall.position = scene.simulation().world().entity("blue1").base().get(properties::position) + Vec3d{0.5, 0, 0};
  wall.position.z = 0;
  wall.velocity = wall.angular_velocity = {};
  wall.heading = 0;
  const auto ahead = [&] {
    scene.simulation().step();
    const auto& values = sensors::find_reading(scene.simulation().world().entity("blue1"), "around")->values;
    return *std::ranges::min_element(values);
  };
  const double before = ahead();
  (void)scene.add(wall);
  EXPECT_LT(ahead(), std::min(before, 0.45));
  scene.leave("crate");
  EXPECT_EQ(ahead() < 0.45, before < 0.45);
}

TEST(SceneAddition, IsSeenByCameras) {
  Scene scene(scene_with(R"(
[robots.sensors.camera]
type = "camera"
width = 64
height = 48
always_on = true
labels = true
)"));
  Entity& blue = scene.simulation().world().entity("blue1");
  const auto* frame = sensors::frames_of(blue)[0];
  while (frame->number < 2) scene.simulation().step();
  auto wall = spec_of(crate).bodies[0];
  wall.position = blue.base().get(properties::position) + Vec3d{0.6, 0, 0};
  wall.position.z = 0.2;
  wall.velocity = wall.angular_velocity = {};
  (void)scene.add(wall);
  EXPECT_EQ(frame->info->labels.back(), "crate");
  const auto label = static_cast<std::uint16_t>(frame->info->labels.size() - 1);
  const auto number = frame->number;
  while (frame->number < number + 2) scene.simulation().step();
  EXPECT_GT(std::ranges::count(frame->labels.pixels(), label), 50);
}

// Its own camera draws for who asks when it is there, as that of a robot of the file.
TEST(SceneAddition, HasCamerasThatDrawWhenTheyAreAskedFor) {
  const std::string camera = R"(
[robots.sensors.camera]
type = "camera"
width = 64
height = 48
)";
  const Scene file(scene_with(camera));
  scene_file::RobotSpec robot = file.spec().robots[0];
  robot.name = "guest";
  robot.position.y = 1;
  Scene scene(scene_with(""));
  scene.simulation().run(100ms);
  Entity& guest = scene.add(robot);
  for (const bool wanted : {false, true}) {
    if (wanted) (void)sensors::want_frames(guest, "camera");
    scene.simulation().run(200ms);
    const auto* frame = sensors::frames_of(guest)[0];
    EXPECT_EQ(frame->number > 0, wanted);
    EXPECT_EQ(frame->color.empty(), !wanted);
  }
}

// Law: an addition that is refused leaves no trace.
TEST(SceneAddition, OfSomebodyRefusedLeavesNoTrace) {
  Scene scene(scene_with("")), twin(scene_with(""));
  for (Scene* one : {&scene, &twin}) one->simulation().run(200ms);
  const auto good = spec_of(red1("full_dynamics")).robots[1];
  const auto refused = [&](const auto& change) {
    scene_file::RobotSpec robot = good;
    change(robot);
    return error_of([&] { (void)scene.add(robot); });
  };
  EXPECT_TRUE(says(refused([](auto& r) { r.name = "blue1"; }), {"two entities", "blue1"}));
  EXPECT_TRUE(says(refused([](auto& r) { r.model = "no_such_robot"; }), {"no_such_robot"}));
  EXPECT_TRUE(says(refused([](auto& r) { r.team = "green"; }), {"green", "blue"}));
  EXPECT_TRUE(says(refused([](auto& r) { r.level = "full"; }), {"full", "full_dynamics"}));
  EXPECT_TRUE(says(refused([](auto& r) { r.contact = "sticky"; }), {"sticky"}));
  EXPECT_TRUE(says(refused([](auto& r) { r.controller = "keyframes"; }), {"keyframes"}));
  EXPECT_TRUE(says(refused([](auto& r) { r.collision.volume = "cube"; }), {"cube"}));
  EXPECT_TRUE(says(refused([](auto& r) { r.position.x = std::nan(""); }), {"red1", "finite"}));
  EXPECT_TRUE(says(error_of([&] { (void)scene.add(scene.spec().robots[0]); }), {"two entities", "blue1"}));
  EXPECT_EQ(scene.spec().robots.size(), 1u);
  EXPECT_EQ(scene.moving_entities().size(), 2u);
  EXPECT_EQ(scene.save(), twin.save());
  EXPECT_EQ(difference(go_on(scene, 500ms), go_on(twin, 500ms)), "");
  for (Scene* one : {&scene, &twin}) (void)one->add(good);
  EXPECT_EQ(difference(go_on(scene, 500ms), go_on(twin, 500ms)), "");
}

}  // namespace
}  // namespace murosimf::scene
