// A scene that is reset is as a new one: the same bits in all columns, readings and pictures, the same events and diagnostics.
#include "murosimf/scene/scene_start.h"

#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "tests/fixtures.h"
#include "tests/scene/scene_hashes.h"
#include "tests/written_scene.h"

namespace murosimf::scene {
namespace {

using namespace std::chrono_literals;

SceneOptions options(std::optional<std::uint64_t> seed = {}) {
  SceneOptions how;
  how.seed = seed;
  return how;
}

std::vector<std::string> events_of(const Scene& scene) {
  std::vector<std::string> texts;
  for (const Event& event : scene.simulation().events()) texts.push_back(event.text);
  return texts;
}

void expect_equal(Scene& scene, Scene& fresh, Duration duration) {
  EXPECT_EQ(scene.simulation().now(), Duration{});
  fresh.simulation().initialize();
  EXPECT_EQ(difference(go_on(scene, duration), go_on(fresh, duration)), "");
  EXPECT_EQ(scene.parts().diagnostics.notes(), fresh.parts().diagnostics.notes());
  EXPECT_EQ(scene.parts().diagnostics.warnings(), fresh.parts().diagnostics.warnings());
  EXPECT_EQ(scene.simulation().warnings(), fresh.simulation().warnings());
  EXPECT_EQ(events_of(scene), events_of(fresh));
  for (const auto& entity : fresh.simulation().world().entities()) {
    const Entity& same = scene.simulation().world().entity(entity->name());
    EXPECT_EQ(same.level, entity->level);
    EXPECT_EQ(same.contact, entity->contact);
  }
}

class SceneReset : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Scenes, SceneReset, testing::ValuesIn(all_scenes()),
                         [](const auto& test) { return test.param; });

TEST_P(SceneReset, IsAsNew) {
  Scene scene(GetParam(), options());
  scene.simulation().run(217ms);
  scene.reset();
  Scene fresh(GetParam(), options());
  expect_equal(scene, fresh, 250ms);
}

TEST_P(SceneReset, IsAsNewWithAnotherSeed) {
  Scene scene(GetParam(), options());
  scene.simulation().run(51ms);
  scene.reset(1234);
  Scene fresh(GetParam(), options(1234));
  expect_equal(scene, fresh, 150ms);
}

/// Everything that seeds and events change: places, postures, noise, levels and laws.
constexpr const char* changing = R"(
seed = 7
body_contact = "carry"
[start]
jitter_position = 0.02
jitter_heading_deg = 20
jitter_posture_deg = 3
[ball]
position = [0.16, -0.03]
velocity = [-0.3, 0.1, 0]
[defaults]
model = "kid21"
level = "full_dynamics"
controller = "walk"
command = [0.2, 0, 0.1]
[defaults.sensors.imu]
delay = 0.013
[defaults.sensors.imu.gyroscope]
noise_density = 1e-3
bias = 0.01
bias_random_walk = 1e-3
low_pass = 40
[defaults.sensors.eye]
type = "detector"
offset = 0.005
misses = 0.3
distance_noise = 0.01
[[robots]]
name = "one"
[[robots]]
name = "two"
position = [0.3, 0.05]
heading_deg = 180
[[robots]]
name = "three"
controller = "none"
position = [-1, 0.5]
[[events]]
time = 0.1
set = ["one.level = articulated_dynamics", "two.level = kinematic_walking", "ball.contact = kelvin_voigt"]
[[events]]
time = 0.2
set = ["two.level = simplified_dynamics", "one.contact = kelvin_voigt", "one.servo_law = ideal_pd"]
)";

// Resets between any two exchanges, more than once, to seeds of before and to others.
TEST(SceneResets, GoBackToTheLevelsAndLawsOfTheStart) {
  const std::string file = fixtures::write_scene(changing);
  Scene scene(file, options());
  for (const Duration before : {0ms, 30ms, 130ms, 260ms}) {
    for (const std::uint64_t seed : {7u, 21u}) {
      scene.simulation().run(before);
      scene.reset(seed);
      Scene fresh(file, options(seed));
      expect_equal(scene, fresh, 260ms);
    }
  }
}

TEST(SceneResets, SeedsMatter) {
  const std::string file = fixtures::write_scene(changing);
  Scene scene(file, options());
  scene.simulation().initialize();
  const auto before = hashes_of(scene);
  scene.reset(8);
  const auto after = hashes_of(scene);
  EXPECT_NE(before.at("one position"), after.at("one position"));
  EXPECT_NE(before.at("three joint_position"), after.at("three joint_position"));
  EXPECT_EQ(before.at("ball position"), after.at("ball position"));
}

TEST(SceneResets, HealWhoWasFrozen) {
  const std::string file = fixtures::write_scene(changing);
  Scene scene(file, options()), fresh(file, options());
  scene.simulation().run(20ms);
  scene.simulation().world().entity("two").freeze("a test");
  scene.simulation().run(20ms);
  scene.reset();
  EXPECT_FALSE(scene.simulation().world().entity("two").frozen());
  expect_equal(scene, fresh, 50ms);
}

TEST(SceneResets, ForgetCallsOfTheLifeBefore) {
  Scene scene(fixtures::write_scene(changing), options());
  scene.simulation().run(10ms);
  int calls = 0;
  scene.simulation().at(20ms, [&] { ++calls; });
  scene.reset();
  scene.simulation().run(50ms);
  EXPECT_EQ(calls, 0);
}

}  // namespace
}  // namespace murosimf::scene
